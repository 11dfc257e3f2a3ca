// Walls whose energy depends on their stretch: the laws are the derivatives of that energy, at a point.
#include "kernels/functional/wall_integrals.hpp"

#include <gtest/gtest.h>

#include <random>

#include "kernels/point/geometry.hpp"

namespace softwet {
namespace {

// Coexistence at theta = 0.39 (tests/oracle/wall_energy.py).
const Coexistence phases{0.001352289800692532, 0.86669909966079184, 0.0001546475126558792, -0.65019109012614495};
const EnergyWall of_one{0.1, 1, 1e-5, {0.39, 0.2 * phases.density_vapour}, phases};
constexpr double beta = 0.6, cosine = -0.7, density = 0.5;

template <int D>
using DualMatrix = Matrix<Dual<double>, D>;

/// A random gradient of the motion of the mesh, and a change of it.
template <int D>
struct RandomMotion {
  Matrix<double, D> gradient, change;
  DualMatrix<D> both;

  explicit RandomMotion(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> draw(-0.4, 0.4);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) {
        gradient(i, j) = draw(random);
        change(i, j) = draw(random);
        both(i, j) = {gradient(i, j), change(i, j)};
      }
  }
};

/// flux : grad_x w, where Grad w is the change of the motion.
template <int D, class Point>
double work(const Matrix<double, D>& flux, const Point& point, const Matrix<double, D>& change) {
  double sum = 0;
  for (int i = 0; i < D; ++i) {
    Vector<double, D> row, of_flux;
    for (int j = 0; j < D; ++j) row[j] = change(i, j), of_flux[j] = flux(i, j);
    sum += dot(of_flux, point.physical(row));
  }
  return sum;
}

template <int D>
void expect_tension_of_the_energy(unsigned seed) {
  const WallEnergy wall = WallEnergy::of(of_one);
  const StretchedWall<WallTension> term{{wall}, beta, 1 - beta};
  const RandomMotion<D> motion(seed);
  const MovingFace<double, D> face(MovingPoint<double, D>(motion.gradient, {}, {}));
  const MovingFace<Dual<double>, D> moved(MovingPoint<Dual<double>, D>(motion.both, {}, {}));
  const Dual<double> energy = real_power(moved.area_ratio(), 1 - beta) * (cosine * wall.value(density));
  const auto r = term.residual(
      StretchedTrial<WallTensionTrial<double, D>, double>{{density, cosine, face.normal}, face.area_ratio()});
  EXPECT_NEAR(face.measured(work<D>(r.momentum_flux, face, motion.change)), energy.tangent, 1e-15);
  EXPECT_GT(std::abs(energy.tangent), 1e-5);
}
TEST(StretchedWall, TensionIsTheSlopeOfTheEnergyByThePlace) {
  for (unsigned seed = 1; seed < 9; ++seed) {
    expect_tension_of_the_energy<2>(seed);
    expect_tension_of_the_energy<3>(seed);
  }
}

// The area ratio is |x'| r/R; w_r / r meets the hoop entry.
TEST(StretchedWall, TensionAroundAnAxis) {
  const WallEnergy wall = WallEnergy::of(of_one);
  const StretchedWall<WallTension> term{{wall}, beta, 1 - beta};
  const double R = 0.8, u = 0.1, w = -0.3;
  const RandomMotion<2> motion(3);
  using Around = AxialPoint<MovingFace<double, 2>>;
  using Moved = AxialPoint<MovingFace<Dual<double>, 2>>;
  const Around face(MovingPoint<double, 2>(motion.gradient, {}, {{R + u, 0}}), R);
  const Moved moved(MovingPoint<Dual<double>, 2>(motion.both, {}, {{Dual<double>(R + u, w), {0.0}}}), R);
  EXPECT_NEAR(face.area_ratio(), face.measure * (R + u) / R, 1e-15);
  const Dual<double> energy = R * real_power(moved.area_ratio(), 1 - beta) * (cosine * wall.value(density));
  using Trial = StretchedTrial<WallTensionTrial<double, 2, AxialMatrix<double>>, double>;
  const auto r = term.residual(Trial{{density, cosine, face.normal}, face.area_ratio()}).momentum_flux;
  EXPECT_NEAR(face.measured(work<2>(r.plane, face, motion.change), r.hoop * w), energy.tangent, 1e-15);
}

TEST(StretchedWall, ForceOnTheDensityIsTheSlopeOfTheEnergyByIt) {
  const StretchedWall<PaintedWall<EnergyWall>> term{{of_one}, beta};
  const StretchedWallIntegrals integrals{{{WallEnergy::of(of_one)}}, beta};
  for (const double ratio : {0.6, 1.0, 1.7}) {
    using Painted = PaintedWall<EnergyWall>::Trial<double, 2>;
    using Trial = StretchedTrial<Painted, double>;
    using Moved = StretchedWallIntegrals::Trial<Dual<double>, 2>;
    const double force = term.residual(Trial{{{density, {}}, cosine}, ratio}).potential;
    const Dual<double> energy = integrals.value(Moved{{{{density, 1.0}}, {cosine}}, {ratio}})[0];
    EXPECT_NEAR(-force, energy.tangent, 1e-15);
    // The effective contact angle.
    const PaintedWall<EnergyWall> plain{of_one};
    EXPECT_NEAR(force, plain.residual(Painted{{density, {}}, std::pow(ratio, -beta) * cosine}).potential, 1e-15);
  }
}

TEST(StretchedWall, IsThePlainOneWithoutAnExponent) {
  const WallEnergy wall = WallEnergy::of(of_one);
  const WallTensionTrial<double, 2> trial{density, cosine, {{0.6, 0.8}}};
  const auto plain = WallTension{wall}.residual(trial).momentum_flux;
  const auto stretched = StretchedWall<WallTension>{{wall}, 0, 1}.residual(
      StretchedTrial<WallTensionTrial<double, 2>, double>{trial, 1.3});
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(stretched.momentum_flux(i, j), plain(i, j), 1e-17);
}

TEST(RealPower, OfDualNumbersHasItsSlope) {
  const Dual<double> p = real_power(Dual<double>(1.7, 0.5), -0.6);
  EXPECT_DOUBLE_EQ(p.value, std::pow(1.7, -0.6));
  EXPECT_DOUBLE_EQ(p.tangent, -0.6 * std::pow(1.7, -1.6) * 0.5);
}

}  // namespace
}  // namespace softwet
