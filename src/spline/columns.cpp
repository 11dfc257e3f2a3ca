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

Columns cut_before(const Axis& axis, int rank, const std::vector<int>& first_function, int beside) {
  const int elements = axis.elements(), functions = axis.functions(), degree = axis.degree();
  Columns c;
  c.rank = rank;
  c.ranks = static_cast<int>(first_function.size()) - 1;
  c.first_function = first_function;
  c.beside = beside = std::min(std::max(beside, degree), elements);
  const bool around = axis.periodic() && c.ranks > 1;
  const int first = first_function[rank], last = first_function[rank + 1];
  const int low = around && rank > 0 ? first - beside : std::max(0, first - beside);
  const int high = around ? last + beside : std::min(last + beside, functions);
  for (int f = low; f < high; ++f) c.function.push_back(f < 0 ? f + elements : f < functions ? f : f - elements);
  c.begin = first - low;
  c.end = last - low;
  ElementColumns& e = c.elements;
  e.run[0] = {std::max(0, first - degree) - low, std::min(last, elements) - low, low};
  e.runs = 1;
  e.own_begin = first - low;
  e.own_end = std::min(last, elements) - low;
  if (around && rank == 0) {
    const int stored = c.stored(), begin = stored + beside - degree;
    for (int f = elements - beside; f < functions; ++f) c.function.push_back(f);
    e.run[1] = {begin, begin + degree, elements - degree - begin};
    e.runs = 2;
  }
  return c;
}

Columns cut_columns(const Axis& axis, int rank, int ranks, int beside) {
  const int strips = strips_of(axis.elements());
  std::vector<int> first;
  for (int r = 0; r < ranks; ++r) first.push_back(strip_width * first_strip(strips, r, ranks));
  first.push_back(axis.functions());
  Columns c = cut_before(axis, rank, first, beside);
  c.elements.first_strip = first_strip(strips, rank, ranks);
  c.elements.last_strip = first_strip(strips, rank + 1, ranks);
  c.elements.strips = strips;
  return c;
}

std::vector<int> places_of_functions(const Axis& axis, const Columns& c) {
  std::vector<int> place(axis.functions(), -1);
  for (int f = 0; f < axis.functions() && c.stored() == 0; ++f) place[f] = f;
  for (int i = 0; i < c.stored(); ++i) {
    int& p = place[axis.periodic() ? c.function[i] % axis.owned() : c.function[i]];
    const bool repeats = axis.periodic() && c.function[i] >= axis.owned();
    if (p < 0 || (c.own(i) && !repeats)) p = i;
  }
  for (int f = axis.owned(); f < axis.functions(); ++f) place[f] = place[f - axis.owned()];
  return place;
}

}  // namespace softwet
