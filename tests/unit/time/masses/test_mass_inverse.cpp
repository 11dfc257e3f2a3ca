// Corrected masses against the masses themselves: what they keep exactly, and how small their error is.
#include "time/masses/mass_inverse.hpp"

#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

using RightSide = mass_kernels::RightSide<2>;

/// The masses of a scene whose mesh is moved by the displacement of its random stage, or not.
struct Weighed {
  RandomScene random;
  MassInverse<2, 2> inverse;
  Masses<2, 2> masses;
  Stage stage;
  Array moments;

  Weighed(const Case& c, MassKind kind)
      : random(c),
        inverse(random.scene.regions(), random.scene.coefficients(), kind),
        masses(random.scene.regions(), random.scene.coefficients()) {
    stage = random.stage();
    stage.density_end = scalars(stage.unknown);
    move_ghosts(random.layout(), stage.unknown, GhostAction::update);
    inverse.set_mesh(stage);
    const Array p("p", random.layout().size());
    masses.scalar(stage, stage.unknown, p);
    moments = Kokkos::subview(p, Kokkos::make_pair(l().density_offset(), l().potential_offset()));
    inverse.set_weights(moments, stage.density_end);
  }
  const Layout<2>& l() const { return random.layout(); }
  Array scalars(const Array& a) const {
    return Kokkos::subview(a, Kokkos::make_pair(l().density_offset(), l().potential_offset()));
  }
  Array velocities(const Array& a) const { return Kokkos::subview(a, Kokkos::make_pair(0, l().velocity_size())); }
  void solve_scalar(const Array& b, const Array& z) {
    inverse.scalar(stage, 1, RightSide::of(scalars(b)), scalars(z), 0);
  }
  void solve_velocity(const Array& b, const Array& z) {
    inverse.velocity(stage, 1, RightSide::of(velocities(b)), velocities(z), 0);
  }
};

/// Fluid without an end: periodic along both axes.
Case without_ends() {
  Case c = small_case(SceneKind::rigid, WallLaw::gradient, true);
  c.boundary.side[1] = {Side::periodic, Side::periodic};
  return c;
}

const std::vector<Case>& scenes() {
  static const std::vector<Case> all{small_case(SceneKind::rigid),
                                     small_case(SceneKind::coupled),
                                     small_case(SceneKind::coupled, WallLaw::gradient, true),
                                     axisymmetric(small_case(SceneKind::rigid)),
                                     axisymmetric(small_case(SceneKind::coupled)),
                                     without_ends()};
  return all;
}

TEST(MassInverse, WhatIsUniformStaysSoOnAMovedMesh) {
  for (const Case& c : scenes())
    for (const MassKind kind : {MassKind::lumped, MassKind::corrected}) {
      Weighed w(c, kind);
      const Array ones("ones", w.l().size()), b("b", w.l().size()), z("z", w.l().size());
      Kokkos::deep_copy(ones, 1.0);
      w.masses.scalar(w.stage, ones, b);
      w.solve_scalar(b, z);
      const std::vector<double> found = to_host(z), mask = to_host(w.random.scene.mask());
      for (int i = w.l().density_offset(); i < w.l().potential_offset(); ++i)
        if (mask[i] != 0) {
          ASSERT_NEAR(found[i], 1, 1e-12);
        }
    }
}

TEST(MassInverse, AUniformAccelerationOfFluidAndSolidIsExact) {
  Case c = small_case(SceneKind::coupled, WallLaw::gradient, true);
  c.boundary.side[1] = {Side::free, Side::slip};  // nothing holds the motion along x
  Weighed w(c, MassKind::corrected);
  const Array ones("ones", w.l().size()), b("b", w.l().size()), z("z", w.l().size());
  const std::vector<double> sums = to_host(w.inverse.velocity_sums()), mask = to_host(w.random.scene.mask());
  std::vector<double> force(w.l().size(), 0.0);
  for (std::size_t i = 0; i < sums.size(); ++i) force[i] = mask[i] * sums[i];
  Kokkos::deep_copy(b, to_device<Array>(force));
  w.solve_velocity(b, z);
  const std::vector<double> found = to_host(z);
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (mask[i] != 0) {
      ASSERT_NEAR(found[i], 1, 1e-12);
    }
}

TEST(MassInverse, TheMassOfTheDensityIsTheSumOfItsMoments) {
  for (const Case& c : scenes())
    for (const MassKind kind : {MassKind::lumped, MassKind::corrected}) {
      Weighed w(c, kind);
      std::vector<double> b = to_host(w.random.direction());
      const Array z("z", w.l().size()), p("p", w.l().size());
      w.solve_scalar(to_device<Array>(b), z);
      move_ghosts(w.l(), z, GhostAction::update);
      w.masses.scalar(w.stage, z, p);
      double mass = 0, sum = 0;
      const std::vector<double> found = to_host(p);
      for (int i = w.l().density_offset(); i < w.l().potential_offset(); ++i) {
        mass += found[i];
        sum += b[i];
      }
      EXPECT_NEAR(mass, sum, 1e-12);
    }
}

TEST(MassInverse, IsSymmetricAndPositive) {
  for (const Case& c : scenes()) {
    Weighed w(c, MassKind::corrected);
    const Array x = w.random.direction(), y = w.random.direction(), sx("sx", w.l().size()), sy("sy", w.l().size());
    const std::vector<double> a = to_host(x), b = to_host(y);
    const auto expect_symmetric = [&](int first, int last) {
      const std::vector<double> sa = to_host(sx), sb = to_host(sy);
      const double one = contract(a, sb, first, last), other = contract(b, sa, first, last);
      EXPECT_NEAR(one, other, 1e-11 * contract(a, sa, first, last));
      EXPECT_GT(contract(a, sa, first, last), 0);
    };
    w.solve_scalar(x, sx);
    w.solve_scalar(y, sy);
    expect_symmetric(w.l().density_offset(), w.l().potential_offset());
    w.solve_velocity(x, sx);
    w.solve_velocity(y, sy);
    expect_symmetric(0, w.l().velocity_size());
  }
}

// A force that is taken leaves zero, and moments are p + dt (rates - mask force) wherever they are kept.
TEST(MassInverse, TakesForcesAndMovesMoments) {
  for (const MassKind kind : {MassKind::consistent, MassKind::lumped, MassKind::corrected}) {
    Weighed w(small_case(SceneKind::coupled), kind);
    const int count = w.l().scalar_size();
    const auto draw = [&] { return w.random.terms.patch.draw(count, 0.5, 1); };
    const Array p = draw(), rates = draw(), force = draw(), taken = draw();
    const Array moved("p", count), z("z", count), expected("e", count);
    const ConstArray mask = part(w.random.scene.mask(), w.l().density_offset(), w.l().potential_offset());
    std::vector<double> step = to_host(p);
    const std::vector<double> r = to_host(rates), f = to_host(force), m = to_host(mask), given = to_host(taken);
    for (int i = 0; i < count; ++i) step[i] += 0.1 * (r[i] - m[i] * f[i]);
    w.inverse.scalar(w.stage, 1, RightSide::moved(p, 0.1, rates, {force}, mask, moved), z, 1e-12);
    w.inverse.scalar(w.stage, 1, RightSide::of(to_device<Array>(step)), expected, 1e-12);
    for (int i = 0; i < count; ++i) {
      ASSERT_NEAR(to_host(moved)[i], step[i], 1e-14);
      ASSERT_NEAR(to_host(z)[i], to_host(expected)[i], 1e-8);
      ASSERT_EQ(to_host(force)[i], 0);
    }
    w.inverse.scalar(w.stage, -2, RightSide::take({taken}), z, 1e-12);
    w.inverse.scalar(w.stage, -2, RightSide::of(to_device<Array>(given)), expected, 1e-12);
    for (int i = 0; i < count; ++i) {
      ASSERT_NEAR(to_host(z)[i], to_host(expected)[i], 1e-8);
      ASSERT_EQ(to_host(taken)[i], 0);
    }
  }
}

// Weights that jump by any factor from function to function: S stays positive, as it has to for viscosity to damp.
TEST(MassInverse, StaysPositiveBesideMuchHeavierNeighbours) {
  for (const bool periodic : {false, true}) {
    Weighed w(small_case(SceneKind::rigid, WallLaw::gradient, periodic), MassKind::corrected);
    std::vector<double> heavy = to_host(w.moments);
    const std::vector<double> z = to_host(w.random.direction());
    for (std::size_t i = 0; i < heavy.size(); ++i) heavy[i] *= (i * 7919) % 5 < 2 ? 1000.0 : 1.0;
    w.inverse.set_weights(to_device<Array>(heavy), w.stage.density_end);
    const Array found("found", w.l().size());
    for (int i = 0; i < w.l().velocity_size(); i += 3) {
      std::vector<double> one(w.l().size(), 0.0);
      one[i] = to_host(w.random.scene.mask())[i];
      w.solve_velocity(to_device<Array>(one), found);
      if (one[i] != 0) {
        ASSERT_GT(to_host(found)[i], 0) << i;
      }
    }
    const Array b = to_device<Array>(z);
    w.solve_velocity(b, found);
    EXPECT_GT(contract(z, to_host(found), 0, w.l().velocity_size()), 0);
  }
}

/// Error of S M c - c for a wave along x on a periodic mesh, over the error of the lumped masses.
double error_of_wave(int elements, MassKind kind) {
  Case c = small_case(SceneKind::rigid, WallLaw::gradient, true);
  c.domain.size = {1, 1};
  c.domain.elements = {elements, 8};
  const Scene<2, 2> scene(c);
  MassInverse<2, 2> inverse(scene.regions(), scene.coefficients(), kind);
  const Masses<2, 2> masses(scene.regions(), scene.coefficients());
  const Layout<2>& l = scene.layout();
  Stage stage = make_stage<double>(l);
  inverse.set_mesh(stage);
  std::vector<double> wave(l.size(), 0.0);
  const Axis& x = l.axis[0];
  for (int i = l.density_offset(); i < l.potential_offset(); ++i)
    wave[i] = std::cos(2 * M_PI * x.greville((i - l.density_offset()) % x.functions()));
  const Array b("b", l.size()), z("z", l.size());
  masses.scalar(stage, to_device<Array>(wave), b);
  const auto scalars = [&l](const Array& a) {
    return Kokkos::subview(a, Kokkos::make_pair(l.density_offset(), l.potential_offset()));
  };
  inverse.scalar(stage, 1, RightSide::of(scalars(b)), scalars(z), 0);
  const std::vector<double> found = to_host(z);
  double error = 0;
  for (int i = l.density_offset(); i < l.potential_offset(); ++i)
    if ((i - l.density_offset()) % x.functions() < x.owned()) error = std::max(error, std::abs(found[i] - wave[i]));
  return error;
}

TEST(MassInverse, IsOfSecondOrderLumpedAndOfSixthCorrected) {
  for (const auto& [kind, order] : {std::pair{MassKind::lumped, 2.0}, {MassKind::corrected, 6.0}})
    EXPECT_NEAR(std::log2(error_of_wave(16, kind) / error_of_wave(32, kind)), order, 0.2);
  EXPECT_LT(error_of_wave(16, MassKind::corrected), 2e-4);
}

// A smooth radial field, from its moments and back: the largest error between a quarter and three quarters of the
// radius, for ends have ties.
double error_of_radial_wave(int elements, MassKind kind) {
  Case c = axisymmetric(small_case(SceneKind::rigid));
  c.domain.size = {1, 1};
  c.domain.elements = {elements, 8};
  Weighed w(c, kind);
  const Axis& x = w.l().axis[0];
  std::vector<double> wave(w.l().size(), 0.0);
  for (int i = w.l().density_offset(); i < w.l().potential_offset(); ++i)
    wave[i] = std::cos(M_PI * x.greville((i - w.l().density_offset()) % x.functions()));
  const Array b("b", w.l().size()), z("z", w.l().size());
  w.masses.scalar(w.stage, to_device<Array>(wave), b);
  w.solve_scalar(b, z);
  const std::vector<double> found = to_host(z);
  double error = 0;
  for (int i = w.l().density_offset(); i < w.l().potential_offset(); ++i) {
    const double r = x.greville((i - w.l().density_offset()) % x.functions());
    if (r > 0.25 && r < 0.75) error = std::max(error, std::abs(found[i] - wave[i]));
  }
  return error;
}
TEST(MassInverse, HasItsOrdersAroundAnAxisOfSymmetryToo) {
  for (const auto& [kind, order] : {std::pair{MassKind::lumped, 2.0}, {MassKind::corrected, 6.0}})
    EXPECT_NEAR(std::log2(error_of_radial_wave(32, kind) / error_of_radial_wave(64, kind)), order, 0.3);
}

}  // namespace
}  // namespace softwet::testing_tools
