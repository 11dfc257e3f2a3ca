#include "cli/case_commands.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>

#include "case/case.hpp"
#include "case/error.hpp"
#include "casefile/case_file.hpp"
#include "casefile/formula/profiles.hpp"
#include "casefile/schema/json_schema.hpp"
#include "casefile/text/problems.hpp"
#include "casefile/write/start_cases.hpp"
#include "cli/case_of_request.hpp"
#include "cli/core/dispatch.hpp"
#include "cli/tool.hpp"
#include "field/ranks.hpp"
#include "field/together.hpp"
#include "io/atomic_file.hpp"
#include "machine/memory.hpp"
#include "machine/terminal.hpp"
#include "machine/threads.hpp"
#include "run/host/output_folder.hpp"

namespace softwet {
namespace {

/// Reports what deserves a look.
void warn(const Case& c) {
  if (!ranks::root()) return;
  std::vector<std::string> all = warnings(c);
  for (const std::string& sentence : forecast_case(c)) all.push_back(sentence);
  for (const std::string& warning : all) std::cerr << for_stderr("softwet: warning: " + warning) << "\n";
}

/// Refuses what cannot fit, and reports what deserves a look.
Case examined(const Case& c) {
  require_bytes(c, least_bytes(c));
  warn(c);
  return c;
}

/// All processes read the case, and have to find the same one.
LaboratoryCase load_case(const CaseRequest& request) {
  LaboratoryCase read;
  const Case& c = read.c;
  together([&] {
    read = read_case_of(request);
    examined(c);
  });
  const std::string of_first = ranks::shared(write_case(c));
  together([&] {
    if (write_case(c) != of_first)
      throw Error(Exit::invalid_input, fmt::format("'{}': this process reads another case than the first one; put the "
                                                   "file where all machines see the same one",
                                                   request.case_path));
  });
  return read;
}

/// Refuses what has no state of rest, or none that is found. A scene does not rest under loads that change for ever.
void require_rest(const Case& c) {
  if (!c.time.implicit())
    throw Error(Exit::invalid_input,
                fmt::format("steady: time.scheme = \"{}\" is explicit, and a state of rest is found by "
                            "implicit steps of any length; give --set time.scheme=generalized_alpha",
                            word_of(c.time.scheme)));
  const auto goes = [](const std::vector<Profile>& path) {
    return std::any_of(path.begin(), path.end(), [](const Profile& p) { return p.varies(); });
  };
  for (std::size_t k = 0; k < c.needles.size(); ++k)
    if (goes(c.needles[k].path))
      throw Error(Exit::invalid_input,
                  fmt::format("steady: needle[{0}].path varies in time, and a scene with a needle that moves has no "
                              "state of rest; set it to where it is at one time, for example --set "
                              "'needle[{0}].path=[{1}]'",
                              k, c.dimension() == 2 ? "0.1,0" : "0.1,0,0"));
  for (std::size_t k = 0; k < c.loads.size(); ++k) {
    const bool moves = goes(c.loads[k].path);
    if (!moves && !c.loads[k].factor.varies()) continue;
    throw Error(
        Exit::invalid_input,
        fmt::format("steady: load[{0}].{1} varies in time, and a scene under such a load has no state of rest; set "
                    "it to what it is at one time, for example --set {2}",
                    k, moves ? "path" : "factor",
                    moves ? fmt::format("'load[{}].path=[0.1,0]'", k) : fmt::format("load[{}].factor=1", k)));
  }
}

void run_command(CaseRequest& request) {
  if (request.options.resume && request.overwrite) {
    throw Error(Exit::invalid_input, "--resume continues a result, --overwrite removes it; give one of them");
  }
  const LaboratoryCase read = load_case(request);
  const Case& c = read.c;
  if (request.options.steady) require_rest(c);
  if (read.laboratory && request.units == Units::of_the_case) request.options.laboratory = read.laboratory->scales;
  request.options.out = folder_of(request, c);
  const OldResult old = request.options.resume ? OldResult::resume
                        : request.overwrite    ? OldResult::overwrite
                                               : OldResult::refuse;
  std::optional<OutputFolder> folder;
  // Of several processes the first one has it.
  on_root([&] { folder.emplace(request.options.out, c, old, read.laboratory); });
  request.options.begin = [&folder] {
    if (folder) folder->begin();
  };
  request.options.place = [&] { return folder ? folder->place() : request.options.out; };
  try {
    run_case(c, request.options);
  } catch (...) {
    if (folder) folder->discard();
    throw;
  }
  if (folder) folder->discard();  // of a run that was stopped before its first row
}

/// The first state as an output folder, for those who draw it.
void write_scene(const Case& c, const std::string& path) {
  examined(c);
  OutputFolder folder(path, c, OldResult::refuse);
  try {
    folder.begin();
    write_first_state(c, path);
    write_text_atomically(path + "/profiles.json", profile_samples(c));
  } catch (...) {
    folder.discard();
    throw;
  }
}

void steady_command(CaseRequest& request, std::vector<std::string>& words) {
  request.options.steady = true;
  if (request.along.empty()) return run_command(request);
  if (ranks::count() > 1)
    throw Error(Exit::invalid_input, "steady: --along starts a command for each state; start it as one process");
  words = {request.case_path, "--along=" + request.along};
  for (const std::string& setting : request.overrides) words.push_back("--set=" + setting);
  if (!request.options.out.empty()) words.push_back("--out=" + request.options.out);
  if (request.options.threads > 0) words.push_back("--threads=" + std::to_string(request.options.threads));
  if (request.overwrite) words.push_back("--overwrite");
  start_tool("steady", words);
}

void check_command(const CaseRequest& request) {
  if (std::error_code unknown; std::filesystem::is_directory(request.picture, unknown))
    throw Error(Exit::invalid_input,
                fmt::format("check: --picture '{0}' is a folder; give the name of a file, for example {0}/scene.png",
                            request.picture));
  const auto [c, laboratory] = read_case_of(request);  // larger than this machine, too
  if (!request.scene.empty()) return write_scene(c, request.scene);
  warn(c);
  std::cout << write_case(c) << (laboratory ? laboratory->table : "") << "\n" << std::flush;
  if (request.resolved) return;
  if (laboratory) print_laboratory(laboratory->scales, c, std::cout);
  describe_case(c, std::cout);
  if (const std::string width = judge_width(c); !width.empty())
    std::cerr << for_stderr("softwet: warning: " + width) << "\n";
  if (request.picture.empty()) return;
  std::vector<std::string> words{request.case_path, "--out", request.picture};
  for (const std::string& assignment : request.overrides) words.push_back("--set=" + assignment);
  std::cout << std::flush;
  start_tool("plot", words);
}

void write_text(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  file.close();
  if (file) return;
  throw Error(Exit::machine_failed,
              fmt::format("init: cannot write '{}'; give a file in a folder that exists and is yours", path));
}

/// Behind them comes a case.
std::string first_lines() {
  return fmt::format(
      "#:schema {}\n# softwet check FILE shows what will be computed, softwet run FILE computes it, softwet explain "
      "KEY shows what\n# a key means; tables and keys with defaults may be removed.\n",
      schema_file);
}

/// @param like  the scene: gel, one of the short cases, or pull, which has every key
std::string case_to_start_from(const std::string& like, const std::string& name) {
  if (like == "pull") return initial_case(name);
  return like == "gel" ? gel_case(name) : start_case(like, name);
}

void init_command(const CaseRequest& request) {
  if (std::filesystem::exists(request.file)) {
    throw Error(Exit::invalid_input, fmt::format("init: '{}' exists and stays as it is; give another name, for example "
                                                 "'softwet init my_case.toml'",
                                                 request.file));
  }
  const std::filesystem::path path = request.file, rules = path.parent_path() / schema_file;
  write_text(request.file, first_lines() + case_to_start_from(request.like, path.stem().string()));
  write_text(rules.string(), json_schema());
  fmt::print("wrote {}, and {} for editors; next: softwet check {}\n", request.file, rules.string(), request.file);
}

CLI::Option* add_case(CLI::App& command, CaseRequest& request) {
  CLI::Option* option =
      command.add_option("CASE", request.case_path, "case file, for example cases/tensotaxis_pull_2d.toml");
  command
      .add_option_function<std::string>(
          "--set", [&request](const std::string& assignment) { request.overrides.push_back(assignment); },
          "set a key of the case, for example --set time.end=10 or --set load[0].ramp=2, or a whole table: --set "
          "'substrate.gel={ exponent = 0.5, time = 1 }'; repeatable")
      ->type_name("KEY=VALUE")
      ->trigger_on_parse();
  return option->required();
}

void add_threads(CLI::App& command, CaseRequest& request) {
  command
      .add_option("--threads", request.options.threads,
                  "number of threads; default: OMP_NUM_THREADS, else all cores that the system grants")
      ->type_name("N")
      ->check(CLI::Range(1, most_threads));
}

/// Units of the numbers that are printed at the end.
void add_units(CLI::App& command, CaseRequest& request) {
  const auto keep = [&request](const std::string& text) {
    if (text != "laboratory" && text != "dimensionless")
      reject("command line", "--units", text, "must be laboratory or dimensionless",
             "leave it out for the units of the laboratory where the case has a table [laboratory]");
    request.units = text == "laboratory" ? Units::of_the_case : Units::dimensionless;
  };
  command
      .add_option_function<std::string>("--units", keep,
                                        "units of the result on the terminal: laboratory (default), where the case has "
                                        "a table [laboratory], or dimensionless")
      ->type_name("UNITS");
}

void add_run(CLI::App& app, CaseRequest& request) {
  CLI::App& command = *app.add_subcommand("run", "compute a case and write its output folder");
  add_case(command, request);
  command.add_option("--out", request.options.out, "output folder; default: out/<name of the case>")->type_name("DIR");
  command.add_flag("--resume", request.options.resume, "continue from the checkpoint in the output folder");
  command.add_flag("--overwrite", request.overwrite, "replace the result in the output folder");
  add_threads(command, request);
  command.add_flag("--quiet", request.options.quiet, "no progress line");
  add_units(command, request);
  command.add_flag("--needs", request.needs,
                   "print which configuration of the program the case needs and whether this "
                   "build has it, and compute nothing");
  command.callback([&request] {
    if (request.needs)
      fmt::print("{}\n", configuration_line(read_case_of(request).c));
    else
      run_command(request);
  });
}

/// A state that is followed along a key is a chain of such commands, which a program of the folder tools starts.
void add_steady(CLI::App& app, CaseRequest& request, std::vector<std::string>& words) {
  CLI::App& command = *app.add_subcommand("steady", "find the state of rest of a case, also along a key");
  add_case(command, request);
  command
      .add_option("--along", request.along,
                  "follow the state along a key: KEY=a:b:n means n values from a to b, a:b:n:log the same with equal "
                  "ratios, V1,V2,... these values")
      ->type_name("KEY=VALUES");
  command
      .add_option("--out", request.options.out,
                  "output folder; default: out/<name of the case>_steady, with --along out/<name of the file>_along")
      ->type_name("DIR");
  command.add_flag("--overwrite", request.overwrite, "replace the result in the output folder");
  add_threads(command, request);
  command.add_flag("--quiet", request.options.quiet, "no progress");
  add_units(command, request);
  command.callback([&request, &words] { steady_command(request, words); });
}

void add_bench(CLI::App& app, CaseRequest& request) {
  CLI::App& command =
      *app.add_subcommand("bench", "measure residuals and products of a case; default: the case of 'init --like pull'");
  CLI::Option* given = add_case(command, request)->required(false);
  add_threads(command, request);
  command.add_flag("--preconditioners", request.options.preconditioners,
                   "compare forms of the preconditioner instead: times, and iterations for several time steps");
  command.callback([&request, given] {
    const Case c = given->count() > 0
                       ? load_case(request).c
                       : examined(parse_case(initial_case("bench"), "the case of init --like pull", request.overrides));
    std::ostream nowhere(nullptr);
    bench_case(c, request.options, ranks::root() ? std::cout : nowhere);
  });
}

void add_check(CLI::App& app, CaseRequest& request) {
  CLI::App& command =
      *app.add_subcommand("check", "print the resolved case, its terms, unknowns, memory and step limits");
  add_case(command, request);
  CLI::Option* picture = command.add_option("--picture", request.picture,
                                            "also draw the scene, into a file that ends with .png, .pdf or .svg");
  picture->type_name("FILE");
  CLI::Option* resolved =
      command.add_flag("--resolved", request.resolved, "print the resolved case alone, as a case file");
  CLI::Option* scene = command.add_option("--scene", request.scene,
                                          "print nothing, but write the first state as an output folder, for programs "
                                          "that draw it");
  scene->type_name("DIR")->excludes(picture)->excludes(resolved);
  resolved->excludes(picture);
  command.callback([&request] { check_command(request); });
}

void add_init(CLI::App& app, CaseRequest& request) {
  CLI::App& command = *app.add_subcommand("init", "write a commented case to start from");
  command.add_option("FILE", request.file, "file to write; default: softwet.toml")->type_name("");
  std::vector<std::string> scenes = start_cases();
  scenes.insert(scenes.begin(), "gel");
  scenes.emplace_back("pull");
  command
      .add_option(
          "--like", request.like,
          fmt::format("scene: {}; default: gel, a droplet of water on a gel, in micrometres; pull is the paper's, "
                      "with every key",
                      fmt::join(scenes, ", ")))
      ->check(CLI::IsMember(scenes))
      ->type_name("SCENE");
  command.callback([&request] { init_command(request); });
}

}  // namespace

void add_case_commands(CLI::App& app, CaseRequest& request, std::vector<std::string>& words) {
  add_run(app, request);
  add_steady(app, request, words);
  add_check(app, request);
  add_init(app, request);
  add_bench(app, request);
}

}  // namespace softwet
