#include "io/table_rows.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "case/error.hpp"
#include "io/number_text.hpp"

namespace softwet {
namespace {

/// Goes through the whole lines below the header and refuses what no run writes.
class Rows {
 public:
  Rows(const std::string& path, const std::string& text, const std::vector<std::string>& columns)
      : path_(path), text_(text), columns_(columns), begin_(header_line(columns).size()) {
    const std::string header = header_line(columns);
    if (text.compare(0, header.size(), header) != 0)
      refuse_table(path + ":1", "the header is '" + text.substr(0, text.find('\n')) + "' where this run writes '" +
                                    header.substr(0, header.size() - 1) + "'");
  }

  /// Goes on to the next row. False behind the last one that is whole.
  bool next() {
    const std::size_t end = text_.find('\n', begin_);
    if (end == std::string::npos) return false;
    line_ = text_.substr(begin_, end + 1 - begin_);
    begin_ = end + 1;
    ++number_;
    const double first = first_number();
    const std::size_t cells = 1 + static_cast<std::size_t>(std::count(line_.begin(), line_.end(), ','));
    if (cells != columns_.size())
      refuse("the row has " + std::to_string(cells) + " cells for " + std::to_string(columns_.size()) + " columns");
    const bool steps = columns_[0] == "step";
    if (steps && (first < 0 || first != std::floor(first)))
      refuse("the step is " + number_text(first) + " where a run writes whole numbers, 0 or more");
    if (steps ? first <= last_ : first < last_)
      refuse(columns_[0] + " " + number_text(first) + " follows " + number_text(last_) + " where a run writes rows " +
             (steps ? "whose step rises" : "in their order"));
    last_ = first;
    return true;
  }
  int number() const { return number_; }  ///< of the last line

 private:
  [[noreturn]] void refuse(const std::string& problem) const {
    refuse_table(path_ + ":" + std::to_string(number_), problem);
  }
  double first_number() const {
    double number = 0;
    const auto [end, error] = std::from_chars(line_.data(), line_.data() + line_.size(), number);
    const bool whole_cell = *end == ',' || *end == '\n';
    if (error != std::errc() || !whole_cell || !std::isfinite(number))
      refuse("the row does not start with a " + (columns_[0] == "step" ? "step number" : "number, " + columns_[0]));
    return number;
  }

  const std::string &path_, &text_;
  const std::vector<std::string>& columns_;
  std::size_t begin_;
  std::string line_;
  int number_ = 1;
  double last_ = -std::numeric_limits<double>::infinity();
};

}  // namespace

void refuse_table(const std::string& place, const std::string& problem) {
  throw Error(Exit::invalid_input, place + ": " + problem +
                                       "; put back the file as the run wrote it, put an empty file in its place to go "
                                       "on with a table that begins here, or start anew without --resume");
}

std::string header_line(const std::vector<std::string>& columns) {
  std::string line;
  for (const std::string& column : columns) line += (line.empty() ? "" : ",") + column;
  return line + "\n";
}

std::string rows_up_to_mark(const std::string& path, const std::string& text, const std::vector<std::string>& columns,
                            const TableMark& mark) {
  Rows rows(path, text, columns);
  std::string kept = text.substr(0, static_cast<std::size_t>(std::max<std::int64_t>(0, mark.bytes)));
  TableMark found;
  found.add(kept);
  if (found.bytes == mark.bytes && found.checksum == mark.checksum) return kept;
  std::int64_t count = 0;
  while (count < mark.rows && rows.next()) ++count;
  const std::string written = std::to_string(mark.rows) + " rows that the run had written up to its checkpoint";
  if (count < mark.rows)
    refuse_table(path + ":" + std::to_string(rows.number()),
                 "the file ends here, after " + std::to_string(count) + " of the " + written);
  refuse_table(path, "the rows in lines 2 to " + std::to_string(rows.number()) + " are not the " + written +
                         ": their checksum is another one");
}

}  // namespace softwet
