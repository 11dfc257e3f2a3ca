// A checkpoint as the visits of a run see it: what they write, and what they read and judge.
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "io/checkpoint_file.hpp"
#include "run/host/run_memory.hpp"

namespace softwet {

/// Writes what is visited.
class EntriesToFile final : public RunEntries {
 public:
  explicit EntriesToFile(CheckpointWriter& file) : file_(file) {}

  bool restores() const override { return false; }
  void number(const std::string& name, double& value) override { file_.value(name, value); }
  using RunEntries::count;
  void count(const std::string& name, std::int64_t& value) override { file_.value(name, value); }
  void text(const std::string& name, std::string& value) override { file_.value(name, value); }
  void numbers(const std::string& name, std::vector<double>& values) override { file_.array(name, values); }
  void list(const std::string& name, std::vector<double>& values) override;
  [[noreturn]] void refuse(const std::string& name, const std::string& found, const std::string& needed) const override;

 private:
  CheckpointWriter& file_;
};

/// Puts back what was written. All methods throw Error (invalid_input) naming the file and the entry where something is
/// missing, or is nothing that a run writes: not finite, a negative time, step or count.
class EntriesFromFile final : public RunEntries {
 public:
  explicit EntriesFromFile(const std::string& path) : path_(path), file_(path) {}

  /// Throws Error (invalid_input) where the checkpoint belongs to another case.
  void require_case(const Case&) const;

  bool restores() const override { return true; }
  void number(const std::string& name, double& value) override;
  using RunEntries::count;
  void count(const std::string& name, std::int64_t& value) override;
  void text(const std::string& name, std::string& value) override { value = file_.text(name); }
  void numbers(const std::string& name, std::vector<double>& values) override { values = array(name, values.size()); }
  void list(const std::string& name, std::vector<double>& values) override;
  [[noreturn]] void refuse(const std::string& name, const std::string& found, const std::string& needed) const override;

  /// An array of that many finite numbers.
  std::vector<double> array(const std::string& name, std::size_t size) const;
  /// Whether there is a text of this name that says the same.
  bool says(const std::string& name, const std::string& text) const;

 private:
  std::string path_;
  CheckpointReader file_;
};

}  // namespace softwet
