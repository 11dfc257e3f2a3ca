// history.csv opened again by a resumed run. Input: the step in eight characters, then the file.
//
// Properties: nothing but an Error of bad input comes out; what stays is the header and whole rows of the file up to
// the step, in their order; opening again changes nothing; rows can be added.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "io/table_file.hpp"
#include "property.hpp"

namespace softwet {
namespace {

const std::vector<std::string> columns{"step", "t", "mass"};
const std::string header = "step,t,mass\n";

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Every line of `kept` is a line of `whole`, in the same order, and starts with a step up to the last one.
void check_rows(const std::string& whole, const std::string& kept, double step) {
  require_property(kept.rfind(header, 0) == 0, "the header stays", kept);
  require_property(kept.back() == '\n', "rows are whole", kept);
  std::istringstream file(whole), rows(kept);
  std::string from;
  for (std::string row; std::getline(rows, row);) {
    do {
      require_property(static_cast<bool>(std::getline(file, from)), "a row comes from the file", row);
    } while (from != row);
    if (row + "\n" == header) continue;
    require_property(std::strtod(row.c_str(), nullptr) <= step, "a row is not beyond the step", row);
    require_property(std::count(row.begin(), row.end(), ',') == 2, "a row has a cell for each column", row);
  }
}

}  // namespace
}  // namespace softwet

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace softwet;
  static const ScratchFile scratch(".csv");
  const std::string input(reinterpret_cast<const char*>(data), size);
  const double asked = std::strtod(input.substr(0, 8).c_str(), nullptr), step = std::isfinite(asked) ? asked : 0;
  const std::string whole = size > 8 ? input.substr(8) : "";
  std::ofstream(scratch.path(), std::ios::binary) << whole;
  only_bad_input(scratch.path(), [&] {
    TableFile::append_after(scratch.path(), columns, step);
    const std::string kept = content_of(scratch.path());
    if (!whole.empty()) check_rows(whole, kept, step);
    TableFile again = TableFile::append_after(scratch.path(), columns, step);
    require_property(content_of(scratch.path()) == kept, "opening again changes nothing", kept);
    again.row({{"step", step}, {"t", 0.5}, {"mass", std::nullopt}});
    again.flush();
    require_property(content_of(scratch.path()).size() > kept.size(), "a row is added behind the others", kept);
  });
  return 0;
}
