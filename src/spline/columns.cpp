#include "spline/columns.hpp"

#include <algorithm>
#include <cstdint>

namespace softwet {
namespace {

int strips_of(int elements) { return std::max(1, elements / strip_width); }

/// First strip of a rank.
int first_strip(int strips, int rank, int ranks) { return static_cast<int>(std::int64_t(strips) * rank / ranks); }

}  // namespace

ElementColumns whole_elements(int elements) {
  ElementColumns e;
  e.run[0] = {0, elements, 0};
  e.runs = 1;
  e.own_end = elements;
  e.strips = e.last_strip = strips_of(elements);
  return e;
}

int most_ranks(const Axis& axis) { return strips_of(axis.elements()); }

Columns cut_columns(const Axis& axis, int rank, int ranks) {
  const int elements = axis.elements(), functions = axis.functions(), degree = axis.degree();
  const int strips = strips_of(elements);
  Columns c;
  c.rank = rank;
  c.ranks = ranks;
  for (int r = 0; r < ranks; ++r) c.first_function.push_back(strip_width * first_strip(strips, r, ranks));
  c.first_function.push_back(functions);
  const int first = c.first_function[rank], last = c.first_function[rank + 1];
  const int low = std::max(0, first - degree), high = std::min(last + degree, functions);
  for (int f = low; f < high; ++f) c.function.push_back(f);
  c.begin = first - low;
  c.end = last - low;
  ElementColumns& e = c.elements;
  e.run[0] = {0, std::min(last, elements) - low, low};
  e.runs = 1;
  e.own_begin = first - low;
  e.own_end = std::min(last, elements) - low;
  e.first_strip = first_strip(strips, rank, ranks);
  e.last_strip = first_strip(strips, rank + 1, ranks);
  e.strips = strips;
  if (axis.periodic() && rank == 0 && ranks > 1) {
    const int stored = c.stored();
    for (int f = elements - degree; f < functions; ++f) c.function.push_back(f);
    e.run[1] = {stored, stored + degree, elements - degree - stored};
    e.runs = 2;
  }
  return c;
}

}  // namespace softwet
