// Text to value and back.
#include "casefile/schema/value.hpp"

#include <fmt/core.h>

#include <charconv>
#include <cmath>

#include "io/output_time.hpp"

namespace softwet {
namespace {

std::string_view without_spaces(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Without each '_' between two digits: TOML writes 1_000 for 1000.
std::string without_separators(std::string_view text) {
  const auto digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] != '_' || i == 0 || !digit(i - 1) || !digit(i + 1)) plain += text[i];
  return plain;
}

double without_sign_of_zero(double number) { return number == 0 ? 0 : number; }

std::optional<double> plain_number(std::string_view with_separators) {
  const std::string digits = without_separators(without_spaces(with_separators));
  std::string_view text = digits;
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  double number = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (status != std::errc{} || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return without_sign_of_zero(number);
}

std::string text_of_numbers(const Numbers& numbers) {
  std::string text = "[";
  for (std::size_t i = 0; i < numbers.size(); ++i) text += (i ? ", " : "") + text_of_number(numbers[i]);
  return text + "]";
}

}  // namespace

std::optional<double> number_from_text(std::string_view text) {
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) return plain_number(text);
  const auto above = plain_number(text.substr(0, slash));
  const auto below = plain_number(text.substr(slash + 1));
  if (!above || !below || *below == 0.0) return std::nullopt;
  return without_sign_of_zero(*above / *below);
}

std::optional<Numbers> range_from_text(std::string_view text) {
  const auto first_colon = text.find(':');
  if (first_colon == std::string_view::npos) return std::nullopt;
  const auto second_colon = text.find(':', first_colon + 1);
  if (second_colon == std::string_view::npos) return std::nullopt;
  const auto first = number_from_text(text.substr(0, first_colon));
  const auto last = number_from_text(text.substr(first_colon + 1, second_colon - first_colon - 1));
  const auto count = plain_number(text.substr(second_colon + 1));
  if (!first || !last || !count || !(*count >= 2 && *count <= 10000) || *count != std::floor(*count))
    return std::nullopt;
  Numbers numbers;
  for (double i = 0; i < *count; ++i) numbers.push_back(short_decimal(*first + (*last - *first) * (i / (*count - 1))));
  numbers.back() = *last;
  return numbers;
}

std::string text_of_number(double number) { return fmt::format("{}", without_sign_of_zero(number)); }

std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\u{:04X}", byte);
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string text_of_value(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return text_of_number(*number);
  if (const auto* text = std::get_if<std::string>(&value)) return in_quotes(*text);
  if (const auto* numbers = std::get_if<Numbers>(&value)) return text_of_numbers(*numbers);
  std::string text = "[";
  if (const auto* words = std::get_if<Words>(&value)) {
    for (const std::string& word : *words) text += (text.size() > 1 ? ", " : "") + in_quotes(word);
    return text + "]";
  }
  for (const Numbers& corner : std::get<std::vector<Numbers>>(value)) {
    text += (text.size() > 1 ? ", " : "") + text_of_numbers(corner);
  }
  return text + "]";
}

}  // namespace softwet
