// Known mistakes in the syntax of a line.
#include "casefile/text/syntax_hint.hpp"

#include <fmt/core.h>

#include <map>
#include <regex>

#include "casefile/schema/schema.hpp"
#include "casefile/schema/value.hpp"

namespace softwet {
namespace {

constexpr std::size_t longest = 200;  ///< lines longer than this are not parsed: regular expressions recurse

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  return first == std::string_view::npos ? ""
                                         : std::string(text.substr(first, text.find_last_not_of(" \t\r") - first + 1));
}

/// Without the comment, which begins at a '#' outside of quotes.
std::string_view without_comment(std::string_view line) {
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote == 0 && line[i] == '#') return line.substr(0, i);
    if (line[i] == '"' || line[i] == '\'') quote = quote == 0 ? line[i] : quote == line[i] ? 0 : quote;
  }
  return line;
}

/// The line, and the table it is in: "fluid.", "load[1].", "" at the top of the file.
struct Place {
  std::string_view line;
  std::string table;
};

Place find_place(std::string_view text, long line) {
  Place place;
  std::map<std::string, long> entries;
  for (long number = 1; number <= line; ++number) {
    const auto end = text.find('\n');
    place.line = text.substr(0, end);
    const std::string header = trimmed(without_comment(place.line));
    if (header.size() > 4 && header.compare(0, 2, "[[") == 0) {
      const std::string name = trimmed(std::string_view(header).substr(2, header.find(']') - 2));
      place.table = fmt::format("{}[{}].", name, entries[name]++);
    } else if (header.size() > 2 && header.front() == '[' && header.back() == ']') {
      place.table = header.substr(1, header.size() - 2) + ".";
    }
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return place;
}

const std::string decimal = R"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)";

/// Entries of a list, at commas outside of parentheses; none where there are quotes or lists in it.
std::vector<std::string> entries_of_list(std::string_view text) {
  if (text.size() < 3 || text.front() != '[' || text.back() != ']') return {};
  text = text.substr(1, text.size() - 2);
  if (text.find_first_of("\"'[]{}") != std::string_view::npos) return {};
  std::vector<std::string> entries(1);
  int depth = 0;
  for (const char letter : text) {
    depth += (letter == '(') - (letter == ')');
    if (letter == ',' && depth == 0) {
      entries.emplace_back();
    } else {
      entries.back() += letter;
    }
  }
  for (std::string& entry : entries) entry = trimmed(entry);
  return entries;
}

/// An expression, or a list of expressions, without quotes, where the key may have one.
std::optional<SyntaxHint> hint_of_expression(const std::string& key, const std::string& leaf,
                                             const std::string& value) {
  const Key* known = find_key(std::regex_replace(key, std::regex(R"(\[\d*\])"), "[]"));
  if (known == nullptr || value.find_first_of("\"'") != std::string::npos) return {};
  const std::string problem = "an expression has to be in quotes";
  static const std::regex with_unit(decimal + R"(\s*[A-Za-z%].*)");
  if (known->kind == Kind::profile && value.find_first_of("xyzt(*^") != std::string::npos &&
      !std::regex_match(value, with_unit))
    return SyntaxHint{key, value, problem, fmt::format("write {} = {}", leaf, in_quotes(value))};
  if (known->kind != Kind::profiles) return {};
  if (const auto quoted = with_quoted_expressions(value))
    return SyntaxHint{key, value, problem, fmt::format("write {} = {}", leaf, *quoted)};
  return {};
}

/// A mistake that shows in the value alone.
std::optional<SyntaxHint> hint_of(const std::string& key, const std::string& leaf, const std::string& value) {
  static const std::regex ratio(decimal + R"(\s*/\s*)" + decimal), comma(R"(([+-]?\d+),(\d+(?:[eE][+-]?\d+)?))"),
      point(R"(([+-]?)(\d*)\.(\d*)((?:[eE][+-]?\d+)?))"), unit("(" + decimal + R"()\s*[^\d\s,\]\[{}="'.eE+-].*)"),
      word(R"([A-Za-z_][\w .-]*)");
  std::smatch found;
  if (const auto hint = hint_of_expression(key, leaf, value)) return hint;
  if (value.find_first_of("\"'") == std::string::npos && std::regex_search(value, found, ratio))
    return SyntaxHint{key, value, "a ratio has to be in quotes",
                      fmt::format("write {} = {}{}{}", leaf, std::string(found.prefix()), in_quotes(found.str()),
                                  std::string(found.suffix()))};
  if (std::regex_match(value, found, comma))
    return SyntaxHint{key, value, "a decimal number has a point, not a comma",
                      fmt::format("write {} = {}.{}", leaf, found.str(1), found.str(2))};
  if (std::regex_match(value, found, point) && (found.length(2) == 0) != (found.length(3) == 0))
    return SyntaxHint{key, value, "a decimal number has digits on both sides of its point",
                      fmt::format("write {} = {}{}.{}{}", leaf, found.str(1), found.length(2) ? found.str(2) : "0",
                                  found.length(3) ? found.str(3) : "0", found.str(4))};
  if (std::regex_match(value, found, unit))
    return SyntaxHint{key, value, "is a number and something else; numbers of a case have no units",
                      fmt::format("write {} = {} in the unit that 'softwet explain' gives; 'softwet units' converts",
                                  leaf, found.str(1))};
  if (std::regex_match(value, word))
    return SyntaxHint{key, value, "text has to be in quotes", fmt::format("write {} = {}", leaf, in_quotes(value))};
  if (value.empty())
    return SyntaxHint{key, "", "has no value", fmt::format("write {} = VALUE, or remove the line", leaf)};
  return {};
}

}  // namespace

std::optional<std::string> with_quoted_expressions(std::string_view list) {
  std::string text;
  bool expressions = false;
  for (const std::string& entry : entries_of_list(list)) {
    const bool number = number_from_text(entry).has_value() && entry.find('/') == std::string::npos;
    if (entry.empty()) return {};
    expressions = expressions || !number;
    text += (text.empty() ? "" : ", ") + (number ? entry : in_quotes(entry));
  }
  if (!expressions) return {};
  return "[" + text + "]";
}

std::optional<SyntaxHint> syntax_hint(std::string_view text, long line) {
  const Place place = find_place(text, line);
  if (place.line.size() > longest) return {};
  static const std::regex assignment(R"(\s*([\w.-]+)\s*=\s*(.*))"), colon(R"(\s*([\w.-]+)\s*:\s*(.*))");
  const std::string statement(without_comment(place.line));
  std::smatch found;
  if (std::regex_match(statement, found, assignment))
    return hint_of(place.table + found.str(1), found.str(1), trimmed(found.str(2)));
  if (std::regex_match(statement, found, colon))
    return SyntaxHint{place.table + found.str(1), "", "a key and its value are joined by '='",
                      fmt::format("write {} = {}", found.str(1), trimmed(found.str(2)))};
  return {};
}

}  // namespace softwet
