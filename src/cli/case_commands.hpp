// The commands that take or make a case: run, steady, check, init and bench.
#pragma once

#include <string>
#include <vector>

#include "cli/core/dispatch.hpp"

namespace CLI {
class App;
}

namespace softwet {

/// In which units a result is printed: of a case with a table [laboratory] in these, unless the numbers of the case are asked for.
enum class Units { of_the_case, dimensionless };

/// What the command line says of a case and of what is done with it.
struct CaseRequest {
  std::string case_path;
  std::vector<std::string> overrides;
  RunOptions options;
  bool needs = false;  ///< asks what the program has to have for the case
  bool overwrite = false;
  Units units = Units::of_the_case;
  bool resolved = false;              ///< check: print the resolved case alone
  std::string picture;                ///< of the scene, that `check` draws; empty: none
  std::string scene;                  ///< folder for the first state, that `check` writes; empty: none
  std::string along;                  ///< key and values that `steady` follows
  std::string file = "softwet.toml";  ///< that `init` writes
  std::string like = "gel";           ///< scene of that file
};

/// Adds the commands; the request lives as long as they are parsed.
/// @param words  for the program of the folder tools that follows a state along a key
void add_case_commands(CLI::App& app, CaseRequest& request, std::vector<std::string>& words);

}  // namespace softwet
