// history.csv opened again by a resumed run. Input: how much of the file belongs to the checkpoint, one byte of it that
// changes, then the file.
//
// Properties: nothing but an Error of bad input comes out; what stays is what the checkpoint knows; opening again
// changes nothing; rows can be added.
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

}  // namespace
}  // namespace softwet

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace softwet;
  static const ScratchFile scratch(".csv");
  const std::string input(reinterpret_cast<const char*>(data), size);
  if (input.size() < 2) return 0;
  const std::string whole = input.substr(2), kept = whole.substr(0, static_cast<unsigned char>(input[0]));
  TableMark mark;
  mark.add(kept);
  mark.rows = std::max<std::int64_t>(0, mark.rows - 1);  // without the header
  std::string found = whole;
  if (input[1] != 0 && !found.empty()) found[static_cast<unsigned char>(input[1]) % found.size()] ^= 1;
  std::ofstream(scratch.path(), std::ios::binary) << found;
  only_bad_input(scratch.path(), [&] {
    TableFile::append_after(scratch.path(), columns, mark);
    const std::string after = content_of(scratch.path());
    require_property(after == (found.empty() ? header : kept), "what the checkpoint knows stays", after);
    TableFile again = TableFile::append_after(scratch.path(), columns, mark);
    require_property(content_of(scratch.path()) == after, "opening again changes nothing", after);
    again.row({{"step", 1e9}, {"t", 0.5}, {"mass", std::nullopt}});
    again.flush();
    require_property(content_of(scratch.path()).size() > after.size(), "a row is added behind the others", after);
  });
  return 0;
}
