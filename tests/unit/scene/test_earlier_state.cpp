// The fields of an earlier run on another mesh: linear ones stay, in two and three dimensions and on each process.
#include "scene/earlier_state.hpp"

#include <gtest/gtest.h>

#include "scene/greville_points.hpp"

namespace softwet {
namespace {

template <int D>
Layout<D> layout_of(const std::array<int, D>& elements, int solid_elements, int degree) {
  Layout<D> l;
  l.solid_elements = solid_elements;
  l.row_size = 1;
  for (int d = 0; d < D; ++d) {
    l.axis.emplace_back(1 + 0.3 * d, elements[d], degree, false, d == D - 1 ? solid_elements : 0);
    if (d < D - 1) l.row_size *= l.axis[d].functions();
  }
  l.rows = l.axis[D - 1].functions();
  l.wall_row = l.axis[D - 1].span(solid_elements);
  return l;
}

/// A function of each component that splines hold with the values at Greville points as control values.
struct Line final : Formula {
  int component;
  explicit Line(int of) : component(of) {}
  double at(const std::array<double, 3>& x, double) const override {
    return 0.1 + component + 0.3 * x[0] - 0.2 * x[1] * (component + 1) + 0.7 * x[2];
  }
};

Profile line(int component) {
  Profile profile;
  profile.formula = std::make_shared<Line>(component);
  return profile;
}

template <int D>
EarlierState lines_on(const Layout<D>& l) {
  EarlierState state{l.axis, l.solid_elements, true, true, {}, {}};
  const auto append = [&](std::vector<double>& to, int component, int first, int rows) {
    const std::vector<double> values = control_values(l, line(component), first, rows);
    to.insert(to.end(), values.begin(), values.end());
  };
  for (int d = 0; d < D; ++d) append(state.unknown, d, 0, l.rows);
  append(state.unknown, 5, l.wall_row, l.fluid_rows());
  append(state.unknown, 6, l.wall_row, l.fluid_rows());
  for (int d = 0; d < D; ++d) append(state.displacement, 7 + d, 0, l.solid_rows());
  return state;
}

template <int D>
void check(const EarlierState& from, const Layout<D>& l) {
  std::vector<double> unknown(l.size(), NAN), displacement(l.solid_size(), NAN);
  give_earlier(from, l, unknown, displacement);
  const EarlierState expected = lines_on(l);
  ASSERT_EQ(expected.unknown.size(), unknown.size());
  ASSERT_EQ(expected.displacement.size(), displacement.size());
  for (std::size_t i = 0; i < unknown.size(); ++i) ASSERT_NEAR(unknown[i], expected.unknown[i], 1e-12) << i;
  for (std::size_t i = 0; i < displacement.size(); ++i)
    ASSERT_NEAR(displacement[i], expected.displacement[i], 1e-12) << i;
}

TEST(EarlierState, LinearFieldsStayOnOtherMeshesAndDegrees) {
  const EarlierState plane = lines_on(layout_of<2>({5, 6}, 2, 2));
  check(plane, layout_of<2>({5, 6}, 2, 2));
  check(plane, layout_of<2>({7, 9}, 3, 2));
  check(plane, layout_of<2>({8, 3}, 1, 3));
  const EarlierState space = lines_on(layout_of<3>({5, 4, 6}, 2, 2));
  check(space, layout_of<3>({5, 4, 6}, 2, 2));
  check(space, layout_of<3>({3, 6, 9}, 3, 2));
  check(space, layout_of<3>({4, 4, 3}, 1, 3));
}

TEST(EarlierState, EachProcessHasItsColumns) {
  const EarlierState from = lines_on(layout_of<2>({40, 6}, 2, 2));
  for (int rank : {0, 1}) {
    Layout<2> l = layout_of<2>({80, 6}, 2, 2);
    l.columns = cut_columns(l.axis[0], rank, 2, 1);
    l.row_size = l.extent(0);
    ASSERT_LT(l.row_size, l.axis[0].functions());
    check(from, l);
  }
}

TEST(EarlierState, ADensityStaysBetweenItsControlValues) {
  const Layout<2> fine = layout_of<2>({16, 6}, 2, 2), coarse = layout_of<2>({5, 6}, 2, 2);
  EarlierState from = lines_on(fine);
  double* density = from.unknown.data() + fine.density_offset();
  for (int i = 0; i < fine.scalar_size(); ++i) density[i] = i % fine.row_size < 8 ? 0.001 : 0.9;
  std::vector<double> unknown(coarse.size()), displacement(coarse.solid_size());
  give_earlier(from, coarse, unknown, displacement);
  for (int i = 0; i < coarse.scalar_size(); ++i) {
    EXPECT_GE(unknown[coarse.density_offset() + i], 0.001);
    EXPECT_LE(unknown[coarse.density_offset() + i], 0.9);
  }
}

TEST(EarlierState, ARigidWallTakesTheFluidAlone) {
  const EarlierState from = lines_on(layout_of<2>({5, 6}, 2, 2));
  EarlierState rigid = from;
  rigid.has_solid = false;
  rigid.solid_elements = 0;
  rigid.axis[1] = Axis(1.3, 6, 2);
  Layout<2> l = layout_of<2>({5, 6}, 0, 2);
  l.has_solid = false;
  l.wall_row = 0;
  rigid.unknown.clear();
  const auto append = [&](int component) {
    const std::vector<double> values = control_values(l, line(component), 0, l.rows);
    rigid.unknown.insert(rigid.unknown.end(), values.begin(), values.end());
  };
  for (int component : {0, 1, 5, 6}) append(component);
  std::vector<double> unknown(l.size(), NAN), displacement;
  give_earlier(rigid, l, unknown, displacement);
  for (std::size_t i = 0; i < unknown.size(); ++i) EXPECT_NEAR(unknown[i], rigid.unknown[i], 1e-12);
}

}  // namespace
}  // namespace softwet
