// A table that grows by rows (history.csv, interface.csv): comma-separated, one header line, safe to resume.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "io/table_row.hpp"

namespace softwet {

/// The beginning of a table, so that it is known again: its bytes, its rows below the header, and a checksum of the
/// bytes (FNV-1a, Fowler, Noll and Vo).
struct TableMark {
  std::int64_t bytes = 0, rows = 0;
  std::uint32_t checksum = 2166136261u;

  void add(const std::string& lines);
  bool operator==(const TableMark&) const = default;
};

/// Appends rows of numbers. Numbers are written in the shortest form that reads back equal, whole numbers as integers.
/// A first column with the name "step" holds whole numbers that rise; another one does not fall.
class TableFile {
 public:
  /// Starts a new table; an existing file is replaced. @param columns  names
  /// Throws Error (machine_failed).
  static TableFile create(const std::string& path, const std::vector<std::string>& columns);

  /// Continues the table of a run resumed from a checkpoint. Rows behind the mark are dropped (the file is replaced
  /// atomically). An empty file begins a new table here.
  /// Throws Error: invalid_input when the file is missing or differs from what was written up to the mark, with the
  /// first line that cannot be from a run; machine_failed.
  static TableFile append_after(const std::string& path, const std::vector<std::string>& columns, const TableMark&);

  TableFile(TableFile&&) = default;
  TableFile& operator=(TableFile&&) = delete;
  ~TableFile();

  /// Adds a row, its cells in the order of the columns.
  /// Reaches the file at most a second later if rows keep coming, else at `flush()` or destruction.
  /// Throws Error: computation_failed for a number that is not finite, machine_failed; std::logic_error for a column
  /// without a cell and for a cell without a column.
  void row(const TableRow&);

  /// Makes all rows so far those that a resumed run goes on behind.
  void keep() { kept_ = all_; }
  const TableMark& kept() const { return kept_; }

  /// Hands the rows so far to the system. Throws Error (machine_failed), from the first failure on each time: rows are
  /// missing then, and no checkpoint may refer to them.
  void flush();
  /// Brings the rows so far to the disk; to be called before a checkpoint that holds their mark is committed.
  /// Throws Error (machine_failed).
  void bring_to_disk();

  /// Whether its path still leads to the file that is written: not where somebody has removed or replaced it.
  bool in_place() const;

  /// Where it does not: writes all rows there, atomically. What stood there is kept as PATH.replaced. Rows that are
  /// added afterwards are lost. Throws Error (machine_failed).
  void put_back();

  const std::string& path() const { return path_; }
  /// Its folder has another path now.
  void moved_to(const std::string& path) { path_ = path; }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  TableFile(const std::string& path, const std::vector<std::string>& columns, const char* mode);
  static TableFile go_on(const std::string& path, const std::vector<std::string>& columns, const std::string& text,
                         const std::string& kept);
  /// The header and the rows that are there already.
  void begin_after(const std::string& lines);

  std::string path_;
  std::vector<std::string> columns_;
  std::unique_ptr<std::FILE, Close> file_;
  std::string pending_;
  TableMark all_, kept_;
  int failed_ = 0;  ///< errno of the first failure
  std::chrono::steady_clock::time_point last_flush_;
};

}  // namespace softwet
