// KEY=VALUE of the command line to a Document: of one key, or of a whole table as TOML writes it on one line.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

#include "casefile/text/document.hpp"
#include "casefile/text/entry.hpp"
#include "casefile/text/toml_value.hpp"
#include "casefile/text/walker.hpp"

namespace softwet {
namespace {

/// "load[2].ramp" -> ("load[].ramp", 2); "load.ramp" -> ("load[].ramp", 0); other names stay.
std::pair<std::string, std::size_t> split_index(const std::string& name, const std::string& place) {
  const auto open = name.find('['), close = name.find(']');
  if (open == std::string::npos) {
    for (auto dot = name.find('.'); dot != std::string::npos; dot = name.find('.', dot + 1))
      if (find_table(name.substr(0, dot) + "[]")) return {name.substr(0, dot) + "[]" + name.substr(dot), 0};
    return {name, 0};
  }
  const std::string digits = close == std::string::npos ? "" : name.substr(open + 1, close - open - 1);
  const bool valid = !digits.empty() && digits.size() < 6 && std::all_of(digits.begin(), digits.end(), [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
  });
  if (!valid) reject(place, name, "", "has no entry number", "count from zero, for example load[0].ramp=5");
  return {name.substr(0, open) + "[]" + name.substr(close + 1), static_cast<std::size_t>(std::stoul(digits))};
}

/// A TOML table { value = ... } from one value; text that is no TOML value (1/256, slip) is taken as a string.
toml::table parse_value(const std::string& text) {
  try {
    toml::table parsed = toml::parse("value = " + text);
    if (parsed.size() == 1) return parsed;
  } catch (const toml::parse_error&) {
  } catch (const MalformedToml&) {
  }
  return toml::table{{"value", text}};
}

/// Removes what the document has of a table, "substrate" or "load[1]", and of the tables in it.
void forget_table(Document& document, const std::string& name) {
  const auto inside = [&](const std::string& other) {
    return other == name ||
           (other.compare(0, name.size(), name) == 0 && (other[name.size()] == '.' || other[name.size()] == '['));
  };
  const auto remove = [&](auto& some) {
    for (auto entry = some.begin(); entry != some.end();) entry = inside(entry->first) ? some.erase(entry) : ++entry;
  };
  remove(document.entries);
  remove(document.table_count);
  remove(document.table_place);
}

/// "{ stiffness = 100, box = [[0.7, 0], [0.8, 0.125]] }": a table as it may be written, with two of its keys.
std::string example_of_table(const std::string& name) {
  std::vector<const Key*> keys;
  for (const Key& key : schema())
    if (key.name.compare(0, name.size() + 1, name + ".") == 0) keys.push_back(&key);
  std::stable_partition(keys.begin(), keys.end(), [](const Key* key) { return key->required; });
  std::string shown;
  for (std::size_t i = 0; i < keys.size() && i < 2; ++i)
    shown += fmt::format("{} {} = {}", i ? "," : "", keys[i]->name.substr(name.size() + 1), example_text(*keys[i]));
  return fmt::format("{{{} }}", shown);
}

/// The tables that an assignment gives: one, or a list of them. What is wrong with the text goes into the message.
toml::table tables_in(const std::string& place, const std::string& shown, const std::string& name,
                      const std::string& text) {
  std::string problem = "is a table";
  try {
    toml::table parsed = toml::parse("value = " + text);
    const toml::node& value = *parsed.get("value");
    const toml::array* list = value.as_array();
    const bool all = list && std::all_of(list->begin(), list->end(), [](const toml::node& n) { return n.is_table(); });
    const bool may_be_list = find_table(name) && find_table(name)->repeated && shown.back() != ']';
    if (parsed.size() == 1 && (value.is_table() || (all && may_be_list))) return parsed;
  } catch (const toml::parse_error& error) {
    if (text.find_first_of("{[") == 0) problem = fmt::format("is no TOML ({})", std::string(error.description()));
  } catch (const MalformedToml& error) {
    if (text.find_first_of("{[") == 0) problem = fmt::format("is no TOML ({})", error.what());
  }
  reject(
      place, shown, text, problem,
      fmt::format("write it in braces, in single quotes for the shell, with texts and ratios in double quotes: --set "
                  "'{}={}'",
                  shown, example_of_table(name)));
}

/// Refuses an entry of a repeated table behind the last one. @param count  of the entries that there may be
void require_entry(const Document& document, const std::string& place, const std::string& table,
                   const std::string& name, std::size_t index, const std::string& text, std::size_t added) {
  const auto found = document.table_count.find(table);
  const std::size_t count = found == document.table_count.end() ? 0 : found->second;
  if (index < count + added) return;
  const std::string next = fmt::format("{}[{}]", table.substr(0, table.size() - 2), count);
  reject(
      place, name, text, fmt::format("the case has {} of these tables, counted from 0", count),
      fmt::format("add the table to the case file, or here as a whole: --set '{}={}'", next, example_of_table(table)));
}

/// Replaces a table as a whole, as if the file had it so: "substrate.gel={...}", "load[1]={...}", "load=[{...},
/// {...}]". A table without a number in place of a list is the first of them.
void assign_table(Document& document, const std::string& place, const std::string& shown, std::string name,
                  std::size_t index, const std::string& text, Problems& problems) {
  if (find_table(name + "[]")) name += "[]";
  const Table* table = find_table(name);
  const toml::table parsed = tables_in(place, shown, name, text);
  const toml::node& value = *parsed.get("value");
  Walker walker(document, place, Lines::none, problems);
  const std::string plain = name.substr(0, name.find('['));
  if (table && table->repeated && value.is_array()) {
    forget_table(document, plain);
    walker.walk_entries(value, plain);
  } else if (table && table->repeated) {
    require_entry(document, place, name, shown, index, text, 1);
    forget_table(document, indexed_name(name, index));
    document.table_count[name] = std::max(document.table_count[name], index + 1);
    document.table_place[indexed_name(name, index)] = place;
    walker.walk(*value.as_table(), name + ".", index);
  } else {
    forget_table(document, indexed_name(name, index));
    walker.walk_table(value, name, index);
    document.table_count[plain.substr(0, plain.find('.'))] = 1;
  }
}

}  // namespace

void apply_override(Document& document, const std::string& assignment, Problems& problems) {
  const std::string place = "--set " + assignment;
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    reject(place, assignment, "", "is not an assignment", "write --set key=value, for example --set time.end=10");
  }
  const std::string shown = assignment.substr(0, equals), text = assignment.substr(equals + 1);
  const auto [name, index] = split_index(shown, place);
  const Key* key = find_key(name);
  if (!key && (begins_a_key(name) || find_table(name) || find_table(name + "[]")))
    return assign_table(document, place, shown, name, index, text, problems);
  if (!key) reject_unknown(place, name, index, text);
  const std::string table = key->table();
  if (const Table* repeated = find_table(table); repeated && repeated->repeated) {
    require_entry(document, place, table, indexed_name(key->name, index), index, text, 0);
  } else if (!table.empty()) {
    document.table_count[table] = 1;
  }
  document.entries[indexed_name(key->name, index)] = make_entry(*key, index, *parse_value(text).get("value"), place);
}

Entry entry_of_number(const Key& key, std::size_t index, double number, const std::string& place) {
  return make_entry(key, index, toml::value<double>(number), place);
}

Value value_from_text(const Key& key, const std::string& text) {
  return make_entry(key, 0, *parse_value(text).get("value"), "schema").value;
}

}  // namespace softwet
