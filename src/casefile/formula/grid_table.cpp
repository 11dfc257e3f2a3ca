// Tables on grids: what they are named by, and how they are interpolated.
#include "casefile/formula/grid_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iterator>
#include <utility>

#include "casefile/formula/expression.hpp"
#include "casefile/schema/value.hpp"

namespace softwet {
namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() > end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// FNV-1a over the bits of numbers.
void add_bits(const std::vector<double>& numbers, std::uint64_t& sum) {
  for (const double number : numbers) {
    std::uint64_t bits;
    std::memcpy(&bits, &number, sizeof bits);
    for (int i = 0; i < 8; ++i) sum = (sum ^ ((bits >> (8 * i)) & 255)) * 1099511628211u;
  }
}

}  // namespace

bool GridTable::is_path(const std::string& text) { return ends_with(text, ".csv") || ends_with(text, ".h5"); }

bool GridTable::is_other_file(const std::string& text) {
  const char* const endings[] = {".xlsx", ".xls", ".ods",  ".txt", ".dat", ".tsv",
                                 ".npy",  ".mat", ".hdf5", ".CSV", ".H5"};
  return std::any_of(std::begin(endings), std::end(endings), [&](const char* end) { return ends_with(text, end); });
}

GridTable::GridTable(const std::string& path, const std::vector<std::string>& variables) {
  GridData data = ends_with(path, ".csv") ? read_csv_grid(path, variables) : read_hdf5_grid(path, variables);
  axes_ = std::move(data.axes);
  values_ = std::move(data.values);
}

GridTable::GridTable(std::vector<double> times, std::vector<double> values)
    : axes_{{std::size_t(3), std::move(times)}}, values_(std::move(values)) {}

bool GridTable::is_pairs(const std::string& text) { return text.rfind("[[", 0) == 0; }

GridTable GridTable::of_pairs(const std::string& text) {
  const std::string remedy = "write [[t, value], ...] with times that increase";
  std::vector<double> numbers[2];
  std::size_t count = 0;
  constexpr const char* between = "[], ";
  for (std::size_t begin = text.find_first_not_of(between); begin != std::string::npos; ++count) {
    const std::size_t end = std::min(text.find_first_of(between, begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const auto number = number_from_text(word);
    if (!number || !std::isfinite(*number))
      throw FormulaError(fmt::format("is a table over time with '{}', which is not a number", word), remedy);
    numbers[count % 2].push_back(*number);
    begin = text.find_first_not_of(between, end);
  }
  const auto& [times, values] = numbers;
  if (times.empty() || times.size() != values.size())
    throw FormulaError("is a table over time without pairs of a time and a value", remedy);
  const auto late = std::adjacent_find(times.begin(), times.end(), std::greater_equal<>());
  if (late != times.end())
    throw FormulaError(fmt::format("is a table over time that has t = {:.10g} after {:.10g}", *(late + 1), *late),
                       remedy);
  return {times, values};
}

double GridTable::at(const std::array<double, 3>& x, double t) const {
  const std::array<double, 4> place{x[0], x[1], x[2], t};
  std::array<std::size_t, 4> low{};
  std::array<double, 4> part{};  // of the next point
  for (std::size_t d = 0; d < axes_.size(); ++d) {
    const auto& points = axes_[d].points;
    const double s = std::clamp(place[axes_[d].variable], points.front(), points.back());
    const auto above = std::upper_bound(points.begin(), points.end(), s);
    low[d] = std::min<std::size_t>(above - points.begin() - 1, std::max<std::size_t>(points.size(), 2) - 2);
    if (points.size() > 1) part[d] = (s - points[low[d]]) / (points[low[d] + 1] - points[low[d]]);
  }
  double sum = 0;
  for (std::size_t corner = 0; corner < (std::size_t(1) << axes_.size()); ++corner) {
    double weight = 1;
    std::size_t index = 0;
    for (std::size_t d = 0; d < axes_.size(); ++d) {
      const bool up = (corner >> d) & 1;
      weight *= up ? part[d] : 1 - part[d];
      index = index * axes_[d].points.size() + std::min(low[d] + (up ? 1 : 0), axes_[d].points.size() - 1);
    }
    if (weight != 0) sum += weight * values_[index];
  }
  return sum;
}

std::vector<double> GridTable::kinks() const {
  for (const GridAxis& axis : axes_)
    if (axis.variable == 3) return axis.points;
  return {};
}

std::string GridTable::identity() const {
  std::uint64_t sum = 14695981039346656037u;
  for (const GridAxis& axis : axes_) {
    add_bits({static_cast<double>(axis.variable), static_cast<double>(axis.points.size())}, sum);
    add_bits(axis.points, sum);
  }
  add_bits(values_, sum);
  return fmt::format("table of {} values, checksum {:016x}", values_.size(), sum);
}

}  // namespace softwet
