#include "run/host/fingerprint.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

#include "case/error.hpp"
#include "casefile/case_file.hpp"
#include "casefile/formula/profiles.hpp"
#include "casefile/schema/schema.hpp"

namespace softwet {
namespace {

bool starts_with(const std::string& text, const std::string& beginning) { return text.rfind(beginning, 0) == 0; }

std::string key_of(const std::string& line) { return line.substr(0, line.find(" = ")); }
std::string value_of(const std::string& line) {
  const std::size_t place = line.find(" = ");
  return place == std::string::npos ? line : line.substr(place + 3);
}

bool is_one_of(const std::string& key, const std::vector<std::string>& keys) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

bool of_solver(const std::string& line) { return starts_with(line, "solver."); }

/// What a resumed run may change.
bool may_change(const std::string& line) {
  static const std::vector<std::string> keys{"name",        "time.end",    "time.max_steps", "time.dt_initial",
                                             "time.dt_min", "time.dt_max", "time.tolerance", "time.wall_clock"};
  return starts_with(line, "output.") || of_solver(line) || is_one_of(key_of(line), keys);
}
constexpr const char* may_change_text =
    "only the name, output, solver, time.end, time.max_steps, time.wall_clock, time.tolerance and time.dt_* may change";

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The lines "table.key = value" of a case that are wanted.
template <class Wanted>
std::string lines_of_case(const Case& c, const Wanted& wanted) {
  std::string text, table;
  int entry = 0;
  for (const std::string& line : lines_of(write_case(with_identities(c)))) {
    if (line.empty() || line[0] == '#') continue;
    if (line[0] == '[') {
      const bool repeated = line[1] == '[';
      const std::string name = repeated ? line.substr(2, line.find(']') - 2) : line.substr(1, line.find(']') - 1);
      entry = repeated && starts_with(table, name + "[") ? entry + 1 : 0;
      table = repeated ? name + "[" + std::to_string(entry) + "]." : name + ".";
    } else if (wanted(table + line)) {
      text += table + line + "\n";
    }
  }
  return text;
}

/// "load[].factor" of "load[0].factor".
std::string schema_name(const std::string& key) {
  const std::size_t open = key.find('['), close = key.find(']');
  return open == std::string::npos ? key : key.substr(0, open + 1) + key.substr(close);
}

/// Whether a line may be missing in the fingerprint of an older program, which did not know the key: the line says what
/// that program did. For the first three keys an older program had another default, or none.
bool may_be_missing(const std::string& line) {
  static const std::vector<std::string> of_any_value{"time.mass", "time.safety", "time.start"};
  const Key* key = find_key(schema_name(key_of(line)));
  return is_one_of(key_of(line), of_any_value) || (key && !key->required && value_of(line) == default_text(*key));
}

/// The lines of a case that a stored fingerprint can have: fingerprints of older programs lack some keys.
std::vector<std::string> lines_to_compare(const Case& c, const std::vector<std::string>& stored) {
  std::vector<std::string> lines, known;
  for (const std::string& line : stored) known.push_back(key_of(line));
  for (const std::string& line : lines_of(fingerprint(c)))
    if (is_one_of(key_of(line), known) || !may_be_missing(line)) lines.push_back(line);
  return lines;
}

}  // namespace

std::string fingerprint(const Case& c) {
  return lines_of_case(c, [](const std::string& line) { return !may_change(line); });
}

std::string solver_settings(const Case& c) { return lines_of_case(c, of_solver); }

void check_fingerprint(const std::string& path, const std::string& stored, const Case& c) {
  const std::vector<std::string> then = lines_of(stored), now = lines_to_compare(c, then);
  const auto refuse = [&](const std::string& difference) {
    throw Error(Exit::invalid_input,
                path + ": the checkpoint belongs to another case: " + difference + " (" + may_change_text +
                    "); resume with the case of the checkpoint, or start anew in another folder with --out");
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
