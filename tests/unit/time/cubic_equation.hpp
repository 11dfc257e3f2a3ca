// A small nonlinear system with a known root, for tests of Newton's method.
#pragma once

#include <cmath>

#include "time/implicit/newton.hpp"

namespace softwet::testing_tools {

inline constexpr int unknowns = 24;

/// f_i = x_i^3 + 4 x_i + x_{i-1} x_{i+1} - b_i, root known.
struct CubicEquation {
  std::vector<double> root, right;
  int exact = 0;

  CubicEquation() : root(unknowns), right(unknowns, 0.0) {
    for (int i = 0; i < unknowns; ++i) root[i] = std::sin(1.0 + i);
    right = value(root);
  }
  std::vector<double> value(const std::vector<double>& x) const {
    std::vector<double> f(unknowns);
    for (int i = 0; i < unknowns; ++i)
      f[i] = x[i] * x[i] * x[i] + 4 * x[i] + x[(i + unknowns - 1) % unknowns] * x[(i + 1) % unknowns] - right[i];
    return f;
  }
  std::vector<double> slope(const std::vector<double>& x, const std::vector<double>& z) const {
    std::vector<double> d(unknowns);
    for (int i = 0; i < unknowns; ++i) {
      const int a = (i + unknowns - 1) % unknowns, b = (i + 1) % unknowns;
      d[i] = (3 * x[i] * x[i] + 4) * z[i] + z[a] * x[b] + x[a] * z[b];
    }
    return d;
  }
  NonlinearSystem system(const Array& x) {
    return {[this](const Array& y, const Array& r) { Kokkos::deep_copy(r, to_device<Array>(value(to_host(y)))); },
            [this, x](const Array& z, const Array& out) {
              ++exact;
              Kokkos::deep_copy(out, to_device<Array>(slope(to_host(x), to_host(z))));
            },
            [](const StencilValues&) {}, [](const Array&) { return Refusal{}; }};
  }
};

/// This system with a product whose vectors are in single precision.
inline NonlinearSystem with_single_product(CubicEquation& cubic, const Array& x) {
  NonlinearSystem system = cubic.system(x);
  system.single_product = [product = std::exchange(system.product, nullptr)](const ArrayOf<float>& z,
                                                                             const ArrayOf<float>& out) {
    const Array wide("wide", unknowns), result("result", unknowns);
    convert(wide, z);
    product(wide, result);
    convert(out, result);
  };
  return system;
}

inline Newton make_newton() { return Newton(alone, unknowns, unknowns, std::make_unique<NoPreconditioner>()); }
inline const std::vector<FieldRange> fields{{0, unknowns / 2, 1e-14}, {unknowns / 2, unknowns, 1e-14}};

inline NewtonControl tight() {
  NewtonControl c;
  c.rtol = 1e-12;
  c.krylov_rtol = 1e-10;
  c.max = 12;
  return c;
}

inline double error(const Array& x, const std::vector<double>& root) {
  const std::vector<double> found = to_host(x);
  double e = 0;
  for (int i = 0; i < unknowns; ++i) e = std::max(e, std::abs(found[i] - root[i]));
  return e;
}

}  // namespace softwet::testing_tools
