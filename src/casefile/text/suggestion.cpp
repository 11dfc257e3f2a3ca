// Suggestions from the schema.
#include "casefile/text/suggestion.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "casefile/schema/nearest.hpp"
#include "casefile/schema/schema.hpp"

namespace softwet {
namespace {

/// Name of a table without the "[]" of a repeated one.
std::string plain(const std::string& table) { return table.substr(0, table.find('[')); }

/// Names of all keys and all tables, repeated tables without "[]".
std::vector<std::string> known_names() {
  std::vector<std::string> names;
  for (const Key& key : schema()) names.push_back(key.name);
  for (const Table& table : tables())
    if (!table.name.empty()) names.push_back(plain(table.name));
  return names;
}

std::string keys_of(const Table& table) {
  std::string list;
  for (const Key& key : schema())
    if (key.table() == table.name) list += (list.empty() ? "" : ", ") + key.leaf();
  return list;
}

/// "density is a key of [substrate]; " for the last part of a name that is in the wrong table.
std::string owner_of(const std::string& leaf) {
  for (const Key& key : schema())
    if (key.leaf() == leaf && !key.table().empty())
      return fmt::format("{} is a key of {}; ", leaf, header_of(*find_table(key.table())));
  return {};
}

std::string list_for(const std::string& name) {
  const auto dot = name.find('.');
  const std::string first = name.substr(0, dot);
  for (const Table& table : tables())
    if (dot != std::string::npos && !first.empty() && plain(table.name) == plain(first))
      return fmt::format("{}{} has the keys {}; 'softwet explain {}' shows what they mean",
                         owner_of(name.substr(dot + 1)), header_of(table), keys_of(table), plain(first));
  std::string list;
  for (const Table& table : tables())
    if (!table.name.empty()) list += (list.empty() ? "" : ", ") + header_of(table);
  return fmt::format("the tables are {}; 'softwet explain' lists all keys", list);
}

}  // namespace

Suggestion suggest(const std::string& name, const std::vector<std::string>& others) {
  std::vector<std::string> known = known_names();
  known.insert(known.end(), others.begin(), others.end());
  const std::string nearest = nearest_name(name, known);
  if (nearest.empty()) return {"", list_for(name)};
  if (const Key* key = find_key(nearest))
    return {nearest, fmt::format("did you mean {} (for example {} = {})? 'softwet explain {}' shows what it means",
                                 nearest, key->leaf(), example_text(*key), nearest)};
  if (std::find(others.begin(), others.end(), nearest) != others.end())
    return {nearest, fmt::format("did you mean {}? 'softwet explain {}' shows what it means", nearest, nearest)};
  const Table* table = find_table(nearest) ? find_table(nearest) : find_table(nearest + "[]");
  return {nearest, fmt::format("did you mean the table {}? 'softwet explain {}' shows what it holds", header_of(*table),
                               nearest)};
}

}  // namespace softwet
