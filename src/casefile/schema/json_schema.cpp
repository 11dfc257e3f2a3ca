#include "casefile/schema/json_schema.hpp"

#include <cmath>
#include <sstream>

#include "casefile/schema/laboratory_quantities.hpp"
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

Json list_of(const Json& items, std::size_t least, std::size_t most) {
  Json json = list_of(items);
  json["minItems"] = static_cast<std::int64_t>(least);
  json["maxItems"] = static_cast<std::int64_t>(most);
  return json;
}

/// A list with one of the numbers of entries that the key allows: runs of them, [0, 2, 3] is empty, or 2 to 3 entries.
Json list_of_lengths(const Key& key, const Json& items) {
  if (key.lengths.empty()) return list_of(items);
  std::vector<Json> runs;
  for (std::size_t i = 0, first = 0; i < key.lengths.size(); ++i) {
    if (i + 1 < key.lengths.size() && key.lengths[i + 1] == key.lengths[i] + 1) continue;
    runs.push_back(list_of(items, key.lengths[first], key.lengths[i]));
    first = i + 1;
  }
  return runs.size() == 1 ? runs[0] : one_of(runs);
}

/// A number in the range of the key; whole ones as integers, so that an editor shows them as such.
Json plain_number(const Key& key, Kind kind) {
  const bool whole = kind == Kind::integer;
  const auto bound = [whole](double value) { return whole ? Json(static_cast<std::int64_t>(value)) : Json(value); };
  Json json = of_type(whole ? "integer" : "number");
  const Range& range = key.range;
  const bool above_zero = range.low == 0 && range.low_open && !whole;
  const double low = above_zero ? smallest_number : std::isfinite(range.low) ? range.low : -largest_number;
  const double high = std::isfinite(range.high) ? range.high : largest_number;
  if (!whole || std::isfinite(range.low))
    json[range.low_open && low == range.low ? "exclusiveMinimum" : "minimum"] = bound(low);
  if (!whole || std::isfinite(range.high))
    json[range.high_open && high == range.high ? "exclusiveMaximum" : "maximum"] = bound(high);
  return json;
}

/// A number, or a number or a ratio in quotes, whose value the schema cannot see.
Json number_or_ratio(const Key& key, Kind kind) { return one_of({plain_number(key, kind), text_like(ratio)}); }

Json choice_of(const Key& key) {
  Json json = of_type("string");
  for (const std::string& choice : key.choices) json["enum"].append(choice);
  return json;
}

/// Times and ranges of them; one time where the key takes one at most.
Json times_of(const Key& key) {
  const bool one = key.lengths.size() && key.lengths.back() == 1;
  const Json text = text_like(one ? ratio : range_of_times), moment = one_of({plain_number(key, Kind::number), text});
  return one_of({plain_number(key, Kind::number), text, list_of_lengths(key, moment)});
}

Json schema_of_box(const Key& key) { return list_of(list_of_lengths(key, number_or_ratio(key, Kind::number)), 2, 2); }

/// Rows [t, value, ..] with so many values.
Json table_over_time(std::size_t least, std::size_t most) {
  Json rows = list_of(list_of(number_or_ratio(Key{}, Kind::number), least + 1, most + 1));
  rows["minItems"] = 1;
  return rows;
}

/// A quoted text is an expression or the path of a table, but for a number with a decimal comma.
Json profile_of(const Key& key) {
  std::vector<Json> kinds{plain_number(key, Kind::number), of_type("string")};
  if (key.support == Support::time) kinds.push_back(table_over_time(1, 1));
  return one_of(kinds);
}

Json text_of(const Key& key) {
  if (key.letters.empty()) return of_type("string");
  const std::string any = "A-Za-z0-9" + key.letters, first = key.first.empty() ? any : key.first;
  const std::string more = key.longest > 0 ? "{0," + std::to_string(key.longest - 1) + "}" : "*";
  return text_like("[" + first + "][" + any + "]" + more);
}

Json type_of(const Key& key) {
  switch (key.kind) {
    case Kind::number:
      return number_or_ratio(key, Kind::number);
    case Kind::integer:
      return number_or_ratio(key, Kind::integer);
    case Kind::numbers:
      return list_of_lengths(key, number_or_ratio(key, Kind::number));
    case Kind::integers:
      return list_of_lengths(key, number_or_ratio(key, Kind::integer));
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
      if (key.support == Support::time) return one_of({list_of_lengths(key, profile_of(key)), table_over_time(2, 3)});
      return list_of_lengths(key, profile_of(key));
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
  if (key.required && !may_follow(key.name)) (*place)["required"].append(word);
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

/// The keys that a case has to give where it has no table [laboratory] from whose quantities they might follow.
Json keys_without_quantities() {
  Json root;
  for (const Key& key : schema()) {
    if (!key.required || !may_follow(key.name)) continue;
    const Table& table = *find_table(key.table());
    Json& one = root["properties"][table.name.substr(0, table.name.find('['))];
    (table.repeated ? one["items"] : one)["required"].append(key.leaf());
  }
  return root;
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
  Json with_quantities;
  with_quantities["required"].append("laboratory");
  root["anyOf"].append(with_quantities);
  for (const char* material : {"fluid", "substrate"}) {
    Json needs = keys_without_quantities();
    needs["required"].append(material);
    root["anyOf"].append(needs);
  }
  return root.json() + "\n";
}

}  // namespace softwet
