// Restarted flexible GMRES, right preconditioned; convergence is judged on the true residual.
#pragma once

#include <cmath>
#include <vector>

#include "field/vector.hpp"

namespace softwet {

struct KrylovResult {
  int iterations = 0;
  double reduction = 1;  ///< ||b - A x|| / ||b||, computed from x itself
  bool converged = false;
};

/// Saad 1993. Workspace is allocated once. `apply(z, out)` is the operator, `precondition(r, z)` its rough inverse.
/// Vectors are of the precision Real; their dot products are summed, and the small system is solved, in double precision.
template <class Real>
class GmresOf {
 public:
  using Vector = ArrayOf<Real>;

  GmresOf(int size, int restart) : restart_(restart), residual_("gmres.residual", size) {
    for (int j = 0; j <= restart; ++j) basis_.emplace_back("gmres.basis", size);
    for (int j = 0; j < restart; ++j) direction_.emplace_back("gmres.direction", size);
  }

  /// Solves A x = b from x = 0 to ||b - A x|| <= tolerance ||b||, in at most `limit` iterations.
  template <class Apply, class Precondition>
  KrylovResult solve(const Apply& apply, const Precondition& precondition, const Vector& b, const Vector& x,
                     double tolerance, int limit) {
    KrylovResult result;
    const double target = tolerance * norm(b);
    const double start = norm(b);
    Kokkos::deep_copy(Exec(), x, Real(0));
    Kokkos::deep_copy(Exec(), basis_[0], b);
    if (start == 0) return {0, 0, true};
    double beta = start;
    while (result.iterations < limit) {
      const int used = cycle(apply, precondition, beta, target, std::min(restart_, limit - result.iterations));
      result.iterations += used;
      for (int j = 0; j < used; ++j) add_scaled(x, 0, y_[j], direction_[j]);
      apply(x, residual_);  // the true residual, not the recurrence's
      Kokkos::deep_copy(Exec(), basis_[0], b);
      add_scaled(basis_[0], 0, -1, residual_);
      const double previous = beta;
      beta = norm(basis_[0]);
      result.reduction = beta / start;
      if (beta <= 1.01 * target) result.converged = true;
      if (result.converged || !(beta < 0.98 * previous)) break;
    }
    return result;
  }

 private:
  /// One cycle of Arnoldi from basis_[0] (norm beta): fills direction_ and the coefficients y_; returns their number.
  template <class Apply, class Precondition>
  int cycle(const Apply& apply, const Precondition& precondition, double beta, double target, int steps) {
    std::vector<std::vector<double>> h(steps, std::vector<double>(steps + 1, 0.0));
    std::vector<double> c(steps), s(steps), g(steps + 1, 0.0);
    combine(basis_[0], 1 / beta, basis_[0], 0);
    g[0] = beta;
    int used = 0;
    for (int j = 0; j < steps; ++j) {
      precondition(basis_[j], direction_[j]);
      const Vector& w = basis_[j + 1];
      apply(direction_[j], w);
      double square = 0;              // |w|^2 before the projections
      for (int i = 0; i <= j; ++i) {  // modified Gram-Schmidt
        h[j][i] = dot(w, basis_[i]);
        square += h[j][i] * h[j][i];
        add_scaled(w, 0, -h[j][i], basis_[i]);
      }
      h[j][j + 1] = norm(w);
      const double next = h[j][j + 1];
      square += next * next;
      if (next > 0) combine(w, 1 / next, w, 0);
      for (int i = 0; i < j; ++i) {
        const double a = h[j][i], b = h[j][i + 1];
        h[j][i] = c[i] * a + s[i] * b;
        h[j][i + 1] = -s[i] * a + c[i] * b;
      }
      const double length = std::hypot(h[j][j], h[j][j + 1]);
      used = j + 1;
      // The operator maps this direction into the space that is there already, up to round-off. It would only add noise.
      if (!(length > round_off * std::sqrt(square)) || !std::isfinite(length)) {
        used = j;
        break;
      }
      c[j] = h[j][j] / length;
      s[j] = h[j][j + 1] / length;
      h[j][j] = length;
      g[j + 1] = -s[j] * g[j];
      g[j] *= c[j];
      if (std::abs(g[j + 1]) <= target || next == 0) break;
    }
    y_.assign(used, 0.0);
    for (int i = used - 1; i >= 0; --i) {
      double sum = g[i];
      for (int j = i + 1; j < used; ++j) sum -= h[j][i] * y_[j];
      y_[i] = sum / h[i][i];
    }
    return used;
  }

  /// Relative size of a vector that is nothing but round-off.
  static constexpr double round_off = std::is_same_v<Real, double> ? 1e-14 : 5e-6;

  int restart_;
  Vector residual_;
  std::vector<Vector> basis_, direction_;
  std::vector<double> y_;
};
using Gmres = GmresOf<double>;

}  // namespace softwet
