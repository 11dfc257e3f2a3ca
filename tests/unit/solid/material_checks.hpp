// Checks that every material has to pass.
#pragma once

#include <gtest/gtest.h>

#include <random>

#include "kernels/solid/isotropic.hpp"

namespace softwet::testing_tools {

template <int D>
Matrix<double, D> random_gradient(double size) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-size, size);
  Matrix<double, D> g;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) g(i, j) = uniform(random);
  return g;
}

/// P is the derivative of the energy, by differences of fourth order.
template <int D, class Material>
void expect_stress_of_energy(const Material& m, double tolerance = 1e-10) {
  const Matrix<double, D> g = random_gradient<D>(0.3);
  const auto p = m.first_piola(g);
  const double e = 1e-3;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      const auto at = [&](double step) {
        Matrix<double, D> h = g;
        h(i, j) += step;
        return m.energy(h);
      };
      EXPECT_NEAR((8 * (at(e) - at(-e)) - at(2 * e) + at(-2 * e)) / (12 * e), p(i, j), tolerance);
    }
}

/// For small strains P is Hooke's stress lambda tr(e) I + 2 G e up to second order.
template <class Material>
void expect_hooke_in_the_limit(const Material& m) {
  for (const double size : {1e-3, 1e-4}) {
    const Matrix<double, 2> g{{{0.3 * size, 0.4 * size}, {-0.2 * size, 0.1 * size}}};
    const auto p = m.first_piola(g), hooke = linear_stress(m, 0.5 * (g + transpose(g)));
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) EXPECT_NEAR(p(i, j), hooke(i, j), 4 * size * size);
  }
}

/// Plane strain is the law in 3D without motion along z.
template <class Material>
void expect_plane_strain(const Material& m, double tolerance = 1e-15) {
  const auto flat = m.first_piola(Matrix<double, 2>{{{0.1, 0.3}, {-0.2, 0.2}}});
  const Matrix<double, 3> in_space{{{0.1, 0.3, 0}, {-0.2, 0.2, 0}, {0, 0, 0}}};
  const auto full = m.first_piola(in_space);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) EXPECT_NEAR(flat(i, j), full(i, j), tolerance);
  EXPECT_NEAR(m.energy(Matrix<double, 2>{{{0.1, 0.3}, {-0.2, 0.2}}}), m.energy(in_space), tolerance);
}

}  // namespace softwet::testing_tools
