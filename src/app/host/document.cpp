// TOML text and command line assignments to a Document.
#include "app/host/document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "app/error.hpp"
#include "app/host/nearest.hpp"
#include "app/host/toml_value.hpp"

namespace softwet {
namespace {

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

/// Its beginning, where a text is too long for a message.
std::string shortened(const std::string& text) {
  constexpr std::size_t most = 200;
  return text.size() <= most ? text : text.substr(0, most) + "...";
}

/// Names of all keys and all tables, "[fluid]" without brackets; repeated tables without "[]".
std::vector<std::string> known_names() {
  std::vector<std::string> names;
  for (const Key& key : schema()) names.push_back(key.name);
  for (const Table& table : tables()) {
    if (!table.name.empty()) names.push_back(table.name.substr(0, table.name.find('[')));
  }
  return names;
}

/// True when `name` is the beginning of some key: a table or a group such as "solver.newton".
bool begins_a_key(const std::string& name) {
  return std::any_of(schema().begin(), schema().end(),
                     [&](const Key& key) { return key.name.compare(0, name.size() + 1, name + ".") == 0; });
}

[[noreturn]] void reject_unknown(const std::string& place, const std::string& name, const std::string& text) {
  const std::string nearest = nearest_name(name, known_names());
  const Key* key = find_key(nearest);
  const std::string remedy =
      key ? fmt::format("did you mean {} (for example {} = {})?", nearest, key->leaf(), example_text(*key))
          : fmt::format("did you mean the table {}?", nearest);
  const bool is_table = text == "{...}";
  reject(place, name, is_table ? "" : text, is_table ? "unknown table" : "unknown key",
         remedy + " 'softwet explain' lists all keys");
}

/// Numbers of a value, however deep they lie.
std::vector<double> numbers_of(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return {*number};
  if (const auto* numbers = std::get_if<Numbers>(&value)) return *numbers;
  std::vector<double> all;
  if (const auto* box = std::get_if<std::vector<Numbers>>(&value))
    for (const Numbers& corner : *box) all.insert(all.end(), corner.begin(), corner.end());
  return all;
}

/// What has to be among the choices of a key.
Words words_of(const Key& key, const Value& value) {
  if (key.kind == Kind::choice) return {std::get<std::string>(value)};
  return key.kind == Kind::names ? std::get<Words>(value) : Words{};
}

/// So that products of several inputs (h^4, 1 / dt^2) stay numbers.
constexpr double smallest = 1e-30, largest = 1e30;

void check_range(const Key& key, const Value& value, const std::string& name, const std::string& text,
                 const std::string& place) {
  for (double number : numbers_of(value)) {
    if (!key.range.contains(number)) {
      const std::string reason = key.reason.empty() ? "" : key.reason + "; ";
      reject(place, name, text, "must be a " + allowed_text(key),
             fmt::format("{}write for example {} = {}", reason, key.leaf(), example_text(key)));
    }
    if (number != 0 && (std::abs(number) < smallest || std::abs(number) > largest))
      reject(place, name, text, fmt::format("must be 0 or between {} and {} in size", smallest, largest),
             "choose the scales L0, a, b of the case so that its numbers are near 1");
  }
  for (const std::string& word : words_of(key, value)) {
    if (std::find(key.choices.begin(), key.choices.end(), word) != key.choices.end()) continue;
    reject(place, name, text, (key.kind == Kind::choice ? "must be " : "must be a ") + allowed_text(key),
           fmt::format("did you mean {}?", quoted(nearest_name(word, key.choices))));
  }
}

Entry make_entry(const Key& key, std::size_t index, const toml::node& node, const std::string& place) {
  const std::string name = indexed_name(key, index), text = text_of_node(node);
  const auto value = value_of_node(node, key.kind);
  if (!value) {
    const bool ratio = key.kind == Kind::number && key.example.find('/') == std::string::npos;
    reject(
        place, name, text, "must be " + std::string(key.kind == Kind::choice ? "" : "a ") + allowed_text(key),
        fmt::format("write for example {} = {}{}", key.leaf(), example_text(key), ratio ? " or a ratio \"3/8\"" : ""));
  }
  check_range(key, *value, name, text, place);
  return {&key, index, *value, text, place};
}

/// Walks the tables of a file and fills the document.
class Walker {
 public:
  Walker(Document& document, std::string place) : document_(document), place_(std::move(place)) {}

  /// `prefix` is the schema name of the table with its dot: "", "fluid.", "load[].", "solver.newton.".
  void walk(const toml::table& table, const std::string& prefix, std::size_t index) {
    for (const auto& [word, node] : table) {
      const std::string name = prefix + std::string(word.str());
      if (const Key* key = find_key(name)) {
        document_.entries[indexed_name(*key, index)] = make_entry(*key, index, node, at(node));
      } else if (prefix.empty() && find_table(name + "[]")) {
        walk_entries(node, name);
      } else if (begins_a_key(name)) {
        walk_table(node, name, index);
      } else {
        reject_unknown(at(node), name, text_of_node(node));
      }
    }
  }

 private:
  std::string at(const toml::node& node) const { return fmt::format("{}:{}", place_, node.source().begin.line); }

  void walk_table(const toml::node& node, const std::string& name, std::size_t index) {
    const toml::table* table = node.as_table();
    if (!table) {
      reject(at(node), name, text_of_node(node), "is a table and stands once", fmt::format("write [{}]", name));
    }
    document_.table_count[name] = 1;
    document_.table_place[name] = at(node);
    walk(*table, name + ".", index);
  }

  void walk_entries(const toml::node& node, const std::string& name) {
    const toml::array* list = node.as_array();
    if (!list || !std::all_of(list->begin(), list->end(), [](const toml::node& n) { return n.is_table(); })) {
      reject(at(node), name, text_of_node(node), "is a list of tables",
             fmt::format("write [[{}]] with double brackets above its keys", name));
    }
    document_.table_count[name + "[]"] = list->size();
    for (std::size_t i = 0; i < list->size(); ++i) {
      document_.table_place[fmt::format("{}[{}]", name, i)] = at((*list)[i]);
      walk(*(*list)[i].as_table(), name + "[].", i);
    }
  }

  Document& document_;
  std::string place_;
};

/// "load[2].ramp" -> ("load[].ramp", 2); "load.ramp" -> ("load[].ramp", 0); other names stay.
std::pair<std::string, std::size_t> split_index(const std::string& name, const std::string& place) {
  const auto open = name.find('['), close = name.find(']');
  if (open == std::string::npos) {
    const auto dot = name.find('.');
    if (dot != std::string::npos && find_table(name.substr(0, dot) + "[]")) {
      return {name.substr(0, dot) + "[]" + name.substr(dot), 0};
    }
    return {name, 0};
  }
  const std::string digits = close == std::string::npos ? "" : name.substr(open + 1, close - open - 1);
  const bool valid = !digits.empty() && digits.size() < 6 && std::all_of(digits.begin(), digits.end(), [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
  });
  if (!valid) reject(place, name, "", "has no entry number", "count from zero, for example load[0].ramp=5");
  return {name.substr(0, open) + "[]" + name.substr(close + 1), static_cast<std::size_t>(std::stoul(digits))};
}

[[noreturn]] void reject_syntax(const std::string& place, long line, std::string_view problem) {
  throw Error(Exit::invalid_input, one_line(fmt::format("{}:{}: this is not TOML: {}; see 'softwet init' for a case to "
                                                        "start from",
                                                        place, line, problem)));
}

bool is_malformed(std::string_view text) {
  try {
    static_cast<void>(toml::parse(text));
  } catch (const MalformedToml&) {
    return true;
  } catch (const toml::parse_error&) {
  }
  return false;
}

/// The line at which the library gave up without telling where: the shortest beginning of the text with that fate. It
/// reads from the front, so longer beginnings share the fate and the line is found by bisection.
long line_of_malformed(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n', end + 1))
    ends.push_back(end + 1);
  const auto healthy = [&](std::size_t end) { return !is_malformed(text.substr(0, end)); };
  return 1 + (std::partition_point(ends.begin(), ends.end(), healthy) - ends.begin());
}

toml::table parse_file(std::string_view text, const std::string& place) {
  try {
    return toml::parse(text, place);
  } catch (const toml::parse_error& error) {
    reject_syntax(place, static_cast<long>(error.source().begin.line), error.description());
  } catch (const MalformedToml& error) {
    reject_syntax(place, line_of_malformed(text), error.what());
  }
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

}  // namespace

void reject(const std::string& place, const std::string& key, const std::string& text, const std::string& problem,
            const std::string& remedy) {
  const std::string value = text.empty() ? "" : " = " + shortened(text);
  throw Error(Exit::invalid_input,
              one_line(fmt::format("{}: {}{}: {}; {}", shortened(place), shortened(key), value, problem, remedy)));
}

Document read_document(std::string_view text, const std::string& place) {
  Document document;
  document.place = place;
  const toml::table table = parse_file(text, place);
  if (table.empty()) {
    throw Error(Exit::invalid_input,
                fmt::format("{}: the file is empty; 'softwet init FILE' writes a complete case to start from", place));
  }
  Walker(document, place).walk(table, "", 0);
  return document;
}

void apply_override(Document& document, const std::string& assignment) {
  const std::string place = "--set " + assignment;
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    reject(place, assignment, "", "is not an assignment", "write --set key=value, for example --set time.end=10");
  }
  const std::string text = assignment.substr(equals + 1);
  const auto [name, index] = split_index(assignment.substr(0, equals), place);
  const Key* key = find_key(name);
  if (!key) reject_unknown(place, name, text);
  const std::string table = key->table();
  if (const Table* repeated = find_table(table); repeated && repeated->repeated) {
    const std::size_t count = document.table_count[table];
    if (index >= count) {
      reject(place, indexed_name(*key, index), text,
             fmt::format("the case has {} of these tables, counted from 0", count), "add the table to the case file");
    }
  } else if (!table.empty()) {
    document.table_count[table] = 1;
  }
  document.entries[indexed_name(*key, index)] = make_entry(*key, index, *parse_value(text).get("value"), place);
}

Value value_from_text(const Key& key, const std::string& text) {
  return make_entry(key, 0, *parse_value(text).get("value"), "schema").value;
}

}  // namespace softwet
