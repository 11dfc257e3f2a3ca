// Columns of an axis cut for several processes: each belongs to one of them, with all that its rows need.
#include "spline/columns.hpp"

#include <gtest/gtest.h>

#include <set>

namespace softwet {
namespace {

/// Whether all functions within `beside` columns of the own ones are stored, and each own function in its own column.
void check_beside(const Axis& axis, const Columns& c, int beside) {
  const std::vector<int> place = places_of_functions(axis, c);
  const int own_end = std::min(c.first_function[c.rank + 1], axis.owned());
  for (int f = c.first_function[c.rank] - beside; f < own_end + beside; ++f) {
    const int n = axis.owned(), function = axis.periodic() ? (f + n) % n : f;
    if (function < 0 || function >= n) continue;
    ASSERT_GE(place[function], 0) << "function " << f << " of rank " << c.rank;
    EXPECT_EQ(c.function[place[function]] % n, function);
    const bool own = f >= c.first_function[c.rank] && f < own_end;
    EXPECT_TRUE(!own || c.own(place[function]));
  }
}

void check_cut(const Axis& axis, int ranks, int beside) {
  std::multiset<int> functions, elements;
  int strips = 0;
  for (int rank = 0; rank < ranks; ++rank) {
    const Columns c = cut_columns(axis, rank, ranks, beside);
    check_beside(axis, c, std::max(beside, axis.degree()));
    for (int i = c.begin; i < c.end; ++i) functions.insert(c.function[i]);
    const ElementColumns& e = c.elements;
    EXPECT_EQ(e.first_strip, strips);
    strips = e.last_strip;
    for (int l = e.own_begin; l < e.own_end; ++l) elements.insert(l + e.run[0].shift);
    std::set<int> run;  // the functions of stored elements are stored, in order
    for (int r = 0; r < e.runs; ++r)
      for (int l = e.run[r].begin; l < e.run[r].end; ++l) {
        const int element = l + e.run[r].shift;
        EXPECT_TRUE(run.insert(element).second);
        for (int a = 0; a <= axis.degree(); ++a) EXPECT_EQ(c.function[l + a], axis.span(element) + a);
      }
    for (int i = c.begin; i < c.end; ++i)  // every element on which an own control point lives
      for (int e2 = c.function[i] - axis.degree(); e2 <= c.function[i]; ++e2) {
        if (c.function[i] >= axis.owned()) continue;
        const int n = axis.elements(), element = axis.periodic() ? (e2 + n) % n : e2;
        if (element >= 0 && element < n) {
          EXPECT_TRUE(run.count(element)) << "rank " << rank << " column " << c.function[i];
        }
      }
  }
  EXPECT_EQ(strips, most_ranks(axis));
  ASSERT_EQ(functions.size(), static_cast<std::size_t>(axis.functions()));
  ASSERT_EQ(elements.size(), static_cast<std::size_t>(axis.elements()));
  for (int f = 0; f < axis.functions(); ++f) EXPECT_EQ(functions.count(f), 1u);
  for (int e = 0; e < axis.elements(); ++e) EXPECT_EQ(elements.count(e), 1u);
}

TEST(Columns, EachBelongsToOneProcessThatHasWhatItNeeds) {
  for (const AxisKind kind : {AxisKind::bounded, AxisKind::periodic})
    for (const int degree : {2, 3})
      for (const int elements : {5, 8, 16, 23, 44})
        for (int ranks = 1; ranks <= std::max(1, elements / strip_width); ++ranks)
          for (int beside : {0, 3, 7})
            if (beside <= elements) check_cut(Axis(1.0, elements, degree, kind), ranks, beside);
}

TEST(Columns, OneProcessStoresEachOnce) {
  const Columns c = cut_columns(Axis(1.0, 23, 2, AxisKind::periodic), 0, 1);
  EXPECT_EQ(c.stored(), 25);
  EXPECT_EQ(c.begin, 0);
  EXPECT_EQ(c.end, 25);
  EXPECT_EQ(c.elements.runs, 1);
  EXPECT_EQ(c.elements.run[0].end, 23);
}

}  // namespace
}  // namespace softwet
