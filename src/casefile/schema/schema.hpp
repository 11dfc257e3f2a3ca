// The schema: every key of a case file, once. It feeds the reader, `explain`, `init`, `--set` and the writer.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "case/profile.hpp"
#include "casefile/schema/value.hpp"

namespace softwet {

enum class Kind { number, integer, text, choice, numbers, integers, box, times, names, profile, profiles };

/// Where a profile is evaluated: on the solid or the fluid, on the wall between them, or over the time of a load.
enum class Support { solid, fluid, wall, time };

/// Allowed interval of a number, or of each number of a list. Always finite numbers.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = true;
  bool high_open = true;

  bool contains(double number) const;
  std::string text() const;  ///< "(0, 180)", "[0.3, 1)"; empty when every number is allowed
};
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr Range positive{0, infinity, true, true};
/// Sizes of numbers other than 0, so that products of several inputs (h^4, 1 / dt^2) stay numbers.
inline constexpr double smallest_number = 1e-30, largest_number = 1e30;
/// How many entries a list may have with one for each axis, and where it may be left empty.
inline std::vector<std::size_t> of_axes() { return {2, 3}; }
inline std::vector<std::size_t> of_axes_or_none() { return {0, 2, 3}; }

/// One table of a case file. `present` and `count` see the resolved case; `open` makes room for entry number i.
struct Table {
  std::string name;  ///< "fluid", "droplet[]"; "" is the top of the file
  std::string help{};
  bool repeated = false;
  bool in_example = true;                  ///< part of the case that `init` writes
  std::size_t (*count)(const Case&);       ///< entries a case has: 0 or 1, any number when repeated
  void (*open)(Case&, std::size_t index);  ///< grows the case so that entry `index` exists
  std::string notes{};                     ///< what `explain` prints below the help, in lines
};

/// How a key reads and writes its place in a Case; `index` counts the entries of a repeated table.
struct Binding {
  std::function<void(Case&, std::size_t index, const Value&)> set;
  std::function<Value(const Case&, std::size_t index)> get;
  /// The profiles that the case has there: one, one for each axis, or none. Empty for keys of other kinds.
  std::function<std::vector<Profile*>(Case&, std::size_t index)> profiles{};
};

/// A choice that earlier versions had.
struct FormerChoice {
  std::string word, now, reason;  ///< what to write instead of it, and why that does as well: "lu computes ..."
};

struct Key {
  std::string name{};  ///< dotted, "solver.newton.rtol", "droplet[].radius"
  Kind kind = Kind::number;
  std::string unit{};  ///< scale of the number; empty: none
  Range range{};
  std::vector<std::string> choices{};  ///< of a choice, or of each of the names
  std::vector<FormerChoice> former{};
  std::string letters{};    ///< of a text: all that it may have beside letters and digits; empty: anything
  std::string first{};      ///< of a text: what it may begin with, as "A-Za-z"; empty: with any of them
  std::size_t longest = 0;  ///< of a text: most letters; 0: any number
  std::vector<std::size_t>
      lengths{};  ///< of a list, or of each corner of a box: how many entries it may have; empty: any
  bool required = false;
  std::string example{};  ///< TOML text, the value of the paper's pull scene; empty: the default is the example
  std::string source{};   ///< short note `init` writes behind the value
  std::string help{};
  std::string reason{};  ///< why the range ends where it does, and what to choose; part of the error
  Binding bind{};
  int only_in = 0;             ///< dimension of the cases that have it; 0: any
  std::string default_note{};  ///< when the default depends on the scene
  Support support{};           ///< of a profile

  std::string table()
      const;  ///< "droplet[]" of "droplet[].radius", "solver" of "solver.newton.rtol", "a.b[]" of "a.b[].c"
  std::string leaf() const;  ///< "radius", "newton.rtol": the name inside its table
};

const std::vector<Table>& tables();
const std::vector<Key>& schema();

/// The key of that schema name ("load[].box"), or nullptr.
const Key* find_key(std::string_view name);
const Table* find_table(std::string_view name);

/// "load[0].box" for "load[].box", a name without "[]" as it is.
std::string indexed_name(const std::string& name, std::size_t index);

/// How a table begins in a case file: "[fluid]", "[[load]]".
std::string header_of(const Table& table);

/// What is allowed there: "number in (0, 180)", "one of "gradient", "energy"".
std::string allowed_text(const Key& key);

/// "number in (0, 180), in degrees; default 90": what is allowed there, its unit, and what holds without it.
std::string facts_text(const Key& key);

/// TOML text of the default (of Case itself); empty when the key is required.
std::string default_text(const Key& key);

/// TOML text of a value that works: the example, else the default.
std::string example_text(const Key& key);

// The parts of the schema.
std::vector<Key> scene_keys();
std::vector<Key> substrate_keys();
std::vector<Key> branch_keys();
std::vector<Key> initial_keys();
std::vector<Key> load_keys();
std::vector<Key> needle_keys();
std::vector<Key> numerics_keys();
std::vector<Key> output_keys();
std::vector<Key> laboratory_keys();

}  // namespace softwet
