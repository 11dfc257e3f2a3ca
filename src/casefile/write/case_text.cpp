// Schema to text: the resolved case, the case to start from, and the explanation of keys.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <iterator>
#include <sstream>
#include <vector>

#include "case/error.hpp"
#include "casefile/case_file.hpp"
#include "casefile/formula/profiles.hpp"
#include "casefile/schema/quality.hpp"
#include "casefile/text/document.hpp"
#include "casefile/text/suggestion.hpp"
#include "casefile/write/column_text.hpp"

namespace softwet {
namespace {

bool applies(const Key& key, const Case& c) { return key.only_in == 0 || key.only_in == c.dimension(); }

/// One line for each key of each table the case has; `line` returns it, `remark` what follows a table's header.
std::string write_tables(const Case& c, const std::function<std::string(const Key&, std::size_t)>& line,
                         const std::function<std::string(const Table&)>& remark) {
  std::string text;
  for (const Table& table : tables()) {
    for (std::size_t i = 0; i < table.count(c); ++i) {
      if (!table.name.empty()) text += fmt::format("\n{}{}\n", header_of(table), remark(table));
      for (const Key& key : schema()) {
        if (key.table() == table.name && applies(key, c)) text += line(key, i) + "\n";
      }
    }
  }
  return text;
}

/// The scene of the examples in the schema: the paper's pull.
Case example_scene() {
  Case c;
  for (const Table& table : tables())
    if (table.in_example) table.open(c, 0);
  for (const Key& key : schema()) {
    const Table& table = *find_table(key.table());
    if (table.in_example && !key.example.empty()) key.bind.set(c, 0, value_from_text(key, key.example));
  }
  return c;
}

std::string explain_table(const Table& table) {
  std::string text = fmt::format("{}\n    {}\n", header_of(table), table.help);
  std::istringstream notes(table.notes);
  for (std::string line; std::getline(notes, line);) text += line.empty() ? "\n" : "    " + line + "\n";
  return text;
}

/// @param alone  it is all that is asked for
std::string explain_key(const Key& key, bool alone) {
  std::string text = key.name + "\n    " + key.help + "\n    " + facts_text(key);
  if (!key.reason.empty()) text += "\n    " + key.reason;
  if (key.bind.profiles && alone) text += "\n    " + profile_text(key);
  if (!key.example.empty()) text += fmt::format("\n    example: {} = {}", key.leaf(), key.example);
  return text + "\n";
}

/// True for the key itself, its table or group, with or without "[]".
bool matches(const Key& key, const std::string& name) {
  std::string plain = key.name;
  if (const auto bracket = plain.find("[]"); bracket != std::string::npos) plain.erase(bracket, 2);
  for (const std::string& full : {key.name, plain}) {
    if (full == name || full.compare(0, name.size() + 1, name + ".") == 0) return true;
  }
  return false;
}

/// Whether a text has a word or its beginning, large letters like small ones.
bool has_word(const std::string& text, const std::string& word) {
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == std::tolower(b); };
  return std::search(text.begin(), text.end(), word.begin(), word.end(), same) != text.end();
}

/// The keys whose names end with `name`, whole parts of a name alone: "wall_law" is the end of fluid.wall_law.
std::vector<const Key*> keys_ending(const std::string& name) {
  std::vector<const Key*> found;
  for (const Key& key : schema())
    if (key.name.ends_with("." + name)) found.push_back(&key);
  return found;
}

/// The keys whose names or meanings have all words of `words`.
std::vector<const Key*> keys_about(const std::string& words) {
  std::vector<const Key*> found;
  for (const Key& key : schema()) {
    std::istringstream list(words);
    const std::string text = key.name + " " + key.help;
    if (std::all_of(std::istream_iterator<std::string>(list), {},
                    [&](const std::string& word) { return has_word(text, word); }))
      found.push_back(&key);
  }
  return found;
}

/// One key as a whole, several by their names and the first sentences of their meanings; "" for none.
std::string explain_found(const std::vector<const Key*>& found, const std::string& what) {
  if (found.empty()) return {};
  if (found.size() == 1) return explain_key(*found.front(), true);
  std::string text = fmt::format("{}: {} keys; softwet explain KEY has more\n", what, found.size());
  for (const Key* key : found)
    text += fmt::format("  {:<36} {}\n", key->name, key->help.substr(0, key->help.find(". ")));
  return text;
}

}  // namespace

std::string write_case(const Case& c) {
  return write_tables(
      c, [&](const Key& key, std::size_t i) { return key.leaf() + " = " + text_of_value(key.bind.get(c, i)); },
      [](const Table&) { return std::string{}; });
}

std::string initial_case(const std::string& name) {
  const auto line = [&name](const Key& key, std::size_t) {
    const std::string value = key.leaf() + " = " + (key.name == "name" ? text_of_value(name) : example_text(key));
    if (set_by_quality(key.name)) return fmt::format("# {:<40} # set by quality. {}", value, key.help);
    std::string comment = key.source.empty() ? key.help : key.source;
    return fmt::format("{:<42} # {}", value, comment);
  };
  const std::string text =
      "# A droplet on a soft substrate, pulled by a load on the solid.\n"
      "# Numbers may be written as ratios in quotes. Keys with defaults may be removed; tables select the "
      "physics.\n" +
      write_tables(example_scene(), line, [](const Table& table) { return "  # " + table.help; });
  parse_case(text, fmt::format("init '{}'", name));  // refuses what cannot be the name of a case
  return text;
}

std::string explain(const std::string& name) {
  std::string text, last_table;
  if (name.empty())
    text =
        "Numbers are 0 or between 1e-30 and 1e30 in size; ratios in quotes (\"1/256\") are numbers too.\n"
        "How expressions and tables look: softwet explain substrate.young\n";
  for (const Key& key : schema()) {
    if (!name.empty() && !matches(key, name)) continue;
    if (const std::string table = key.table(); table != last_table) {
      last_table = table;
      if (name.empty() || name.find('.') == std::string::npos) {
        text += (text.empty() ? "" : "\n") + explain_table(*find_table(table)) + "\n";
      }
    }
    text += explain_key(key, name.find('.') != std::string::npos);
  }
  if (name.empty())
    text += "\nWhat a run writes: softwet explain history, softwet explain interface, softwet explain fields\n";
  if (text.empty()) text = explain_columns(name);
  if (text.empty()) text = explain_found(keys_ending(name), fmt::format("names that end with '{}'", name));
  if (text.empty() && name.find(' ') != std::string::npos)
    text = explain_found(keys_about(name), fmt::format("meanings with the words '{}'", name));
  if (!text.empty()) return text;
  throw Error(Exit::invalid_input,
              fmt::format("explain: unknown key or column '{}'; {}", name, suggest(name, column_names()).sentence));
}

}  // namespace softwet
