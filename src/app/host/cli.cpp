// Commands of softwet and their options.
#include "app/host/cli.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <optional>
#include <softwet_version.hpp>
#include <sstream>

#include "app/dispatch.hpp"
#include "app/host/case_file.hpp"
#include "app/host/column_text.hpp"
#include "app/host/completion.hpp"
#include "app/host/manual.hpp"
#include "app/host/memory.hpp"
#include "app/host/nearest.hpp"
#include "app/host/output_folder.hpp"
#include "app/host/tool_commands.hpp"
#include "app/host/units_command.hpp"
#include "case/case.hpp"
#include "case/error.hpp"
#include "field/ranks.hpp"

namespace softwet {
namespace {

/// What the command line may say, for all commands.
struct Request {
  std::string case_path;
  std::vector<std::string> overrides;
  RunOptions options;
  bool overwrite = false;
  std::string key;
  bool markdown = false;
  std::string file = "softwet.toml";
  std::string command;  ///< of which help is wanted
  std::string shell;    ///< whose completion is wanted
  PhysicalScene physical;
  std::vector<std::string> words;  ///< what a program of the folder tools gets as it is
};

/// Tells what deserves a look.
void warn(const Case& c) {
  std::vector<std::string> all = warnings(c);
  for (const std::string& sentence : forecast_case(c)) all.push_back(sentence);
  if (!ranks::root()) return;
  for (const std::string& warning : all) std::cerr << "softwet: warning: " << warning << "\n";
}

/// Refuses what cannot fit, and tells what deserves a look.
Case examined(const Case& c) {
  require_bytes(c, least_bytes(c));
  warn(c);
  return c;
}

Case load_case(const Request& request) { return examined(read_case(request.case_path, request.overrides)); }

/// Of several processes the first one has the folder. What it is refused ends all.
void open_on_root(std::optional<OutputFolder>& folder, const std::string& path, const Case& c, OldResult old) {
  Exit code = Exit::done;
  std::string refusal;
  try {
    if (ranks::root()) folder.emplace(path, c, old);
  } catch (const Error& error) {
    code = error.code();
    refusal = error.what();
  }
  code = static_cast<Exit>(ranks::of_root(static_cast<int>(code)));
  if (code != Exit::done) throw Error(code, refusal);
}

void run_command(Request& request) {
  if (request.options.resume && request.overwrite) {
    throw Error(Exit::invalid_input, "--resume continues a result, --overwrite removes it; give one of them");
  }
  const Case c = load_case(request);
  if (request.options.out.empty()) request.options.out = "out/" + c.name;
  const OldResult old = request.options.resume ? OldResult::resume
                        : request.overwrite    ? OldResult::overwrite
                                               : OldResult::refuse;
  std::optional<OutputFolder> folder;
  open_on_root(folder, request.options.out, c, old);
  request.options.begin = [&folder] {
    if (folder) folder->begin();
  };
  try {
    run_case(c, request.options);
  } catch (...) {
    if (folder) folder->discard();
    throw;
  }
}

void check_command(const Request& request) {
  const Case c = read_case(request.case_path, request.overrides);  // larger than this machine, too
  warn(c);
  std::cout << write_case(c) << "\n" << std::flush;
  describe_case(c, std::cout);
}

void init_command(const Request& request) {
  if (std::filesystem::exists(request.file)) {
    throw Error(Exit::invalid_input, fmt::format("init: '{}' exists and stays as it is; give another name, for example "
                                                 "'softwet init my_case.toml'",
                                                 request.file));
  }
  const std::string text = initial_case(std::filesystem::path(request.file).stem().string());
  std::ofstream file(request.file);
  file << text;
  file.close();
  if (!file) {
    throw Error(Exit::machine_failed, fmt::format("init: cannot write '{}'; give a file in a folder that exists and is "
                                                  "yours",
                                                  request.file));
  }
  fmt::print("wrote {}; next: softwet check {}\n", request.file, request.file);
}

CLI::Option* add_case(CLI::App& command, Request& request) {
  CLI::Option* option =
      command.add_option("CASE", request.case_path, "case file, for example cases/tensotaxis_pull_2d.toml");
  command
      .add_option_function<std::string>(
          "--set", [&request](const std::string& assignment) { request.overrides.push_back(assignment); },
          "set a key of the case, for example --set time.end=10 or --set load[0].ramp=2; repeatable")
      ->type_name("KEY=VALUE")
      ->trigger_on_parse();
  return option->required();
}

void add_threads(CLI::App& command, Request& request) {
  command.add_option("--threads", request.options.threads, "number of threads; default: all cores")
      ->type_name("N")
      ->check(CLI::Range(1, 65536));
}

void add_run(CLI::App& app, Request& request) {
  CLI::App& command = *app.add_subcommand("run", "compute a case and write its output folder");
  add_case(command, request);
  command.add_option("--out", request.options.out, "output folder; default: out/<name of the case>")->type_name("DIR");
  command.add_flag("--resume", request.options.resume, "continue from the checkpoint in the output folder");
  command.add_flag("--overwrite", request.overwrite, "replace the result in the output folder");
  add_threads(command, request);
  command.add_flag("--quiet", request.options.quiet, "no progress line");
  command.callback([&request] { run_command(request); });
}

void add_bench(CLI::App& app, Request& request) {
  CLI::App& command = *app.add_subcommand("bench", "measure residuals and products of a case; default: that of 'init'");
  CLI::Option* given = add_case(command, request)->required(false);
  add_threads(command, request);
  command.add_flag("--preconditioners", request.options.preconditioners,
                   "compare forms of the preconditioner instead: times, and iterations for several time steps");
  command.callback([&request, given] {
    const Case c = given->count() > 0
                       ? load_case(request)
                       : examined(parse_case(initial_case("bench"), "the case of init", request.overrides));
    std::ostream nowhere(nullptr);
    bench_case(c, request.options, ranks::root() ? std::cout : nowhere);
  });
}

void add_explain(CLI::App& app, Request& request) {
  CLI::App& command =
      *app.add_subcommand("explain", "tell the meaning of the keys of a case and of the columns of its tables");
  CLI::Option* key =
      command.add_option("TOPIC", request.key,
                         "a key, a table or a column: fluid.viscosity, load, history, history.mass; default: all keys");
  command.add_flag("--markdown", request.markdown, "print all keys and columns as a page of Markdown")->excludes(key);
  command.callback([&request] { std::cout << (request.markdown ? reference_page() : explain(request.key)); });
}

void add_commands(CLI::App& app, Request& request) {
  add_run(app, request);
  CLI::App& check =
      *app.add_subcommand("check", "print the resolved case, its terms, unknowns, memory and step limits");
  add_case(check, request);
  check.callback([&request] { check_command(request); });

  add_explain(app, request);

  CLI::App& init = *app.add_subcommand("init", "write a commented case to start from");
  init.add_option("FILE", request.file, "file to write; default: softwet.toml")->type_name("");
  init.callback([&request] { init_command(request); });

  add_bench(app, request);
  add_units_command(app, request.physical);
  add_tool_commands(app, request.words);
}

/// Tells an error. Where all processes end with it the first one speaks for them. One that fails alone ends the others.
int report(Exit code, const std::string& problem) {
  std::cout << std::flush;
  const bool alone = !ranks::root() && !ranks::all_end();
  if (!ranks::root() && !alone) return static_cast<int>(code);
  const std::string message = alone ? fmt::format("process {}: {}", ranks::mine(), problem) : problem;
  std::istringstream lines(message);
  for (std::string line; std::getline(lines, line);) std::cerr << "softwet: error: " << line << "\n";
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

std::string version_line() { return fmt::format("softwet {} ({})", version, commit); }

void help_command(const CLI::App& app, const std::string& command) {
  if (!command.empty()) check_command_name(app, command);
  std::cout << (command.empty() ? app.get_formatter()->make_help(&app, app.get_name(), CLI::AppFormatMode::Normal)
                                : app.get_subcommand(command)->help(app.get_name()));
}

/// Commands that tell of the program itself.
void add_answers(CLI::App& app, Request& request) {
  app.add_subcommand("info", "tell version, backend and compiled configurations")->callback([] {
    describe_build(std::cout);
  });
  app.add_subcommand("version", "tell version and commit")->callback([] { std::cout << version_line() << "\n"; });

  CLI::App& help = *app.add_subcommand("help", "tell the commands, or the options of one command");
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

/// Refuses several processes where they would not compute together.
void check_processes(int argc, const char* const* argv) {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* count = std::getenv(name);
    if (!ranks::has_mpi() && count && std::atoi(count) > 1)
      throw Error(Exit::invalid_input,
                  "started as one of several processes, but this program was built without MPI; build it with "
                  "-DSOFTWET_MPI=ON (preset mpi)");
  }
  if (ranks::count() > 1 && (argc < 2 || (std::string(argv[1]) != "run" && std::string(argv[1]) != "bench")))
    throw Error(Exit::invalid_input,
                "several processes compute with 'softwet run' and 'softwet bench' alone; start this command by itself");
}

int parse(CLI::App& app, int argc, const char* const* argv) {
  if (argc >= 2 && argv[1][0] != '-') check_command_name(app, argv[1]);
  try {
    app.parse(argc, argv);
    return static_cast<int>(Exit::done);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    std::string message = error.what();
    for (char& c : message) c = c == '\n' ? ' ' : c;
    return report(Exit::invalid_input, message + "; " + meant_option(app, argc, argv) +
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
  add_commands(app, request);
  add_answers(app, request);
  try {
    check_processes(argc, argv);
    return parse(app, argc, argv);
  } catch (const Error& error) {
    return report(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return report(Exit::machine_failed, "out of memory; 'softwet check CASE' tells how much a case needs");
  } catch (const std::filesystem::filesystem_error& error) {
    return report(Exit::machine_failed, error.what());
  } catch (const std::exception& error) {
    return report(Exit::computation_failed, error.what());
  }
}

}  // namespace softwet
