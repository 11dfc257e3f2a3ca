// The record of a run (run.json): nested keys and values in the order they were set, written as JSON.
#pragma once

#include <concepts>
#include <cstdint>
#include <list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace softwet {

/// A JSON value: text, number, yes/no, list or object; a fresh one is an empty object.
///   RunRecord run;  run["threads"] = 8;  run["timings"]["residual"] = 1.25;  run["stops"].append("end reached");
class RecordValue {
 public:
  using List = std::vector<RecordValue>;
  using Object = std::list<std::pair<std::string, RecordValue>>;  // references to values stay valid

  RecordValue() : content_(Object{}) {}
  RecordValue(bool value) : content_(value) {}
  RecordValue(double value) : content_(value) {}
  template <std::integral T>
  RecordValue(T value) : content_(static_cast<std::int64_t>(value)) {}
  RecordValue(const char* value) : content_(std::string(value)) {}
  RecordValue(std::string value) : content_(std::move(value)) {}
  RecordValue(List values) : content_(std::move(values)) {}

  /// The value of a key, made (empty object) where it is new. A value that was no object becomes an empty one.
  RecordValue& operator[](const std::string& key);

  /// Adds to a list. A value that was no list becomes an empty one first.
  void append(RecordValue value);

  /// JSON text, indented by two blanks per level. Numbers that are not finite, which JSON lacks, are written as null.
  std::string json(int level = 0) const;

 private:
  std::variant<Object, List, std::string, double, std::int64_t, bool> content_;
};

/// The whole of run.json.
class RunRecord {
 public:
  RecordValue& operator[](const std::string& key) { return root_[key]; }
  std::string json() const { return root_.json() + "\n"; }

  /// Replaces the file atomically. Throws Error (machine_failed).
  void write(const std::string& path) const;

 private:
  RecordValue root_;
};

}  // namespace softwet
