// A scene as a sum of terms: residual against the reference assembly, product against differences, sides, integrals.
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

/// Body force, for the reference assembly: the box is cut along element borders.
struct BoxForce {
  double force[2];
  template <class N, int D>
  using Trial = SolidTrial<N, D>;
  template <class N, int D>
  using Test = MomentumTest<N, D>;
  MomentumTest<double, 2> residual(const SolidTrial<double, 2>&) const { return {{{-force[0], -force[1]}}, {}}; }
};

/// Rows of the fluid added to the wall's with the weights (1 - Greville height): the wall's function blended over the
/// fluid is that sum of B-splines.
std::vector<double> blend_rows(const Layout<2>& l, const std::vector<double>& rows) {
  std::vector<double> sum(rows.size(), 0.0);
  const double low = l.axis[1].lower(l.solid_elements), height = l.axis[1].length() - low;
  for (int d = 0; d < 2; ++d)
    for (int j = l.wall_row; j < l.rows; ++j)
      for (int i = 0; i < l.row_size; ++i)
        sum[l.velocity_offset(d) + l.wall_row * l.row_size + i] +=
            (1 - (l.axis[1].greville(j) - low) / height) * rows[l.velocity_offset(d) + j * l.row_size + i];
  return sum;
}

std::vector<double> expected_residual(RandomScene& s) {
  const Layout<2>& l = s.layout();
  const int low = l.solid_elements, high = l.axis[1].elements();
  const TermCases<2>& t = s.terms;
  std::vector<double> sum(l.size(), 0.0);
  if (l.has_solid)
    add(sum, std::visit([&](const auto& solid) { return t.naive(solid, 0, low, false); },
                        s.scene.coefficients().solid().law));
  if (l.has_fluid) {
    const NavierStokesKorteweg& fluid = s.scene.coefficients().fluid();
    add(sum, t.naive(fluid, low, high, l.has_solid));
    add(sum, t.naive_moments(low, high, l.has_solid));
    const double g = s.data.fluid->capillarity;
    if (s.data.fluid->wall_law == WallLaw::gradient) {
      add(sum, t.naive(GradientWall{g, 0.5, 1e-2}, low, low + 1, l.has_solid));
    } else {
      add(sum, t.naive(EnergyWall{g, 0.5, 1e-5, fluid.gas, s.scene.coefficients().coexistence()}, low, low + 1,
                       l.has_solid));
    }
    const CapillaryTraction traction{fluid.gas, g};
    const bool blended = s.data.fluid->traction == Traction::blended;
    if (l.has_solid && blended) add(sum, blend_rows(l, t.naive(traction, low, high, true)));
    if (l.has_solid && !blended) add(sum, t.naive(traction, low, low + 1, true, l.wall_row));
  }
  return sum;
}

/// Adds the load of the scene by quadrature over its elements: columns 3, 4, 5 and the lower half of the solid.
void add_load(RandomScene& s, std::vector<double>& sum) {
  if (s.data.loads.empty()) return;
  const Load& load = s.data.loads[0];
  const double factor = 0.5 * s.data.substrate->density;  // half of the ramp
  for_points<2>(s.layout(), 3, 0, s.layout().solid_elements, false, nullptr, [&](const NaivePoint<2>& p, double w) {
    if (p.x[0] < load.lower[0] || p.x[0] > load.upper[0] || p.x[1] > load.upper[1]) return;
    for (int d = 0; d < 2; ++d)
      p.for_functions(
          -1, [&](int i, double b) { sum[s.layout().velocity_offset(d) + i] -= w * factor * load.force[d] * b; });
  });
}

void check_scene(const Case& c) {
  RandomScene s(c);
  std::vector<double> expected = expected_residual(s);
  add_load(s, expected);
  const Array folded = to_device<Array>(expected);
  move_ghosts(s.layout(), folded, GhostAction::add);
  expected = to_host(folded);
  const std::vector<double> mask = to_host(s.scene.mask());
  for (std::size_t i = 0; i < mask.size(); ++i) expected[i] *= mask[i];
  EXPECT_LT(distance(s.residual(s.stage()), expected), 1e-13);
  const Array z = s.direction();
  const double error = distance(s.product(z, Geometry::exact), s.difference(z, 1e-4));
  std::printf("  product against differences: %.1e\n", error);
  EXPECT_LT(error, 1e-9);
  if (c.fluid && c.substrate) {
    EXPECT_GT(distance(s.product(z, Geometry::frozen), s.difference(z, 1e-4)), 1e-4);
  }
}

TEST(Scene, Coupled) { check_scene(small_case(SceneKind::coupled)); }
TEST(Scene, CoupledWithWallEnergy) { check_scene(small_case(SceneKind::coupled, WallLaw::energy)); }
TEST(Scene, CoupledPeriodic) { check_scene(small_case(SceneKind::coupled, WallLaw::gradient, true)); }
TEST(Scene, CoupledWithBlendedTraction) {
  Case c = small_case(SceneKind::coupled, WallLaw::energy);
  c.fluid->traction = Traction::blended;
  check_scene(c);
}
TEST(Scene, Rigid) { check_scene(small_case(SceneKind::rigid)); }
TEST(Scene, RigidPeriodicWithWallEnergy) { check_scene(small_case(SceneKind::rigid, WallLaw::energy, true)); }
TEST(Scene, CoupledWithGravityAndNeoHookeanSolid) {
  Case c = small_case(SceneKind::coupled);
  c.fluid->gravity = {0.2, -0.6};
  c.substrate->material = MaterialModel::neo_hookean;
  check_scene(c);
}
TEST(Scene, SolidAlone) { check_scene(small_case(SceneKind::solid)); }

TEST(Scene, SceneHasOnlyWhatItAsksFor) {
  const auto names = [](const Case& c) {
    std::string all;
    const Scene<2, 2> scene(c);
    for (const auto& entry : scene.terms().pieces().list) all += std::string(entry.piece->name()) + ";";
    return all;
  };
  EXPECT_EQ(names(small_case(SceneKind::coupled)),
            "saint_venant_kirchhoff;navier_stokes_korteweg;density_moment;contact_angle (gradient law);"
            "capillary_traction;");
  EXPECT_EQ(names(small_case(SceneKind::rigid, WallLaw::energy)),
            "navier_stokes_korteweg;density_moment;contact_angle (wall energy);");
  EXPECT_EQ(names(small_case(SceneKind::solid)), "saint_venant_kirchhoff;");
  Case neutral = small_case(SceneKind::rigid);
  neutral.fluid->contact_angle = 90;
  EXPECT_EQ(names(neutral), "navier_stokes_korteweg;density_moment;");
  const Scene<2, 2> rigid(small_case(SceneKind::rigid)), solid(small_case(SceneKind::solid));
  EXPECT_EQ(rigid.layout().solid_size(), 0);
  EXPECT_EQ(solid.layout().scalar_size(), 0);
  EXPECT_EQ(rigid.layout().size(), 4 * 11 * 8);
  EXPECT_EQ(solid.layout().size(), 2 * 11 * 8);
  const Scene<2, 2> coupled(small_case(SceneKind::coupled));
  EXPECT_EQ(coupled.layout().size(), 2 * 11 * 9 + 2 * 11 * 6);
}

// A second scene of another mesh changes no bit of what the first one sums up.
TEST(Scene, TwoAtOnceHaveTheirOwnSums) {
  Case first = small_case(SceneKind::coupled), second = small_case(SceneKind::coupled);
  first.domain.elements = {45, 6};
  second.domain.elements = {21, 9};
  RandomScene s(first);
  const auto sums = [&s] {
    const VectorSpace space = s.layout().space();
    return std::vector<double>{norm(space, s.stage().unknown), total(space, s.stage().density_end),
                               s.scene.balance().measure(s.stage()).load_power};
  };
  const std::vector<double> before = sums();
  const Scene<2, 2> other(second);
  EXPECT_EQ(sums(), before);
}

TEST(Scene, Sides) {
  Case c = small_case(SceneKind::rigid);
  c.boundary.side[0] = {Side::slip, Side::free};
  c.boundary.side[1] = {Side::slip, Side::no_slip};
  const Scene<2, 2> m(c);
  const std::vector<double> mask = to_host(m.mask());
  const auto at = [&](int d, int i, int j) { return mask[m.layout().velocity_offset(d) + j * 11 + i]; };
  for (int j = 1; j < 7; ++j) {
    EXPECT_EQ(at(0, 0, j), 0);
    EXPECT_EQ(at(1, 0, j), 1);
    EXPECT_EQ(at(0, 10, j), 1);
    EXPECT_EQ(at(1, 10, j), 1);
    EXPECT_EQ(at(0, 5, j), 1);
  }
  for (int i = 1; i < 10; ++i) {
    EXPECT_EQ(at(0, i, 0), 1);
    EXPECT_EQ(at(1, i, 0), 0);
    EXPECT_EQ(at(0, i, 7), 0);
    EXPECT_EQ(at(1, i, 7), 0);
  }
  for (int i = m.layout().density_offset(); i < m.layout().size(); ++i) EXPECT_EQ(mask[i], 1);
}

// Moving every field by one element along a periodic axis moves the residual by one element.
TEST(Scene, PeriodicSidesAreInvariantUnderShifts) {
  Case c = small_case(SceneKind::coupled, WallLaw::gradient, true);
  c.loads.clear();
  RandomScene s(c);
  const int n = s.layout().axis[0].functions(), owned = s.layout().axis[0].owned();
  const auto shift = [&](const std::vector<double>& v) {
    std::vector<double> r(v.size());
    for (std::size_t i = 0; i < v.size(); ++i) {
      const int k = static_cast<int>(i) % n, row = static_cast<int>(i) - k;
      r[i] = v[row + (k + 1) % owned];
    }
    return r;
  };
  std::vector<double> expected = shift(s.residual(s.stage()));
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (static_cast<int>(i) % n >= owned) expected[i] = 0;  // ghosts carry no residual
  for (Array* a : {&s.stage().unknown, &s.stage().acceleration, &s.stage().displacement, &s.stage().displacement_end,
                   &s.stage().density_end})
    *a = to_device<Array>(shift(to_host(*a)));
  EXPECT_LT(distance(s.residual(s.stage()), expected), 1e-12);
}

// The flux part of the mass equation only moves mass about, on a moving mesh as on a fixed one.
TEST(Scene, FluxesOfMassSumToZero) {
  for (const Case& c : {small_case(SceneKind::coupled), small_case(SceneKind::rigid),
                        small_case(SceneKind::coupled, WallLaw::gradient, true)}) {
    RandomScene s(c);
    s.stage().moment_rate = 0;
    const std::vector<double> r = s.residual(s.stage());
    double sum = 0, size = 0;
    for (int i = s.layout().density_offset(); i < s.layout().potential_offset(); ++i) {
      sum += r[i];
      size += std::abs(r[i]);
    }
    EXPECT_GT(size, 1e-3);
    EXPECT_LT(std::abs(sum), 1e-15 * size * 10);
  }
}

// Without a solid the fluid's residual adds the traction of the fluid on the wall's own functions.
TEST(Scene, FluidResidualOnARigidWall) {
  RandomScene s(small_case(SceneKind::rigid));
  Array out("out", s.layout().size());
  s.scene.equations().fluid_residual(s.stage(), out);
  std::vector<double> expected = expected_residual(s);
  add(expected, s.terms.naive(CapillaryTraction{s.scene.coefficients().fluid().gas, 0.2}, 0, 1, false, 0));
  EXPECT_LT(distance(to_host(out), expected), 1e-13);
}

}  // namespace
}  // namespace softwet::testing_tools
