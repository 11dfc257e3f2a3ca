// Options of the commands that programs of the folder tools carry out.
#include "cli/tool_commands.hpp"

#include <CLI/CLI.hpp>

#include "cli/tool.hpp"

namespace softwet {
namespace {

/// Options of a command that a program of the folder tools carries out: collected as words for it.
class ToolOptions {
 public:
  ToolOptions(CLI::App& command, std::vector<std::string>& words) : command_(command), words_(words) {}

  void flag(const std::string& name, const std::string& help) {
    command_.add_flag_callback(
        name, [&words = words_, name] { words.push_back(name); }, help);
  }

  CLI::Option* option(const std::string& name, const std::string& type, const std::string& help) {
    const auto keep = [&words = words_, name](const std::string& value) { words.push_back(name + "=" + value); };
    return command_.add_option_function<std::string>(name, keep, help)->type_name(type);
  }

  CLI::Option* repeatable(const std::string& name, const std::string& type, const std::string& help) {
    return option(name, type, help + "; repeatable")->trigger_on_parse();
  }

  CLI::Option* names(const std::string& name, const std::string& help) {
    const auto keep = [&words = words_](const std::vector<std::string>& values) {
      words.insert(words.end(), values.begin(), values.end());
    };
    return command_.add_option_function<std::vector<std::string>>(name, keep, help)->type_name("");
  }

 private:
  CLI::App& command_;
  std::vector<std::string>& words_;
};

void add_verify(CLI::App& app, std::vector<std::string>& words) {
  CLI::App& command = *app.add_subcommand("verify", "compute cases whose answer is known, and compare");
  ToolOptions tool(command, words);
  tool.names("NAME", "studies to run; default: all");
  tool.flag("--quick", "smaller meshes and fewer points: seconds instead of minutes");
  tool.flag("--list", "list the studies and how long they take");
  tool.option("--out", "DIR", "folder of the results; default: out/verify");
  tool.option("--jobs", "N", "number of runs at once, one thread each; default: 1");
  tool.option("--docs", "DIR", "also write verification.md and verification/ into this folder");
  command.callback([&words] { start_tool({"verify", {"numpy", "scipy", "h5py"}}, words); });
}

void add_sweep(CLI::App& app, std::vector<std::string>& words) {
  CLI::App& command = *app.add_subcommand("sweep", "compute a case for all combinations of some values, with a table");
  ToolOptions tool(command, words);
  tool.names("CASE", "case file, for example cases/tensotaxis_pull_2d.toml")->required()->expected(1);
  tool.repeatable(
      "--vary", "KEY=V1,V2,...",
      "a key and its values, for example --vary substrate.poisson=0,0.15,0.3 or load.force=[0.1,0],[-0.1,0]; "
      "a:b:n means n values from a to b");
  tool.repeatable("--set", "KEY=VALUE", "set a key of the case for all members");
  tool.option("--out", "DIR", "folder of the members and of sweep.csv; default: out/<name of the file>_sweep");
  tool.option("--jobs", "N", "number of members at once, which share the cores; default: 1");
  tool.flag("--retry", "compute failed members again, from their checkpoint where there is one");
  tool.option("--columns", "NAMES", "columns of history.csv whose last values the table gets");
  tool.flag("--dry-run", "check and list the members, write nothing");
  tool.flag("--table", "write sweep.csv, compute nothing");
  tool.option("--slurm", "FILE", "write a Slurm array script that computes the members; compute nothing");
  tool.option("--member", "N", "compute this member only, counted from 0, without sweep.csv");
  command.callback([&words] { start_tool({"sweep", {}}, words); });
}

void add_tradeoff(CLI::App& app, std::vector<std::string>& words) {
  CLI::App& command = *app.add_subcommand("tradeoff", "measure what speed costs in accuracy, setting by setting");
  ToolOptions tool(command, words);
  tool.names("CASE", "case file, for example cases/tensotaxis_pull_2d.toml")->required()->expected(1);
  tool.repeatable(
      "--parameters", "KEY=V1,V2,... or NAMES",
      "settings to try: names, for example tolerance,elements, or a key and its values; default: all names");
  tool.repeatable("--set", "KEY=VALUE", "set a key of the case for all members");
  tool.repeatable("--reference", "KEY=VALUE",
                  "set a key of the reference; default: a tenth of time.tolerance, elements of half the size, "
                  "solver.newton.rtol=1e-8");
  tool.option("--by", "MEASURE", "error of the Pareto front; default: path, or else interface, or else wall");
  tool.option("--cost", "COST", "cost of the Pareto front: seconds (default), or processor, the time on processors");
  tool.option("--combine", "N", "most combinations of settings that did well; default: 6");
  tool.option("--longest", "FACTOR", "end a setting after so many times the seconds of the base; default: 10");
  tool.option("--jobs", "N", "number of members at once, which disturb each other's seconds; default: 1");
  tool.option("--out", "DIR", "folder of the members and of tradeoff.csv; default: out/<name of the file>_tradeoff");
  tool.flag("--dry-run", "check and list the members, write nothing");
  tool.flag("--table", "write the tables, compute nothing");
  command.callback([&words] { start_tool({"tradeoff", {"numpy", "h5py"}}, words); });
}

void add_status(CLI::App& app, std::vector<std::string>& words) {
  CLI::App& command = *app.add_subcommand("status", "print in one line how a run stands");
  ToolOptions(command, words).names("OUT", "output folders of softwet run, or of softwet sweep")->required();
  command.callback([&words] { start_tool({"status", {}}, words); });
}

void add_watch(CLI::App& app, std::vector<std::string>& words) {
  CLI::App& command = *app.add_subcommand("watch", "draw the curves of a run in the terminal until it ends");
  ToolOptions tool(command, words);
  tool.names("OUT", "output folder of softwet run")->required()->expected(1);
  tool.option("--every", "SECONDS", "pause between two pictures; default: 2");
  tool.option("--from", "TIME", "first time of the curves; default: 0 once the run is there");
  tool.flag("--once", "draw once and end");
  command.callback([&words] { start_tool({"watch", {}}, words); });
}

}  // namespace

void add_tool_commands(CLI::App& app, std::vector<std::string>& words) {
  add_verify(app, words);
  add_sweep(app, words);
  add_tradeoff(app, words);
  add_status(app, words);
  add_watch(app, words);
}

}  // namespace softwet
