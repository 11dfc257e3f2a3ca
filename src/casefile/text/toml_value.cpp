// Kinds of values as TOML writes them.
#include "casefile/text/toml_value.hpp"

#include <cmath>
#include <sstream>

namespace softwet {
namespace {

/// A number of the kind number or integer.
std::optional<double> number_of(const toml::node& node, Kind kind) {
  std::optional<double> number;
  if (const auto* integer = node.as_integer()) number = static_cast<double>(integer->get());
  if (const auto* floating = node.as_floating_point()) number = floating->get();
  if (const auto* text = node.as_string()) number = number_from_text(text->get());
  if (number && kind == Kind::integer && *number != std::floor(*number)) return std::nullopt;
  if (number && *number == 0) number = 0.0;  // without its sign
  return number;
}

/// Numbers of that kind each.
std::optional<Numbers> numbers_of(const toml::node& node, Kind kind) {
  const toml::array* list = node.as_array();
  if (!list) return std::nullopt;
  Numbers numbers;
  for (const toml::node& entry : *list) {
    const auto number = number_of(entry, kind);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// A number, or the numbers of a range. TOML takes 10:50:11 without quotes for a time of day.
std::optional<Numbers> moments_of(const toml::node& node) {
  if (const auto number = number_of(node, Kind::number)) return Numbers{*number};
  if (const auto* text = node.as_string()) return range_from_text(text->get());
  if (node.is_time()) return range_from_text(text_of_node(node));
  return std::nullopt;
}

/// Numbers and ranges in a list, or one of them. A range that begins where the entry before ends does not repeat it.
std::optional<Numbers> times_of(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (!list) return moments_of(node);
  Numbers times;
  for (const toml::node& entry : *list) {
    const auto moments = moments_of(entry);
    if (!moments) return std::nullopt;
    const bool repeats = moments->size() > 1 && !times.empty() && times.back() == moments->front();
    times.insert(times.end(), moments->begin() + (repeats ? 1 : 0), moments->end());
  }
  return times;
}

std::optional<Words> names_of(const toml::node& node) {
  if (const auto* text = node.as_string()) return Words{text->get()};
  const toml::array* list = node.as_array();
  if (!list) return std::nullopt;
  Words names;
  for (const toml::node& entry : *list) {
    const auto* name = entry.as_string();
    if (!name) return std::nullopt;
    names.push_back(name->get());
  }
  return names;
}

/// Rows [t, a, b, ..] of one length, two numbers or more.
std::optional<std::vector<Numbers>> rows_of(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (!list || list->empty()) return std::nullopt;
  std::vector<Numbers> rows;
  for (const toml::node& entry : *list) {
    const auto row = numbers_of(entry, Kind::number);
    if (!row || row->size() < 2 || (!rows.empty() && row->size() != rows[0].size())) return std::nullopt;
    rows.push_back(*row);
  }
  return rows;
}

/// Each column of rows [t, a, b, ..] as a table over time of its own, "[[t, a], ..]", or as a number where it is one.
Words tables_of(const std::vector<Numbers>& rows) {
  Words tables;
  for (std::size_t column = 1; column < rows[0].size(); ++column) {
    std::vector<Numbers> pairs;
    bool varies = false;
    for (const Numbers& row : rows) {
      pairs.push_back({row[0], row[column]});
      varies = varies || row[column] != rows[0][column];
    }
    tables.push_back(varies ? text_of_value(pairs) : text_of_number(rows[0][column]));
  }
  return tables;
}

std::optional<Value> profile_of(const toml::node& node) {
  if (const auto number = number_of(node, Kind::number)) return Value(*number);
  if (const auto* text = node.as_string()) return Value(text->get());
  if (const auto rows = rows_of(node); rows && (*rows)[0].size() == 2) {
    const std::string table = tables_of(*rows)[0];
    const auto number = number_from_text(table);
    return number ? Value(*number) : Value(table);
  }
  return std::nullopt;
}

/// Each as a text, a number as well.
std::optional<Words> profiles_of(const toml::node& node) {
  if (const auto rows = rows_of(node)) return tables_of(*rows);
  const toml::array* list = node.as_array();
  if (!list) return std::nullopt;
  Words texts;
  for (const toml::node& entry : *list) {
    const auto profile = profile_of(entry);
    if (!profile) return std::nullopt;
    const auto* number = std::get_if<double>(&*profile);
    texts.push_back(number ? text_of_number(*number) : std::get<std::string>(*profile));
  }
  return texts;
}

std::optional<Value> corners_of(const toml::node& node) {
  const toml::array* corners = node.as_array();
  if (!corners || corners->size() != 2) return std::nullopt;
  std::vector<Numbers> box;
  for (const toml::node& corner : *corners) {
    const auto numbers = numbers_of(corner, Kind::number);
    if (!numbers) return std::nullopt;
    box.push_back(*numbers);
  }
  return box;
}

template <class Maybe>
std::optional<Value> widen(const Maybe& value) {
  if (!value) return std::nullopt;
  return std::optional<Value>(std::in_place, *value);
}

}  // namespace

std::optional<Value> value_of_node(const toml::node& node, Kind kind) {
  switch (kind) {
    case Kind::number:
      return widen(number_of(node, Kind::number));
    case Kind::integer:
      return widen(number_of(node, Kind::integer));
    case Kind::numbers:
      return widen(numbers_of(node, Kind::number));
    case Kind::integers:
      return widen(numbers_of(node, Kind::integer));
    case Kind::box:
      return corners_of(node);
    case Kind::times:
      return widen(times_of(node));
    case Kind::names:
      return widen(names_of(node));
    case Kind::profile:
      return profile_of(node);
    case Kind::profiles:
      return widen(profiles_of(node));
    case Kind::text:
    case Kind::choice:
      break;
  }
  return widen(node.value<std::string>());
}

std::string text_of_node(const toml::node& node) {
  if (const auto* text = node.as_string()) return in_quotes(text->get());
  if (const auto* number = node.as_floating_point()) return text_of_number(number->get());
  if (node.is_table()) return "{...}";
  if (const toml::array* list = node.as_array()) {
    std::string text = "[";
    for (const toml::node& entry : *list) text += (text.size() > 1 ? ", " : "") + text_of_node(entry);
    return text + "]";
  }
  std::ostringstream out;
  node.visit([&](const auto& value) {
    if constexpr (toml::is_value<decltype(value)>) out << value;
  });
  return out.str();
}

}  // namespace softwet
