// The fields of an earlier run on another mesh: linear ones stay, in 2D, (r, z) and 3D and on each process, and in (r,
// z) the mass stays.
#include "scene/earlier_state.hpp"

#include <gtest/gtest.h>

#include "scene/greville_points.hpp"

namespace softwet {
namespace {

template <int D>
Layout<D> layout_of(const std::array<int, D>& elements, int solid_elements, int degree,
                    AxisKind first = AxisKind::bounded) {
  Layout<D> l;
  l.solid_elements = solid_elements;
  l.row_size = 1;
  for (int d = 0; d < D; ++d) {
    l.axis.emplace_back(1 + 0.3 * d, elements[d], degree, d == 0 ? first : AxisKind::bounded,
                        d == D - 1 ? solid_elements : 0);
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

TEST(EarlierState, LinearFieldsStayAroundAnAxis) {
  const EarlierState from = lines_on(layout_of<2>({5, 6}, 2, 2, AxisKind::radial));
  check(from, layout_of<2>({5, 6}, 2, 2, AxisKind::radial));
  check(from, layout_of<2>({7, 9}, 3, 2, AxisKind::radial));
  check(from, layout_of<2>({8, 3}, 1, 3, AxisKind::radial));
}

/// A ball of liquid on the axis of symmetry, in vapour.
struct Ball final : Formula {
  double at(const std::array<double, 3>& x, double) const override {
    const double distance = std::hypot(x[0], x[1] - 0.85) - 0.3;
    return 0.06 + 0.27 * (1 - std::tanh(distance / 0.05));
  }
};

Profile ball() {
  Profile profile;
  profile.formula = std::make_shared<Ball>();
  return profile;
}

/// int rho r dr dz over the fluid by many points.
double mass_of_ball(const Layout<2>& l) {
  const Gauss gauss(4);
  constexpr int parts = 400;
  const double low = l.axis[1].lower(l.solid_elements), height = l.axis[1].length() - low, width = l.axis[0].length();
  double sum = 0;
  for (int i = 0; i < 4 * parts; ++i)
    for (int j = 0; j < 4 * parts; ++j) {
      const double r = width * (i / 4 + gauss.point[i % 4]) / parts;
      const double z = low + height * (j / 4 + gauss.point[j % 4]) / parts;
      sum += gauss.weight[i % 4] * gauss.weight[j % 4] * r * Ball().at({r, z, 0}, 0);
    }
  return sum * width * height / (parts * parts);
}

/// Mass of the control values of a density.
double mass_of(const Layout<2>& l, const double* density) {
  const std::vector<double> along = l.axis[0].integrals(0, l.axis[0].length(), 0, l.axis[0].elements()),
                            up = l.axis[1].integrals(0, l.axis[1].length(), l.solid_elements, l.axis[1].elements());
  double sum = 0;
  for (int j = 0; j < l.fluid_rows(); ++j)
    for (int i = 0; i < l.row_size; ++i) sum += along[i] * up[l.wall_row + j] * density[j * l.row_size + i];
  return sum;
}

// A droplet that starts on a mesh has its mass up to an error; a droplet of an earlier run keeps its mass on another
// mesh far better. Averaged without the weight r it would miss it by some millionths.
TEST(EarlierState, AroundAnAxisTheMassStaysOnOtherMeshes) {
  const Layout<2> old = layout_of<2>({30, 36}, 6, 2, AxisKind::radial);
  EarlierState from = lines_on(old);
  const std::vector<double> start = control_values(old, ball(), old.wall_row, old.fluid_rows());
  std::copy(start.begin(), start.end(), from.unknown.begin() + old.density_offset());
  const double exact = mass_of_ball(old), before = mass_of(old, start.data());
  EXPECT_NEAR(before / exact, 1, 2e-3);
  for (const Layout<2>& now :
       {layout_of<2>({22, 24}, 4, 2, AxisKind::radial), layout_of<2>({35, 42}, 7, 3, AxisKind::radial)}) {
    std::vector<double> unknown(now.size()), displacement(now.solid_size());
    give_earlier(from, now, unknown, displacement);
    const double error_of_start =
        std::abs(mass_of(now, control_values(now, ball(), now.wall_row, now.fluid_rows()).data()) / exact - 1);
    const double error = std::abs(mass_of(now, &unknown[now.density_offset()]) / before - 1);
    EXPECT_LT(error, 1e-8);
    EXPECT_LT(error, 0.01 * error_of_start);
  }
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
