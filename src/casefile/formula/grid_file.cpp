#include "casefile/formula/grid_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <optional>

#include "case/error.hpp"
#include "casefile/formula/expression.hpp"
#include "casefile/schema/value.hpp"
#include "io/hdf5_file.hpp"

namespace softwet {
namespace {

const std::string variables_of_all = "xyzt";
constexpr std::size_t most_values = 50'000'000;

std::string names_of_axes(const std::vector<std::string>& variables) {
  std::string text;
  for (const std::string& name : variables) text += (text.empty() ? "" : ", ") + name;
  return text;
}

char separator_of(const std::string& line) {
  for (const char separator : {',', ';', '\t'})
    if (line.find(separator) != std::string::npos) return separator;
  return ',';
}

/// Lines of a CSV file as rows of cells, with their numbers. The first line shows what stands between two columns: a
/// comma, else a semicolon, else a tabulator.
class CsvLines {
 public:
  explicit CsvLines(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    if (!file_ || file_.peek() == std::ifstream::traits_type::eof())
      throw FormulaError(
          fmt::format("the table {} cannot be read: {}", path, errno ? std::strerror(errno) : "it is empty"),
          "a path in a case is relative to the folder of the case");
  }

  /// The next line that holds something; false at the end.
  bool next(std::vector<std::string>& cells) {
    for (std::string line; next_line(line);) {
      if (++number_ == 1) begin(line);
      if (line.find_first_not_of(" \t") == std::string::npos || line[0] == '#') continue;
      if (separator_ == 0) separator_ = separator_of(line);
      cells.assign(1, "");
      for (const char letter : line) {
        if (letter == separator_) {
          cells.emplace_back();
        } else if (letter != ' ' && letter != '\t' && letter != '"') {
          cells.back() += letter;
        }
      }
      return true;
    }
    return false;
  }

  [[noreturn]] void refuse(std::size_t column, const std::string& problem, const std::string& remedy) const {
    throw FormulaError(fmt::format("{}:{}: column {}: {}", path_, number_, column + 1, problem), remedy);
  }
  [[noreturn]] void refuse(const std::string& problem, const std::string& remedy) const {
    throw FormulaError(fmt::format("{}:{}: {}", path_, number_, problem), remedy);
  }
  long number() const { return number_; }

 private:
  /// A line ends with a line feed, a carriage return, or both.
  bool next_line(std::string& line) {
    constexpr int end = std::char_traits<char>::eof();
    std::streambuf& bytes = *file_.rdbuf();
    line.clear();
    int byte = bytes.sbumpc();
    if (byte == end) return false;
    for (; byte != end && byte != '\n' && byte != '\r'; byte = bytes.sbumpc()) line += static_cast<char>(byte);
    if (byte == '\r' && bytes.sgetc() == '\n') bytes.sbumpc();
    return true;
  }
  /// Takes the mark of UTF-8 away, which Excel writes, and refuses what is not text in UTF-8.
  void begin(std::string& line) const {
    const std::string remedy = "save the table as CSV in UTF-8, in Excel as 'CSV UTF-8'";
    if (line.rfind("PK\x03\x04", 0) == 0) refuse("the file is a workbook of Excel and not CSV", remedy);
    const std::string mark = line.substr(0, 2);
    if (mark == "\xff\xfe" || mark == "\xfe\xff" || line.find('\0') != std::string::npos)
      refuse("the file is in UTF-16", remedy);
    if (line.rfind("\xef\xbb\xbf", 0) == 0) line.erase(0, 3);
  }

  std::string path_;
  std::ifstream file_;
  long number_ = 0;
  char separator_ = 0;
};

/// What a CSV file holds: the columns of its axes, and the values.
struct CsvColumns {
  std::vector<std::size_t> variable;
  std::vector<std::vector<double>> points;  ///< of each axis
  std::vector<double> value;
  std::vector<long> line;
};

CsvColumns read_columns(CsvLines& lines, const std::vector<std::string>& variables) {
  const std::string remedy =
      fmt::format("the first line names the columns: some of {}, and value as the last", names_of_axes(variables));
  std::vector<std::string> cells;
  if (!lines.next(cells)) lines.refuse("there are no columns", remedy);
  CsvColumns found;
  for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
    const bool twice = std::find(cells.begin(), cells.begin() + i, cells[i]) != cells.begin() + i;
    if (twice || std::find(variables.begin(), variables.end(), cells[i]) == variables.end())
      lines.refuse(i, fmt::format("'{}' is not an axis of this table", cells[i]), remedy);
    found.variable.push_back(variables_of_all.find(cells[i]));
  }
  if (cells.back() != "value" || found.variable.empty())
    lines.refuse(cells.size() - 1, fmt::format("'{}' is not 'value' after an axis", cells.back()), remedy);
  found.points.resize(found.variable.size());
  const std::size_t columns = cells.size();
  while (lines.next(cells)) {
    if (cells.size() != columns)
      lines.refuse(fmt::format("has {} columns, the first line has {}", cells.size(), columns),
                   "a comma separates two columns, and decimal numbers have a point");
    for (std::size_t i = 0; i < columns; ++i) {
      const auto number = number_from_text(cells[i]);
      if (!number || !std::isfinite(*number))
        lines.refuse(i, fmt::format("'{}' is not a number", cells[i]),
                     cells[i].find(',') == std::string::npos ? "write a number" : "decimal numbers have a point: 0.5");
      (i + 1 < columns ? found.points[i] : found.value).push_back(*number);
    }
    found.line.push_back(lines.number());
    if (found.value.size() > most_values) lines.refuse("the table is too long", "take fewer points");
  }
  if (found.value.empty()) lines.refuse("there are no values", "write a line for each point of the grid");
  return found;
}

/// Place of a point in the grid, last axis fastest.
std::size_t place_in(const std::vector<GridAxis>& axes, const CsvColumns& columns, std::size_t row) {
  std::size_t place = 0;
  for (std::size_t d = 0; d < axes.size(); ++d) {
    const auto& points = axes[d].points;
    place = place * points.size() +
            (std::lower_bound(points.begin(), points.end(), columns.points[d][row]) - points.begin());
  }
  return place;
}

}  // namespace

GridData read_csv_grid(const std::string& path, const std::vector<std::string>& variables) {
  GridData data;
  auto& [axes, values] = data;
  errno = 0;
  CsvLines lines(path);
  const CsvColumns columns = read_columns(lines, variables);
  double size = 1;
  for (std::size_t d = 0; d < columns.variable.size(); ++d) {
    std::vector<double> points = columns.points[d];
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    size *= static_cast<double>(points.size());
    axes.push_back({columns.variable[d], points});
  }
  const std::string remedy = "a table has one line for each point of a rectangular grid";
  if (size > static_cast<double>(columns.value.size()))
    throw FormulaError(
        fmt::format("{}: the axes make a grid of {} points, but there are {} lines", path, size, columns.value.size()),
        remedy);
  std::vector<long> line_of(columns.value.size(), 0);
  values.resize(static_cast<std::size_t>(size));
  for (std::size_t row = 0; row < columns.value.size(); ++row) {
    const std::size_t place = place_in(axes, columns, row);
    if (line_of[place] != 0)
      throw FormulaError(fmt::format("{}:{}: this point is in line {} too", path, columns.line[row], line_of[place]),
                         remedy);
    line_of[place] = columns.line[row];
    values[place] = columns.value[row];
  }
  return data;
}

GridData read_hdf5_grid(const std::string& path, const std::vector<std::string>& variables) {
  GridData data;
  auto& [axes, values] = data;
  const std::string remedy =
      fmt::format("a table in HDF5 has a dataset for each axis, out of {}, and the dataset value on their grid",
                  names_of_axes(variables));
  const auto refuse = [&](const std::string& problem) { throw FormulaError(path + ": " + problem, remedy); };
  try {
    const Hdf5File file = Hdf5File::open(path, remedy);
    std::vector<std::size_t> shape;
    for (const std::string& name : variables) {
      if (!file.has(name)) continue;
      GridAxis axis{variables_of_all.find(name), file.read<double>(name)};
      const auto& points = axis.points;
      if (points.empty() || std::adjacent_find(points.begin(), points.end(), std::greater_equal<>()) != points.end())
        refuse("the axis " + name + " does not increase");
      shape.push_back(points.size());
      axes.push_back(std::move(axis));
    }
    if (axes.empty()) refuse("there is no axis");
    if (!file.has("value") || file.shape("value") != shape)
      refuse("there is no dataset value with the shape of the axes");
    values = file.read<double>("value");
  } catch (const Error& error) {
    throw FormulaError(error.what(), "see 'softwet explain' of the key");
  }
  for (const GridAxis& axis : axes)
    if (!std::isfinite(axis.points.front()) || !std::isfinite(axis.points.back())) refuse("an axis is not finite");
  if (!std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }))
    refuse("a value is not finite");
  return data;
}

}  // namespace softwet
