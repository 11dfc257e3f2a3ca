// Small dense systems whose solution is known, for tests of Krylov methods.
#pragma once

#include <cmath>
#include <random>

#include "solver/krylov/gmres.hpp"

namespace softwet::testing_tools {

/// A dense matrix on the host behind the interface of an operator.
struct Dense {
  int n;
  std::vector<double> a, solution, right;

  /// Nonsymmetric: `spread` on the diagonal from 1 to 1 + spread, noise around it.
  Dense(int size, double spread, double noise) : n(size), a(size * size), solution(size), right(size) {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (double& x : a) x = noise * uniform(random) / std::sqrt(n);
    for (int i = 0; i < n; ++i) {
      a[i * n + i] += 1 + spread * i / n;
      solution[i] = uniform(random);
    }
    right = multiply(solution);
  }
  std::vector<double> multiply(const std::vector<double>& x) const {
    std::vector<double> y(n, 0.0);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) y[i] += a[i * n + j] * x[j];
    return y;
  }
  auto apply() const {
    return [this](const Array& x, const Array& y) { Kokkos::deep_copy(y, to_device<Array>(multiply(to_host(x)))); };
  }
  /// The operator on vectors in single precision; its own arithmetic is double.
  auto apply_single() const {
    return [this](const ArrayOf<float>& x, const ArrayOf<float>& y) {
      const Array wide("wide", n);
      convert(wide, x);
      convert(y, to_device<Array>(multiply(to_host(wide))));
    };
  }
  auto jacobi() const {
    return [this](const Array& r, const Array& z) {
      std::vector<double> v = to_host(r);
      for (int i = 0; i < n; ++i) v[i] /= a[i * n + i];
      Kokkos::deep_copy(z, to_device<Array>(v));
    };
  }
  double reduction(const std::vector<double>& x) const {
    const std::vector<double> y = multiply(x);
    double r = 0, b = 0;
    for (int i = 0; i < n; ++i) {
      r += (right[i] - y[i]) * (right[i] - y[i]);
      b += right[i] * right[i];
    }
    return std::sqrt(r / b);
  }
};

inline const auto identity = [](const Array& r, const Array& z) { Kokkos::deep_copy(z, r); };

}  // namespace softwet::testing_tools
