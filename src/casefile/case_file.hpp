// Case files: reading and checking them, writing them, explaining their keys. All of it from the one schema.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/case.hpp"
#include "case/physical.hpp"

namespace softwet {

/// Reads and checks a case file, with "key=value" overrides of the command line. Throws Error invalid_input.
Case read_case(const std::string& path, const std::vector<std::string>& overrides = {});

/// How quantities become numbers of a case. Who reads a file passes it, since the scales need the liquid's equation of
/// state.
struct Conversion {
  std::function<Scales(const PhysicalScene&)> scales;
  std::function<Case(const PhysicalScene&)> numbers;  ///< fluid, solid and droplet of a case
};

struct LaboratoryCase {
  Case c;
  std::optional<Laboratory> laboratory;  ///< nothing where the file has no such table
};

/// As read_case, of a file that may have a table [laboratory]: keys follow from its quantities.
LaboratoryCase read_laboratory_case(const std::string& path, const std::vector<std::string>& overrides,
                                    const Conversion&);

/// Reads a case from text; `place` names it in messages.
Case parse_case(std::string_view text, const std::string& place, const std::vector<std::string>& overrides = {});

/// Reads a case file of which the mesh and the materials are all that is asked for: its tables, which may be gone, stay
/// unread. Throws Error invalid_input.
Case read_scene(const std::string& path);

/// The complete resolved case as TOML, every key with its value: parse_case(write_case(c)) equals c.
std::string write_case(const Case& c);

/// What `softwet explain` prints: one key, all keys of a table, or all keys when `name` is empty; a column of
/// history.csv or interface.csv, or all of them ("history", "interface").
std::string explain(const std::string& name);

/// A commented case with every key: the paper's pull under this name. Throws Error when no case can have the name.
std::string initial_case(const std::string& name);

/// What is allowed in a checked case but deserves a look: under-resolved interface, times never reached.
std::vector<std::string> warnings(const Case& c);

}  // namespace softwet
