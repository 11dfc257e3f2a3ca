// Restarted flexible GMRES, right preconditioned; convergence is judged on the residual itself, not on a recurrence.
#pragma once

#include <cmath>
#include <vector>

#include "solver/krylov_basis.hpp"

namespace softwet {

struct KrylovResult {
  int iterations = 0;
  double reduction = 1;  ///< ||b - A x|| / ||b||, up to a hundredth of itself
  bool converged = false;
};

/// Saad 1993. Workspace is allocated once. `apply(z, out)` is the operator, `precondition(r, z)` its rough inverse.
/// Vectors are of the precision Real; their dot products are summed, and the small system is solved, in double precision.
///
/// Orthogonalisation is classical Gram-Schmidt: one pass over the basis for all products, and a second one where the angles
/// would be off by a thousandth (Daniel, Gragg, Kaufman and Stewart 1976). The residual at the end of a cycle follows from
/// A z_j = sum_i h_ij v_i, whatever angles the v_i have. It is the true one up to the round-off of the A z_j. Where these
/// cancel so much that their round-off counts, it is computed from x.
template <class Real>
class GmresOf {
 public:
  using Vector = ArrayOf<Real>;

  GmresOf(int size, int restart)
      : restart_(restart),
        residual_("gmres.residual", size),
        basis_("gmres.basis", size, restart + 1),
        direction_("gmres.direction", size, restart) {}

  /// Solves A x = b from x = 0 to ||b - A x|| <= tolerance ||b||, in at most `limit` iterations.
  template <class Apply, class Precondition>
  KrylovResult solve(const Apply& apply, const Precondition& precondition, const Vector& b, const Vector& x,
                     double tolerance, int limit) {
    KrylovResult result;
    const double start = norm(b), target = tolerance * start;
    Kokkos::deep_copy(Exec(), x, Real(0));
    Kokkos::deep_copy(Exec(), basis_[0], b);
    if (start == 0) return {0, 0, true};
    double beta = start;
    while (result.iterations < limit) {
      const int used = cycle(apply, precondition, beta, target, std::min(restart_, limit - result.iterations));
      result.iterations += used;
      direction_.sum(x, 1, y_);
      const double previous = beta;
      beta = residual_of_basis(beta);
      const bool reached = beta <= target_margin * target;
      if (!reached || round_off * cancelled_ > trusted * target) beta = true_residual(apply, b, x);
      result.reduction = beta / start;
      if (beta <= target_margin * target) result.converged = true;
      if (result.converged || !(beta < 0.98 * previous)) break;
    }
    return result;
  }

 private:
  /// One cycle of Arnoldi from basis_[0] (norm beta): fills direction_ and the coefficients y_; returns their number.
  template <class Apply, class Precondition>
  int cycle(const Apply& apply, const Precondition& precondition, double beta, double target, int steps) {
    rotated_.assign(steps, {});
    column_.assign(steps, {});
    length_.assign(steps, 0.0);
    std::vector<double> c(steps), s(steps), g(steps + 1, 0.0);
    combine(basis_[0], 1 / beta, basis_[0], 0);
    g[0] = beta;
    skew_ = 0;
    int used = 0;
    for (int j = 0; j < steps; ++j) {
      precondition(basis_[j], direction_[j]);
      apply(direction_[j], basis_[j + 1]);
      orthogonalise(j);
      std::vector<double>& h = rotated_[j];
      h = column_[j];
      for (int i = 0; i < j; ++i) {
        const double a = h[i], b = h[i + 1];
        h[i] = c[i] * a + s[i] * b;
        h[i + 1] = -s[i] * a + c[i] * b;
      }
      const double length = std::hypot(h[j], h[j + 1]);
      used = j + 1;
      // The operator maps this direction into the space that is there already, up to round-off. It would only add noise.
      if (!(length > round_off * length_[j]) || !std::isfinite(length)) {
        used = j;
        break;
      }
      c[j] = h[j] / length;
      s[j] = h[j + 1] / length;
      h[j] = length;
      g[j + 1] = -s[j] * g[j];
      g[j] *= c[j];
      if (std::abs(g[j + 1]) <= target || column_[j][j + 1] == 0) break;
    }
    solve_triangle(used, g);
    return used;
  }

  /// Makes basis_[j + 1] = A z_j orthogonal to the vectors before it, of length 1 (or 0 where nothing is left), with
  /// column_[j] such that A z_j = sum_i column_[j][i] v_i.
  void orthogonalise(int j) {
    constexpr double most_skew = 1e-3, most_error = 0.02;
    std::vector<double>& h = column_[j];
    h.assign(j + 2, 0.0);
    double skew = skew_;
    for (int pass = 0; pass < 2; ++pass) {
      std::vector<double> along = basis_.dots(j + 1, basis_[j + 1]);
      const double square = along.back();
      along.pop_back();
      double taken = 0;
      for (int i = 0; i <= j; ++i) {
        h[i] += along[i];
        taken += along[i] * along[i];
        along[i] = -along[i];
      }
      if (pass == 0) length_[j] = std::sqrt(square);
      // A pass leaves as much along the vectors before as their angles are off, and the square of what is left, a
      // difference, is off as much.
      const double left = std::max(0.0, square - taken), rest = std::sqrt(left), off = (j + 1) * skew_;
      skew = rest > 0 ? (off * std::sqrt(taken) + unit * std::sqrt(square)) / rest : 0;
      const bool enough = pass == 1 || (skew < most_skew && off * taken + 1e-14 * square < most_error * left);
      h[j + 1] = rest;
      const double scale = !enough ? 1 : rest > 0 && std::isfinite(rest) ? 1 / rest : 0;
      for (double& a : along) a *= scale;
      basis_.sum(basis_[j + 1], scale, along);
      if (enough) break;
    }
    skew_ = std::max(skew_, std::min(skew, most_skew));
  }

  /// y from the rotated columns and the rotated right-hand side g.
  void solve_triangle(int used, const std::vector<double>& g) {
    y_.assign(used, 0.0);
    for (int i = used - 1; i >= 0; --i) {
      double sum = g[i];
      for (int j = i + 1; j < used; ++j) sum -= rotated_[j][i] * y_[j];
      y_[i] = sum / rotated_[i][i];
    }
  }

  /// || beta v_0 - sum_j y_j A z_j ||, and in `cancelled_` the sum of the lengths of these terms.
  double residual_of_basis(double beta) {
    const int used = static_cast<int>(y_.size());
    std::vector<double> a(used + 1, 0.0);
    a[0] = beta;
    cancelled_ = beta;
    for (int j = 0; j < used; ++j) {
      for (int i = 0; i <= j + 1; ++i) a[i] -= y_[j] * column_[j][i];
      cancelled_ += std::abs(y_[j]) * length_[j];
    }
    basis_.sum(residual_, 0, a);
    return norm(residual_);
  }

  /// Norm of b - A x, which becomes basis_[0].
  template <class Apply>
  double true_residual(const Apply& apply, const Vector& b, const Vector& x) {
    apply(x, residual_);
    Kokkos::deep_copy(Exec(), basis_[0], b);
    add_scaled(basis_[0], 0, -1, residual_);
    return norm(basis_[0]);
  }

  /// Relative size of a vector that is nothing but round-off.
  static constexpr double round_off = std::is_same_v<Real, double> ? 1e-14 : 5e-6;
  static constexpr double unit = std::is_same_v<Real, double> ? 1e-16 : 6e-8;
  static constexpr double target_margin = 1.01, trusted = 0.01;

  int restart_;
  Vector residual_;
  KrylovBasis<Real> basis_, direction_;
  std::vector<std::vector<double>> column_, rotated_;  ///< of the matrix between direction_ and basis_
  std::vector<double> length_;                         ///< of A z_j
  std::vector<double> y_;
  double skew_ = 0;       ///< of two vectors of the basis: a bound of their product, from the steps so far
  double cancelled_ = 0;  ///< lengths of the terms of the residual, added up
};
using Gmres = GmresOf<double>;

}  // namespace softwet
