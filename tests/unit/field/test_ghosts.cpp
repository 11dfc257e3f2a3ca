// Ghosts of periodic axes: copies of what they repeat, and the transpose.
#include "field/ghosts.hpp"

#include <gtest/gtest.h>

#include "field/vector.hpp"

namespace softwet {
namespace {

template <int D>
Layout<D> layout(const std::array<bool, D>& periodic) {
  Layout<D> l;
  l.solid_elements = 2;
  l.row_size = 1;
  for (int d = 0; d < D; ++d) {
    l.axis.emplace_back(1.0, 4 + d, 2, periodic[d] ? AxisKind::periodic : AxisKind::bounded,
                        d == D - 1 && !periodic[d] ? 2 : 0);
    if (d < D - 1) l.row_size *= l.axis[d].functions();
  }
  l.rows = l.axis[D - 1].functions();
  l.wall_row = l.axis[D - 1].span(2);
  return l;
}

std::vector<double> numbers(int n) {
  std::vector<double> v(n);
  for (int i = 0; i < n; ++i) v[i] = std::sin(1.0 + 2.3 * i);
  return v;
}

TEST(Ghosts, UpdateRepeatsTheOwnedValues) {
  const Layout<2> l = layout<2>({true, false});
  const Array x = to_device<Array>(numbers(l.size()));
  const std::vector<double> before = to_host(x);
  move_ghosts(l, x, GhostAction::update);
  const std::vector<double> after = to_host(x);
  const int n = l.axis[0].functions(), owned = l.axis[0].owned();
  for (int i = 0; i < l.size(); ++i) EXPECT_EQ(after[i], before[i % n < owned ? i : i - owned]) << i;
}

TEST(Ghosts, BoxesCoverTheVectorOnce) {
  for (const bool fluid : {true, false}) {
    Layout<3> l = layout<3>({true, true, false});
    l.has_fluid = fluid;
    int next = 0;
    for (const Box<3>& b : boxes(l)) {
      EXPECT_EQ(b.offset, next);
      next += b.extent[0] * b.extent[1] * b.extent[2];
    }
    EXPECT_EQ(next, l.size());
    EXPECT_EQ(boxes(l).size(), fluid ? 5u : 3u);
  }
}

/// (add y) . x = y . (update x) for x without ghosts, and ghosts are left at zero.
template <int D>
void add_is_the_transpose(const std::array<bool, D>& periodic) {
  const Layout<D> l = layout<D>(periodic);
  std::vector<double> owned = numbers(l.size());
  const Array y = to_device<Array>(numbers(l.size() + 1));
  const Array cut = Kokkos::subview(y, Kokkos::make_pair(1, l.size() + 1));
  const Array original = to_device<Array>(to_host(cut));
  move_ghosts(l, cut, GhostAction::add);
  const Array x = to_device<Array>(owned);
  move_ghosts(l, x, GhostAction::update);
  EXPECT_NEAR(dot(alone, cut, x), dot(alone, original, x), 1e-12);  // ghosts of cut are zero: only owned values count
  const std::vector<double> sum = to_host(cut);
  for (const Box<D>& b : boxes(l)) {
    int count = 1;
    for (int d = 0; d < D; ++d) count *= b.extent[d];
    for (int i = 0; i < count; ++i) {
      bool ghost = false;
      for (int d = 0, rest = i; d < D; ++d) {
        ghost = ghost || (l.axis[d].periodic() && rest % b.extent[d] >= l.axis[d].owned());
        rest /= b.extent[d];
      }
      if (ghost) {
        EXPECT_EQ(sum[b.offset + i], 0);
      }
    }
  }
}
TEST(Ghosts, AddIsTheTranspose) {
  add_is_the_transpose<2>({true, false});
  add_is_the_transpose<2>({false, false});
  add_is_the_transpose<3>({true, false, false});
  add_is_the_transpose<3>({true, true, false});
}

}  // namespace
}  // namespace softwet
