#include "io/run_record.hpp"

#include <cmath>

#include "io/atomic_file.hpp"
#include "io/json_text.hpp"
#include "io/number_text.hpp"

namespace softwet {
namespace {

/// Keeps the type visible: 2.0 stays a real number for readers that tell it from 2.
std::string json_number(double value) {
  if (!std::isfinite(value)) return "null";
  const std::string text = number_text(value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string json_of(std::int64_t value, int) { return std::to_string(value); }
std::string json_of(double value, int) { return json_number(value); }
std::string json_of(bool value, int) { return value ? "true" : "false"; }
std::string json_of(const std::string& value, int) { return json_string(value); }

std::string new_line(int level) { return "\n" + std::string(2 * static_cast<std::size_t>(level), ' '); }

std::string json_of(const RecordValue::List& values, int level) {
  std::string text;
  for (const RecordValue& value : values) {
    text += (text.empty() ? "" : ",") + new_line(level + 1) + value.json(level + 1);
  }
  return values.empty() ? "[]" : "[" + text + new_line(level) + "]";
}

std::string json_of(const RecordValue::Object& entries, int level) {
  std::string text;
  for (const auto& [key, value] : entries) {
    text += (text.empty() ? "" : ",") + new_line(level + 1) + json_string(key) + ": " + value.json(level + 1);
  }
  return entries.empty() ? "{}" : "{" + text + new_line(level) + "}";
}

}  // namespace

RecordValue& RecordValue::operator[](const std::string& key) {
  if (!std::holds_alternative<Object>(content_)) content_ = Object{};
  Object& entries = std::get<Object>(content_);
  for (auto& [name, value] : entries) {
    if (name == key) return value;
  }
  return entries.emplace_back(key, RecordValue()).second;
}

void RecordValue::append(RecordValue value) {
  if (!std::holds_alternative<List>(content_)) content_ = List{};
  std::get<List>(content_).push_back(std::move(value));
}

std::string RecordValue::json(int level) const {
  return std::visit([level](const auto& content) { return json_of(content, level); }, content_);
}

void RunRecord::write(const std::string& path) const { write_text_atomically(path, json(), AtomicFile::Folder::there); }

}  // namespace softwet
