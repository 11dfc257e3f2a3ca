// What a checkpoint holds beside the arrays of the state, visited by name. No Kokkos, so it can be tested and fuzzed
// alone.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <vector>

#include "io/table_file.hpp"
#include "observe/host/history_memory.hpp"

namespace softwet {

/// Visits the numbers, texts and lists of a checkpoint under their names. The same visit writes them and reads them, so
/// that neither can forget what the other has.
class RunEntries {
 public:
  virtual ~RunEntries() = default;

  /// Whether the visit puts values back. Else it looks at them.
  virtual bool restores() const = 0;
  virtual void number(const std::string& name, double& value) = 0;       ///< finite
  virtual void count(const std::string& name, std::int64_t& value) = 0;  ///< 0 or more
  virtual void text(const std::string& name, std::string& value) = 0;
  /// Finite, and as many as there are now.
  virtual void numbers(const std::string& name, std::vector<double>& values) = 0;
  /// Finite, and as many as the count `name`/count says.
  virtual void list(const std::string& name, std::vector<double>& values) = 0;
  /// Throws Error (invalid_input): no run writes this.
  [[noreturn]] virtual void refuse(const std::string& name, const std::string& found,
                                   const std::string& needed) const = 0;

  void not_negative(const std::string& name, double& value);
  void positive(const std::string& name, double& value);
  void flag(const std::string& name, bool& value);
  template <std::integral Count>
  void count(const std::string& name, Count& value) {
    std::int64_t wide = value;
    count(name, wide);
    value = static_cast<Count>(wide);
    if (value != wide) refuse(name, "is " + std::to_string(wide), "a smaller count");
  }
  /// One member of all items of a list, as an array. @param member  (Item&) -> reference to a number or a flag
  template <class Item, class Member>
  void column(const std::string& name, std::vector<Item>& items, Member member) {
    std::vector<double> values;
    for (Item& item : items) values.push_back(static_cast<double>(member(item)));
    numbers(name, values);
    for (std::size_t i = 0; i < items.size(); ++i)
      member(items[i]) = static_cast<std::remove_cvref_t<decltype(member(items[i]))>>(values[i]);
  }
};

/// What a run has written beside its checkpoint.
struct WrittenFiles {
  TableMark history, interface;     ///< rows of history.csv and interface.csv
  std::vector<double> field_times;  ///< t of the field files, in the order of their numbers
};

/// Where a run is. Times are on the clock of the computation.
struct RunMemory {
  double time = 0;
  double previous_dt = 0;  ///< 0 before the first step
  double proposed_dt = 0;
  long steps = 0, rejected_newton = 0, rejected_error = 0;
  double memory_shift = 0;  ///< of the state (field/stage.hpp)
  HistoryMemory history;    ///< with the bodies of the case: their number is not part of the file
  WrittenFiles files;
};

/// Visits all of it.
void visit(RunEntries&, RunMemory&);

}  // namespace softwet
