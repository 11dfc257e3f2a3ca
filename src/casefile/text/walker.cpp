// From TOML tables to the entries of a Document.
#include "casefile/text/walker.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "casefile/text/entry.hpp"
#include "casefile/text/suggestion.hpp"
#include "casefile/text/toml_value.hpp"

namespace softwet {

bool begins_a_key(const std::string& name) {
  return std::any_of(schema().begin(), schema().end(),
                     [&](const Key& key) { return key.name.compare(0, name.size() + 1, name + ".") == 0; });
}

/// The key is shown with the entry of its table, "load[1].forc".
void reject_unknown(const std::string& place, const std::string& name, std::size_t index, const std::string& text) {
  const Suggestion suggestion = suggest(name);
  const Key* meant = find_key(suggestion.name);
  const bool is_table = text.find("{...}") != std::string::npos;
  reject(place, indexed_name(name, index), is_table ? "" : text, is_table ? "unknown table" : "unknown key",
         suggestion.sentence, meant ? indexed_name(meant->name, index) : suggestion.name);
}

void Walker::walk(const toml::table& table, const std::string& prefix, std::size_t index) {
  std::vector<std::pair<std::string, const toml::node*>> nodes;
  for (const auto& [word, node] : table) nodes.emplace_back(std::string(word.str()), &node);
  std::stable_sort(nodes.begin(), nodes.end(), [](const auto& one, const auto& other) {
    return one.second->source().begin.line < other.second->source().begin.line;
  });
  for (const auto& [word, node] : nodes)
    problems_.keep([&, name = prefix + word, node = node] { enter(name, *node, index); });
}

void Walker::enter(const std::string& name, const toml::node& node, std::size_t index) {
  if (const Key* key = find_key(name)) {
    document_.entries[indexed_name(key->name, index)] = make_entry(*key, index, node, at(node));
  } else if (find_table(name + "[]")) {
    walk_entries(node, name);
  } else if (begins_a_key(name)) {
    walk_table(node, name, index);
  } else {
    reject_unknown(at(node), name, index, text_of_node(node));
  }
}

std::string Walker::at(const toml::node& node) const {
  return lines_ == Lines::none ? place_ : fmt::format("{}:{}", place_, node.source().begin.line);
}

void Walker::walk_table(const toml::node& node, const std::string& name, std::size_t index) {
  const toml::table* table = node.as_table();
  if (!table) {
    reject(at(node), name, text_of_node(node), "is a table that appears once", fmt::format("write [{}]", name));
  }
  document_.table_count[name] = 1;
  document_.table_place[name] = at(node);
  walk(*table, name + ".", index);
}

void Walker::walk_entries(const toml::node& node, const std::string& name) {
  const toml::array* list = node.as_array();
  if (!list || !std::all_of(list->begin(), list->end(), [](const toml::node& n) { return n.is_table(); })) {
    reject(at(node), name, text_of_node(node), "is a list of tables, because a case may have several",
           fmt::format("write [[{}]] with double brackets on a line of its own, and its keys below", name));
  }
  document_.table_count[name + "[]"] = list->size();
  for (std::size_t i = 0; i < list->size(); ++i) {
    document_.table_place[fmt::format("{}[{}]", name, i)] = at((*list)[i]);
    walk(*(*list)[i].as_table(), name + "[].", i);
  }
}

}  // namespace softwet
