// TOML text and command line assignments to a Document.
#include "casefile/text/document.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "case/error.hpp"
#include "casefile/text/entry.hpp"
#include "casefile/text/suggestion.hpp"
#include "casefile/text/syntax_hint.hpp"
#include "casefile/text/toml_value.hpp"

namespace softwet {
namespace {

/// True when `name` is the beginning of some key: a table or a group such as "solver.newton".
bool begins_a_key(const std::string& name) {
  return std::any_of(schema().begin(), schema().end(),
                     [&](const Key& key) { return key.name.compare(0, name.size() + 1, name + ".") == 0; });
}

/// `shown` is the name with the entry of its table, "load[1].forc".
[[noreturn]] void reject_unknown(const std::string& place, const std::string& name, std::size_t index,
                                 const std::string& text) {
  const Suggestion suggestion = suggest(name);
  const Key* meant = find_key(suggestion.name);
  const bool is_table = text.find("{...}") != std::string::npos;
  reject(place, indexed_name(name, index), is_table ? "" : text, is_table ? "unknown table" : "unknown key",
         suggestion.sentence, meant ? indexed_name(meant->name, index) : suggestion.name);
}

/// Walks the tables of a file and fills the document; what is wrong goes to the problems, in the order of the file.
class Walker {
 public:
  Walker(Document& document, std::string place, Problems& problems)
      : document_(document), place_(std::move(place)), problems_(problems) {}

  /// `prefix` is the schema name of the table with its dot: "", "fluid.", "load[].", "solver.newton.".
  void walk(const toml::table& table, const std::string& prefix, std::size_t index) {
    std::vector<std::pair<std::string, const toml::node*>> nodes;
    for (const auto& [word, node] : table) nodes.emplace_back(std::string(word.str()), &node);
    std::stable_sort(nodes.begin(), nodes.end(), [](const auto& one, const auto& other) {
      return one.second->source().begin.line < other.second->source().begin.line;
    });
    for (const auto& [word, node] : nodes)
      problems_.keep([&, name = prefix + word, node = node] { enter(name, *node, index); });
  }

 private:
  void enter(const std::string& name, const toml::node& node, std::size_t index) {
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

  std::string at(const toml::node& node) const { return fmt::format("{}:{}", place_, node.source().begin.line); }

  void walk_table(const toml::node& node, const std::string& name, std::size_t index) {
    const toml::table* table = node.as_table();
    if (!table) {
      reject(at(node), name, text_of_node(node), "is a table that appears once", fmt::format("write [{}]", name));
    }
    document_.table_count[name] = 1;
    document_.table_place[name] = at(node);
    walk(*table, name + ".", index);
  }

  void walk_entries(const toml::node& node, const std::string& name) {
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

  Document& document_;
  std::string place_;
  Problems& problems_;
};

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

/// Keeps what is wrong with a line that is no TOML, and empties it so that the rest can be read. Throws where nothing
/// better is known than what the library says.
void take_out_line(std::string& text, const std::string& place, long line, std::string_view problem,
                   Problems& problems) {
  const std::string where = fmt::format("{}:{}", place, line);
  const auto hint = syntax_hint(text, line);
  problems.keep([&] {
    if (hint) reject(where, hint->key, hint->value, hint->problem, hint->remedy);
    if (problem.find("redefine") != std::string_view::npos)
      reject(where, std::string(problem), "", "a key or table appears twice",
             "keep one of them; where there are several loads, each begins with [[load]]");
    reject(where, "this is not TOML", "", std::string(problem), "see 'softwet init' for a case to start from");
  });
  if (!hint) problems.throw_if_any();
  std::size_t begin = 0;
  for (long number = 1; number < line; ++number) begin = text.find('\n', begin) + 1;
  text.erase(begin, std::min(text.find('\n', begin), text.size()) - begin);
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

/// The line at which the library gave up without saying where: the shortest beginning of the text with that fate. It
/// reads from the front, so longer beginnings share the fate and the line is found by bisection.
long line_of_malformed(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n', end + 1))
    ends.push_back(end + 1);
  const auto healthy = [&](std::size_t end) { return !is_malformed(text.substr(0, end)); };
  return 1 + (std::partition_point(ends.begin(), ends.end(), healthy) - ends.begin());
}

toml::table parse_file(std::string text, const std::string& place, Problems& problems) {
  for (;;) {  // each turn takes a line out, and the number of problems is limited
    try {
      return toml::parse(text, place);
    } catch (const toml::parse_error& error) {
      take_out_line(text, place, static_cast<long>(error.source().begin.line), error.description(), problems);
    } catch (const MalformedToml& error) {
      take_out_line(text, place, line_of_malformed(text), error.what(), problems);
    }
  }
}

/// Some editors save in UTF-16: a mark of two bytes at the beginning, or a zero in every second byte.
void refuse_other_encodings(std::string_view text, const std::string& place) {
  const std::string_view mark = text.substr(0, 2), zeros = text.substr(0, 200);
  const bool marked = mark == "\xff\xfe" || mark == "\xfe\xff";
  if (marked || (zeros.find('\0') < 2 && zeros.size() > 3 && zeros[0] != zeros[1]))
    throw Error(Exit::invalid_input,
                fmt::format("{}: the file is in UTF-16; save it in UTF-8, for example with 'iconv -f "
                            "UTF-16 -t UTF-8 {} > new.toml'",
                            place, place));
  if (text.find('\0') != std::string_view::npos)
    throw Error(Exit::invalid_input,
                fmt::format("{}: the file is not text, it holds bytes that are zero; give the path of "
                            "a case, for example cases/tensotaxis_pull_2d.toml",
                            place));
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

Document read_document(std::string_view text, const std::string& place, Problems& problems) {
  refuse_other_encodings(text, place);
  Document document;
  document.place = place;
  const toml::table table = parse_file(std::string(text), place, problems);
  if (table.empty()) {
    problems.throw_if_any();
    throw Error(Exit::invalid_input,
                fmt::format("{}: the file is empty; 'softwet init FILE' writes a complete case to start from", place));
  }
  Walker(document, place, problems).walk(table, "", 0);
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
  if (!key) reject_unknown(place, name, index, text);
  const std::string table = key->table();
  if (const Table* repeated = find_table(table); repeated && repeated->repeated) {
    const std::size_t count = document.table_count[table];
    if (index >= count) {
      reject(place, indexed_name(key->name, index), text,
             fmt::format("the case has {} of these tables, counted from 0", count), "add the table to the case file");
    }
  } else if (!table.empty()) {
    document.table_count[table] = 1;
  }
  document.entries[indexed_name(key->name, index)] = make_entry(*key, index, *parse_value(text).get("value"), place);
}

Value value_from_text(const Key& key, const std::string& text) {
  return make_entry(key, 0, *parse_value(text).get("value"), "schema").value;
}

}  // namespace softwet
