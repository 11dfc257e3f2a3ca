#include "app/host/fingerprint.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "app/host/case_file.hpp"
#include "case/error.hpp"

namespace softwet {
namespace {

bool starts_with(const std::string& text, const std::string& beginning) { return text.rfind(beginning, 0) == 0; }

/// What a resumed run may change.
bool may_change(const std::string& key) {
  if (starts_with(key, "name") || starts_with(key, "output.") || starts_with(key, "solver.")) return true;
  return starts_with(key, "time.") && !starts_with(key, "time.scheme") && !starts_with(key, "time.rho_inf");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string key_of(const std::string& line) { return line.substr(0, line.find(" = ")); }
std::string value_of(const std::string& line) {
  const std::size_t place = line.find(" = ");
  return place == std::string::npos ? line : line.substr(place + 3);
}

}  // namespace

std::string fingerprint(const Case& c) {
  std::string text, table;
  int entry = 0;
  for (const std::string& line : lines_of(write_case(c))) {
    if (line.empty() || line[0] == '#') continue;
    if (line[0] == '[') {
      const bool repeated = line[1] == '[';
      const std::string name = repeated ? line.substr(2, line.find(']') - 2) : line.substr(1, line.find(']') - 1);
      entry = repeated && starts_with(table, name + "[") ? entry + 1 : 0;
      table = repeated ? name + "[" + std::to_string(entry) + "]." : name + ".";
    } else if (!may_change(table + line)) {
      text += table + line + "\n";
    }
  }
  return text;
}

void check_fingerprint(const std::string& path, const std::string& stored, const Case& c) {
  const std::vector<std::string> then = lines_of(stored), now = lines_of(fingerprint(c));
  const std::string remedy = "; resume with the case of the checkpoint, or start anew in another folder with --out";
  const auto refuse = [&](const std::string& difference) {
    throw Error(Exit::invalid_input, path + ": the checkpoint belongs to another case: " + difference + remedy);
  };
  for (std::size_t i = 0; i < std::max(then.size(), now.size()); ++i) {
    if (i >= now.size()) refuse(key_of(then[i]) + " was " + value_of(then[i]) + " and is missing now");
    if (i >= then.size()) refuse(key_of(now[i]) + " was not set and is " + value_of(now[i]) + " now");
    if (then[i] == now[i]) continue;
    if (key_of(then[i]) != key_of(now[i]))
      refuse("it had " + key_of(then[i]) + " where this one has " + key_of(now[i]));
    refuse(key_of(now[i]) + " was " + value_of(then[i]) + " and is " + value_of(now[i]) + " now");
  }
}

}  // namespace softwet
