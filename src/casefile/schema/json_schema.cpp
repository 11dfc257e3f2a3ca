#include "casefile/schema/json_schema.hpp"

#include <cmath>
#include <sstream>

#include "casefile/schema/schema.hpp"
#include "io/run_record.hpp"

namespace softwet {
namespace {

using Json = RecordValue;

// What number_from_text, range_from_text and the reader of times take, as regular expressions.
const std::string digits = "[0-9]+(_[0-9]+)*", blank = "[ \\t]*";
const std::string number =
    blank + "[+-]?(" + digits + "\\.?(" + digits + ")?|\\." + digits + ")([eE][+-]?" + digits + ")?" + blank;
const std::string ratio = number + "(/" + number + ")?";
const std::string range_of_times = ratio + "(:" + ratio + ":" + ratio + ")?";

Json of_type(const char* type) {
  Json json;
  json["type"] = type;
  return json;
}

Json text_like(const std::string& pattern) {
  Json json = of_type("string");
  json["pattern"] = "^(" + pattern + ")$";
  return json;
}

Json one_of(const std::vector<Json>& all) {
  Json json;
  json["anyOf"] = Json(all);
  return json;
}

Json list_of(const Json& items) {
  Json json = of_type("array");
  json["items"] = items;
  return json;
}

/// A number in the range of the key; whole ones as integers, so that an editor shows them as such.
Json plain_number(const Key& key, Kind kind) {
  const bool whole = kind == Kind::integer;
  const auto bound = [whole](double value) { return whole ? Json(static_cast<std::int64_t>(value)) : Json(value); };
  Json json = of_type(whole ? "integer" : "number");
  const Range& range = key.range;
  if (std::isfinite(range.low)) json[range.low_open ? "exclusiveMinimum" : "minimum"] = bound(range.low);
  if (std::isfinite(range.high)) json[range.high_open ? "exclusiveMaximum" : "maximum"] = bound(range.high);
  return json;
}

/// A number, or a number or a ratio in quotes, whose value the schema cannot see.
Json number_or_ratio(const Key& key, Kind kind) { return one_of({plain_number(key, kind), text_like(ratio)}); }

Json choice_of(const Key& key) {
  Json json = of_type("string");
  for (const std::string& choice : key.choices) json["enum"].append(choice);
  return json;
}

Json times_of(const Key& key) {
  const Json moment = one_of({plain_number(key, Kind::number), text_like(range_of_times)});
  return one_of({plain_number(key, Kind::number), text_like(range_of_times), list_of(moment)});
}

Json schema_of_box(const Key& key) {
  Json json = list_of(list_of(number_or_ratio(key, Kind::number)));
  json["minItems"] = 2;
  json["maxItems"] = 2;
  return json;
}

/// Rows [t, value, ..].
Json table_over_time() {
  Json row = list_of(of_type("number"));
  row["minItems"] = 2;
  Json rows = list_of(row);
  rows["minItems"] = 1;
  return rows;
}

/// A quoted text is an expression or the path of a table, but for a number with a decimal comma.
Json profile_of(const Key& key) {
  std::vector<Json> kinds{plain_number(key, Kind::number), of_type("string")};
  if (key.support == Support::time) kinds.push_back(table_over_time());
  return one_of(kinds);
}

Json text_of(const Key& key) {
  return key.letters.empty() ? of_type("string") : text_like("[A-Za-z0-9" + key.letters + "]+");
}

Json type_of(const Key& key) {
  switch (key.kind) {
    case Kind::number:
      return number_or_ratio(key, Kind::number);
    case Kind::integer:
      return number_or_ratio(key, Kind::integer);
    case Kind::numbers:
      return list_of(number_or_ratio(key, Kind::number));
    case Kind::integers:
      return list_of(number_or_ratio(key, Kind::integer));
    case Kind::box:
      return schema_of_box(key);
    case Kind::times:
      return times_of(key);
    case Kind::choice:
      return choice_of(key);
    case Kind::names:
      return one_of({choice_of(key), list_of(choice_of(key))});
    case Kind::profile:
      return profile_of(key);
    case Kind::profiles:
      if (key.support == Support::time) return one_of({list_of(profile_of(key)), table_over_time()});
      return list_of(profile_of(key));
    case Kind::text:
      break;
  }
  return text_of(key);
}

Json table_schema(const std::string& help) {
  Json json = of_type("object");
  json["description"] = help;
  json["additionalProperties"] = false;
  return json;
}

/// Enters a key at its dotted name inside a table: "newton.rtol" is a key of the group "newton".
void add_key(Json& table, const Key& key) {
  Json* place = &table;
  std::istringstream words(key.leaf());
  std::string word, next;
  std::getline(words, word, '.');
  while (std::getline(words, next, '.')) {
    Json& group = (*place)["properties"][word];
    group["type"] = "object";
    group["additionalProperties"] = false;
    place = &group;
    word = next;
  }
  Json json = type_of(key);
  json["description"] = key.help + " " + facts_text(key) + ".";
  (*place)["properties"][word] = json;
  if (key.required) (*place)["required"].append(word);
}

/// Whether every case has the table, and has to give some of its keys.
bool is_required(const Table& table) {
  if (table.repeated || table.count(Case{}) == 0) return false;
  for (const Key& key : schema())
    if (key.required && key.table() == table.name) return true;
  return false;
}

Json with_keys(const Table& table, const std::string& help) {
  Json json = table_schema(help);
  for (const Key& key : schema())
    if (key.table() == table.name) add_key(json, key);
  return json;
}

}  // namespace

std::string json_schema() {
  Json root = with_keys(*find_table(""), "A scene of softwet; 'softwet check' finds what this schema cannot.");
  root["$schema"] = "http://json-schema.org/draft-07/schema#";
  root["title"] = "a case of softwet";
  for (const Table& table : tables()) {
    if (table.name.empty()) continue;
    std::string name = table.name.substr(0, table.name.find('['));
    const Json one = with_keys(table, table.help + ".");
    Json* parent = &root;
    if (const auto dot = name.find('.'); dot != std::string::npos) {  // a table in a table, which comes first
      parent = &root["properties"][name.substr(0, dot)];
      name = name.substr(dot + 1);
    }
    (*parent)["properties"][name] = table.repeated ? list_of(one) : one;
    if (is_required(table)) root["required"].append(name);
  }
  for (const char* material : {"fluid", "substrate"}) {
    Json needs;
    needs["required"].append(material);
    root["anyOf"].append(needs);
  }
  return root.json() + "\n";
}

}  // namespace softwet
