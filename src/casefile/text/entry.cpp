// One value of a case file, checked against its key.
#include "casefile/text/entry.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "casefile/schema/nearest.hpp"
#include "casefile/text/syntax_hint.hpp"

namespace softwet {
namespace {

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

/// What to write instead of a word that is not among the choices.
std::string remedy_for(const Key& key, const std::string& word) {
  for (const FormerChoice& former : key.former)
    if (word == former.word)
      return fmt::format("write {} = {}, which {}", key.leaf(), in_quotes(former.now), former.reason);
  const std::string nearest = nearest_name(word, key.choices);
  return nearest.empty() ? fmt::format("write for example {} = {}", key.leaf(), example_text(key))
                         : fmt::format("did you mean {}?", in_quotes(nearest));
}

void check_range(const Key& key, const Value& value, const std::string& name, const std::string& text,
                 const std::string& place) {
  for (double number : numbers_of(value)) {
    if (!key.range.contains(number)) {
      const std::string reason = key.reason.empty() ? "" : key.reason + "; ";
      reject(place, name, text, "must be a " + allowed_text(key),
             fmt::format("{}write for example {} = {}", reason, key.leaf(), example_text(key)));
    }
    if (number != 0 && (std::abs(number) < smallest_number || std::abs(number) > largest_number))
      reject(place, name, text, fmt::format("must be 0 or between {} and {} in size", smallest_number, largest_number),
             "choose the scales L0, a, b of the case so that its numbers are near 1");
  }
  for (const std::string& word : words_of(key, value)) {
    if (std::find(key.choices.begin(), key.choices.end(), word) != key.choices.end()) continue;
    reject(place, name, text, (key.kind == Kind::choice ? "must be " : "must be a ") + allowed_text(key),
           remedy_for(key, word));
  }
}

/// What to write instead of a value of the wrong kind.
std::string remedy_for(const Key& key, const toml::node& node) {
  if (const auto* text = node.as_string(); text && key.kind != Kind::text && key.kind != Kind::choice) {
    std::string point = text->get();
    if (const auto comma = point.find(','); comma != std::string::npos) point[comma] = '.';
    if (const auto number = number_from_text(point); number && point != text->get())
      return fmt::format("a decimal number has a point: write {} = {}", key.leaf(), text_of_number(*number));
  }
  if (const auto* text = node.as_string(); text && key.kind == Kind::profiles)
    if (const auto quoted = with_quoted_expressions(text->get()))
      return fmt::format("an expression in a list has to be in quotes: write {} = {}, after --set in single quotes",
                         key.leaf(), *quoted);
  const bool ratio = key.kind == Kind::number && key.example.find('/') == std::string::npos;
  return fmt::format("write for example {} = {}{}", key.leaf(), example_text(key), ratio ? " or a ratio \"3/8\"" : "");
}

/// "0,5" where a number or an expression may stand.
bool has_decimal_comma(const toml::node& node) {
  const auto* text = node.as_string();
  if (!text) return false;
  std::string point = text->get();
  const auto comma = point.find(',');
  return comma != std::string::npos && number_from_text(point.replace(comma, 1, "."));
}

}  // namespace

Entry make_entry(const Key& key, std::size_t index, const toml::node& node, const std::string& place) {
  const std::string name = indexed_name(key.name, index), text = text_of_node(node);
  const auto value = value_of_node(node, key.kind);
  if (!value || (key.kind == Kind::profile && has_decimal_comma(node))) {
    const std::string article = key.kind == Kind::choice || key.kind == Kind::text ? "" : "a ";
    reject(place, name, text, "must be " + article + allowed_text(key), remedy_for(key, node));
  }
  check_range(key, *value, name, text, place);
  return {&key, index, *value, text, place};
}

}  // namespace softwet
