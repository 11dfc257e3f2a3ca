// The tables of a TOML text and the keys in them, one after the other, into a Document.
#pragma once

#include <cstddef>
#include <string>

#include "casefile/text/document.hpp"
#include "casefile/text/toml_reader.hpp"

namespace softwet {

/// Whether the place of a value has the number of its line, as a file has, or none, as the command line.
enum class Lines { counted, none };

/// True when `name` is the beginning of some key: a table or a group such as "solver.newton".
bool begins_a_key(const std::string& name);

/// Refuses a name that no key and no table has, and says which one may be meant. `text` is its value.
[[noreturn]] void reject_unknown(const std::string& place, const std::string& name, std::size_t index,
                                 const std::string& text);

/// Walks the tables of a file and fills the document; what is wrong goes to the problems, in the order of the file.
class Walker {
 public:
  Walker(Document& document, std::string place, Lines lines, Problems& problems)
      : document_(document), place_(std::move(place)), lines_(lines), problems_(problems) {}

  /// `prefix` is the schema name of the table with its dot: "", "fluid.", "load[].", "solver.newton.".
  void walk(const toml::table& table, const std::string& prefix, std::size_t index);

  /// A table that appears once, "fluid" or "solver.newton".
  void walk_table(const toml::node& node, const std::string& name, std::size_t index);

  /// A list of tables, "load".
  void walk_entries(const toml::node& node, const std::string& name);

 private:
  void enter(const std::string& name, const toml::node& node, std::size_t index);
  std::string at(const toml::node& node) const;

  Document& document_;
  std::string place_;
  Lines lines_;
  Problems& problems_;
};

}  // namespace softwet
