// A table that grows by rows (history.csv, interface.csv): comma-separated, one header line, safe to resume.
#pragma once

#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace softwet {

/// Appends rows of numbers. Numbers are written in the shortest form that reads back equal, whole numbers as integers.
/// The first column is the step and does not decrease.
class TableFile {
 public:
  /// Starts a new table; an existing file is replaced. @param columns  names, the first is the step
  /// Throws Error (machine_failed).
  static TableFile create(const std::string& path, const std::vector<std::string>& columns);

  /// Continues the table of a run resumed from a checkpoint: rows with a step greater than `step` and a last row cut
  /// short are dropped (the file is replaced atomically). A missing or empty file is started anew.
  /// Throws Error: invalid_input when the header differs or a row does not start with a number, machine_failed.
  static TableFile append_after(const std::string& path, const std::vector<std::string>& columns, double step);

  TableFile(TableFile&&) = default;
  TableFile& operator=(TableFile&&) = delete;
  ~TableFile();

  /// Adds a row. @param values  one per column, std::nullopt: not applicable, an empty cell.
  /// Reaches the file at most a second later if rows keep coming, else at `flush()` or destruction.
  /// Throws Error: computation_failed for a number that is not finite or a wrong count, machine_failed.
  void row(const std::vector<std::optional<double>>& values);

  /// Hands the rows so far to the system; to be called before a checkpoint is committed. Throws Error (machine_failed).
  void flush();

  /// Whether its path still leads to the file that is written: not where somebody has removed or replaced it.
  bool in_place() const;

  /// Where it does not: writes all rows there, atomically. What stood there is kept as PATH.replaced. Rows that are added
  /// afterwards are lost. Throws Error (machine_failed).
  void put_back();

  const std::string& path() const { return path_; }
  /// Its folder has another path now.
  void moved_to(const std::string& path) { path_ = path; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  TableFile(const std::string& path, const std::vector<std::string>& columns, const char* mode);

  std::string path_;
  std::vector<std::string> columns_;
  std::unique_ptr<std::FILE, Close> file_;
  std::string pending_;
  std::chrono::steady_clock::time_point last_flush_;
};

}  // namespace softwet
