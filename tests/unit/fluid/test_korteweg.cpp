// Capillary stress of an analytic density field: div Sigma = -rho grad mu, and Sigma = -p I + varsigma.
#include "kernels/fluid/korteweg.hpp"

#include <gtest/gtest.h>

#include "kernels/fluid/van_der_waals.hpp"

namespace softwet {
namespace {

/// rho = 0.4 + 0.2 sin(a . x) cos(b . x) with its derivatives in closed form.
template <int D>
struct ExactField {
  static constexpr double a[3] = {1.3, -0.7, 0.9}, b[3] = {0.4, 1.1, -0.8};
  double s = 0, t = 0;
  explicit ExactField(const Vector<double, D>& x) {
    for (int d = 0; d < D; ++d) {
      s += a[d] * x[d];
      t += b[d] * x[d];
    }
  }
  double density() const { return 0.4 + 0.2 * std::sin(s) * std::cos(t); }
  Vector<double, D> gradient() const {
    Vector<double, D> g;
    for (int d = 0; d < D; ++d) g[d] = 0.2 * (a[d] * std::cos(s) * std::cos(t) - b[d] * std::sin(s) * std::sin(t));
    return g;
  }
  double laplacian() const {
    double sum = 0;
    for (int d = 0; d < D; ++d)
      sum -=
          0.2 * ((a[d] * a[d] + b[d] * b[d]) * std::sin(s) * std::cos(t) + 2 * a[d] * b[d] * std::cos(s) * std::sin(t));
    return sum;
  }
};

constexpr double g = 0.6;
const VanDerWaals gas{0.85, 0};

template <int D>
double potential(const Vector<double, D>& x) {
  const ExactField<D> f(x);
  return gas.derivative(f.density()) - g * g * f.laplacian();
}
template <int D>
Matrix<double, D> sigma(const Vector<double, D>& x) {
  const ExactField<D> f(x);
  return reversible_stress(g, gas.energy(f.density()), f.density(), f.gradient(), potential(x));
}
template <int D>
Vector<double, D> shifted(Vector<double, D> x, int d, double e) {
  x[d] += e;
  return x;
}

template <int D>
void divergence_is_the_potential_force() {
  const double e = 1e-3;
  for (int n = 0; n < 20; ++n) {
    Vector<double, D> x;
    for (int d = 0; d < D; ++d) x[d] = std::sin(3.1 * n + 1.7 * d);
    const double rho = ExactField<D>(x).density();
    for (int i = 0; i < D; ++i) {
      double divergence = 0;
      const auto slope = [&](int d, const auto& f) {
        return (8 * (f(shifted(x, d, e)) - f(shifted(x, d, -e))) - f(shifted(x, d, 2 * e)) + f(shifted(x, d, -2 * e))) /
               (12 * e);
      };
      for (int j = 0; j < D; ++j) divergence += slope(j, [&](const auto& y) { return sigma(y)(i, j); });
      const double force = -rho * slope(i, [](const auto& y) { return potential(y); });
      EXPECT_NEAR(divergence, force, 1e-10);
    }
  }
}
TEST(Korteweg, DivergenceIsThePotentialForce) {
  divergence_is_the_potential_force<2>();
  divergence_is_the_potential_force<3>();
}

/// The capillary stress as the paper has it, with an explicit Laplacian (Bueno et al. 2017, eq. (5)):
///   varsigma = lambda (rho Lap rho + |grad rho|^2 / 2) I - lambda grad rho (x) grad rho,   lambda = g^2
template <int D>
Matrix<double, D> capillary_stress(const ExactField<D>& f) {
  const double isotropic = f.density() * f.laplacian() + 0.5 * dot(f.gradient(), f.gradient());
  return (g * g) * add_diagonal(-1.0 * outer(f.gradient(), f.gradient()), isotropic);
}

template <int D>
void pressure_plus_capillary_stress() {
  for (int n = 0; n < 20; ++n) {
    Vector<double, D> x;
    for (int d = 0; d < D; ++d) x[d] = std::sin(3.1 * n + 1.7 * d);
    const ExactField<D> f(x);
    const auto expected = add_diagonal(capillary_stress(f), -gas.pressure(f.density()));
    const auto found = sigma(x);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j) EXPECT_NEAR(found(i, j), expected(i, j), 1e-15);
  }
}
TEST(Korteweg, ReversibleStressIsPressurePlusCapillaryStress) {
  pressure_plus_capillary_stress<2>();
  pressure_plus_capillary_stress<3>();
}

}  // namespace
}  // namespace softwet
