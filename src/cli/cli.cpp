// The command line: its commands, and how it ends.
#include "cli/cli.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <new>
#include <softwet_version.hpp>
#include <sstream>

#include "case/error.hpp"
#include "casefile/case_file.hpp"
#include "casefile/schema/json_schema.hpp"
#include "casefile/schema/nearest.hpp"
#include "casefile/write/column_text.hpp"
#include "cli/app_parts.hpp"
#include "cli/case_commands.hpp"
#include "cli/core/dispatch.hpp"
#include "cli/units_command.hpp"
#include "field/ranks.hpp"
#include "io/path_state.hpp"
#include "machine/launcher.hpp"
#include "machine/terminal.hpp"

namespace softwet {
namespace {

/// What the command line may say, for all commands.
struct Request {
  CaseRequest of_case;
  std::string key;
  bool markdown = false;
  bool json = false;
  bool json_schema = false;
  std::string command;  ///< of which help is wanted
  std::string shell;    ///< whose completion is wanted
  PhysicalScene physical;
  WrittenCase written;
  std::vector<std::string> words;  ///< what a program of the folder tools gets as it is
};

void add_explain(CLI::App& app, Request& request) {
  CLI::App& command =
      *app.add_subcommand("explain", "show the meaning of the keys of a case and of the columns of its tables");
  CLI::Option* key =
      command.add_option("TOPIC", request.key,
                         "a key, a table or a column: fluid.viscosity, load, history, history.mass; default: all keys");
  CLI::Option* page =
      command.add_flag("--markdown", request.markdown, "print all keys and columns as a page of Markdown");
  CLI::Option* columns =
      command.add_flag("--json", request.json, "print names, units and meanings of all columns as JSON");
  CLI::Option* rules = command.add_flag("--json-schema", request.json_schema,
                                        "print the rules of a case file as JSON Schema, for editors");
  page->excludes(key);
  rules->excludes(key)->excludes(page);
  columns->excludes(key)->excludes(page)->excludes(rules);
  command.callback([&request] {
    std::cout << (request.markdown      ? reference_page()
                  : request.json        ? columns_json()
                  : request.json_schema ? softwet::json_schema()
                                        : explain(request.key));
  });
}

/// Reports an error. Where all processes end with it the first one speaks for them. One that fails alone ends the others.
int report(Exit code, const std::string& problem) {
  std::cout << std::flush;
  const bool alone = !ranks::root() && !ranks::all_end();
  if (!ranks::root() && !alone) return static_cast<int>(code);
  const std::string message = alone ? fmt::format("process {}: {}", ranks::mine(), problem) : problem;
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) std::cerr << for_stderr("softwet: error: " + line) << "\n";
  if (alone || !ranks::all_end()) ranks::abort(static_cast<int>(code));
  return static_cast<int>(code);
}

/// A word that should be a command and is none gets the nearest command as an answer.
void check_command_name(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), word) != names.end()) return;
  const std::string nearest = nearest_name(word, names);
  const std::string meant = nearest.empty() ? "" : fmt::format("did you mean 'softwet {}'? ", nearest);
  throw Error(Exit::invalid_input,
              fmt::format("unknown command '{}'; {}'softwet --help' lists all commands", word, meant));
}

/// "did you mean --threads? " for the first option of the command line that its command does not have.
std::string meant_option(const CLI::App& app, int argc, const char* const* argv) {
  if (app.get_subcommands().empty()) return {};
  const CLI::App& command = *app.get_subcommands().front();
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i], option = word.substr(0, word.find('='));
    if (option.rfind("--", 0) != 0 || command.get_option_no_throw(option)) continue;
    std::vector<std::string> names;
    for (const CLI::Option* known : command.get_options())
      for (const std::string& name : known->get_lnames()) names.push_back(name);
    const std::string nearest = nearest_name(option.substr(2), names);
    return nearest.empty() ? "" : fmt::format("did you mean --{}? ", nearest);
  }
  return {};
}

/// "'load.ramp=2' stands alone: ..." for the first assignment that no option takes: --set is missing before it, or the shell made
/// two words of one, as bash does with {a=1,b=2}.
std::string stray_assignment(int argc, const char* const* argv) {
  for (int i = 2; i < argc; ++i) {
    const std::string word = argv[i], before = argv[i - 1];
    const bool is_value = before.rfind("--", 0) == 0 && before.find('=') == std::string::npos;
    const auto equals = word.find('=');
    if (word.rfind("--", 0) == 0 || is_value || equals == std::string::npos || equals == 0) continue;
    return fmt::format(
        "'{0}' stands alone: write --set before it, and single quotes around what has braces, brackets or "
        "blanks, --set '{0}', so that the shell leaves it whole; ",
        word);
  }
  return {};
}

std::string version_line() { return fmt::format("softwet {} ({})", version, commit); }

void help_command(const CLI::App& app, const std::string& command) {
  if (!command.empty()) check_command_name(app, command);
  std::cout << (command.empty() ? app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal)
                                : app.get_subcommand(command)->help(app.get_name()));
}

/// Commands that describe the program itself.
void add_answers(CLI::App& app, Request& request) {
  app.add_subcommand("info", "print version, backend and compiled configurations")->callback([] {
    describe_build(std::cout);
  });
  app.add_subcommand("version", "print version and commit")->callback([] { std::cout << version_line() << "\n"; });

  CLI::App& help = *app.add_subcommand("help", "list the commands, or the options of one command");
  help.add_option("COMMAND", request.command, "command to explain; default: all commands in a line each")
      ->type_name("");
  help.callback([&app, &request] { help_command(app, request.command); });

  app.add_subcommand("man", "print the manual page, for 'softwet man | man -l -'")->callback([&app] {
    std::cout << manual_page(app);
  });
  CLI::App& completion =
      *app.add_subcommand("completion", "print the completion of a shell, for 'source <(softwet completion bash)'");
  completion.add_option("SHELL", request.shell, "name of the shell; there is one for bash")
      ->required()
      ->check(CLI::IsMember({"bash"}))
      ->type_name("");
  completion.callback([&app] { std::cout << bash_completion(app); });
}

/// Refuses several processes where they would not compute together: each would compute the whole, alone.
void check_processes(int argc, const char* const* argv) {
  const std::string command = argc < 2 ? "" : argv[1];
  const bool computes = command == "run" || command == "steady" || command == "bench";
  if (ranks::count() > 1 && !computes)
    throw Error(
        Exit::invalid_input,
        "several processes compute with 'softwet run', 'softwet steady' and 'softwet bench' alone; start this command "
        "by itself");
  if (ranks::count() > 1 || !computes) return;
  const LaunchSign found = sign_of_several_processes();
  if (found.sign.empty()) return;
  const char* remedy = ranks::has_mpi()
                           ? "but MPI knows of this one alone: start softwet with the launcher of the MPI it was built "
                             "with (with srun: --mpi, see 'srun --mpi=list')"
                           : "but this program was built without MPI: start one process with more --threads, or build "
                             "softwet with -DSOFTWET_MPI=ON (preset mpi)";
  throw Error(
      Exit::invalid_input,
      fmt::format("started as one of several processes ({}), {}; where each process computes a case of its own, "
                  "start it with 'env {} softwet {} ...'",
                  found.sign, remedy, found.unset, command));
}

/// What a command prints may go to a file, on a disk that is full.
void require_printed() {
  if (std::cout.flush() && std::fflush(stdout) == 0) return;
  throw Error(Exit::machine_failed,
              "the output cannot be written; free space on that disk, or print to "
              "another place");
}

int parse(CLI::App& app, int argc, const char* const* argv) {
  if (argc >= 2 && argv[1][0] != '-') check_command_name(app, argv[1]);
  try {
    app.parse(argc, argv);
    require_printed();
    return static_cast<int>(Exit::done);
  } catch (const CLI::Success& help) {
    const int code = app.exit(help);
    require_printed();
    return code;
  } catch (const CLI::ParseError& error) {
    std::string message = error.what();
    for (char& c : message) c = c == '\n' ? ' ' : c;
    return report(Exit::invalid_input, message + "; " + meant_option(app, argc, argv) + stray_assignment(argc, argv) +
                                           "'softwet --help' and 'softwet COMMAND --help' show what there is");
  }
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  CLI::App app("softwet: droplets on soft solids (Navier-Stokes-Korteweg and Saint Venant-Kirchhoff).", "softwet");
  app.footer(
      "Start:  softwet init my_case.toml;  softwet check my_case.toml;  softwet run my_case.toml\n"
      "Exit codes: 0 done, 1 the case or the command line is wrong, 2 the computation failed,\n"
      "            3 the machine failed (disk, memory, device).");
  app.set_version_flag("--version", version_line(), "print version and commit");
  app.require_subcommand(1);
  Request request;
  add_case_commands(app, request.of_case, request.words);
  add_explain(app, request);
  add_units_command(app, request.physical, request.written);
  add_tool_commands(app, request.words);
  add_answers(app, request);
  try {
    check_processes(argc, argv);
    return parse(app, argc, argv);
  } catch (const Error& error) {
    return report(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return report(Exit::machine_failed, "out of memory; 'softwet check CASE' shows how much a case needs");
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string problem = too_long(error.path1().string());
    if (problem.empty()) return report(Exit::machine_failed, error.what());
    return report(Exit::invalid_input, fmt::format("'{}': {}; give a shorter one", error.path1().string(), problem));
  } catch (const std::exception& error) {
    return report(Exit::computation_failed, error.what());
  }
}

}  // namespace softwet
