// Case files and command line assignments. A line "#set KEY=VALUE" of the input is one --set (a comment for TOML).
//
// Properties: nothing but an Error of bad input comes out, its message is short and names its place; an accepted
// case is written and read back to the same text, has the same fingerprint, and its warnings can be printed.
#include <sstream>

#include "casefile/case_file.hpp"
#include "casefile/text/problems.hpp"
#include "property.hpp"
#include "run/host/fingerprint.hpp"

namespace softwet {
namespace {

std::vector<std::string> assignments_of(const std::string& text) {
  const std::string mark = "#set ";
  std::vector<std::string> assignments;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.rfind(mark, 0) == 0) assignments.push_back(line.substr(mark.size()));
  return assignments;
}

void check_accepted(const Case& c) {
  const std::string text = write_case(c);
  try {
    const Case again = parse_case(text, "resolved.toml");
    require_property(write_case(again) == text, "the resolved case reads back as itself", text);
    require_property(fingerprint(again) == fingerprint(c), "the fingerprint stays", text);
    check_fingerprint("checkpoint.h5", fingerprint(c), again);
  } catch (const Error& error) {
    require_property(false, "the resolved case is accepted", error.what() + ("\n" + text));
  }
  for (const std::string& warning : warnings(c)) require_property(!warning.empty(), "a warning says something", text);
}

}  // namespace
}  // namespace softwet

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace softwet;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::vector<std::string> assignments = assignments_of(text);
  constexpr int lines = Problems::most + 1;
  only_bad_input(
      ":", [&] { check_accepted(parse_case(text, "case.toml")); }, lines);
  if (assignments.empty()) return 0;
  only_bad_input(
      ":", [&] { check_accepted(parse_case(text, "case.toml", assignments)); }, lines);
  for (const std::string& assignment : assignments)
    only_bad_input("explain", [&] {
      const std::string key = assignment.substr(0, assignment.find('='));
      require_property(!explain(key).empty(), "explain says something", key);
    });
  return 0;
}
