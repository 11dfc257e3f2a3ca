// Restarted flexible GMRES, right preconditioned; convergence is judged on the residual itself, not on a recurrence.
#pragma once

#include "solver/krylov/gram_schmidt.hpp"

namespace softwet {

struct KrylovResult {
  int iterations = 0;
  double reduction = 1;  ///< ||b - A x|| / ||b||, up to a hundredth of itself
  bool converged = false;
};

/// Saad 1993. Workspace is allocated once. `apply(z, out)` is the operator, `precondition(r, z)` its rough inverse.
/// Vectors are of the precision Real; their dot products are summed, and the small system is solved, in double
/// precision.
///
/// Norms may be weighted, ||x||^2 = sum_i w_i x_i^2: as if each row of the system was multiplied by the root of its
/// weight (Essai 1998).
///
/// The basis is orthonormal up to a thousandth (solver/krylov/gram_schmidt.hpp). The residual at the end of a cycle
/// follows from A z_j = sum_i h_ij v_i, whatever angles the v_i have. It is the true one up to the round-off of the A
/// z_j. Where these cancel so much that their round-off counts, it is computed from x.
template <class Real>
class GmresOf {
 public:
  using Vector = ArrayOf<Real>;

  GmresOf(const VectorSpace& space, int size, int restart)
      : restart_(restart),
        residual_("gmres.residual", size),
        basis_("gmres.basis", space, size, restart + 1),
        direction_("gmres.direction", space, size, restart) {}

  /// Solves A x = b from x = 0 to ||b - A x|| <= tolerance ||b||, in at most `limit` iterations.
  /// @param weights  of the squares in norms
  template <class Apply, class Precondition>
  KrylovResult solve(const Apply& apply, const Precondition& precondition, const Vector& b, const Vector& x,
                     double tolerance, int limit, const RangeFactors& weights = {}) {
    KrylovResult result;
    basis_.set_weights(weights);
    const double start = basis_.length_of(b), target = tolerance * start;
    if (start == 0 || limit <= 0) Kokkos::deep_copy(Exec(), x, Real(0));
    if (start == 0) return {0, 0, true};
    double beta = start;
    while (result.iterations < limit) {
      const bool first = result.iterations == 0;
      const Vector& from = first ? b : residual_;
      const int used = cycle(apply, precondition, from, beta, target, std::min(restart_, limit - result.iterations));
      result.iterations += used;
      direction_.sum(x, {first ? 0.0 : 1.0, y_});
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
  /// One cycle of Arnoldi from a residual of the norm beta: fills direction_ and the coefficients y_; returns their
  /// number.
  template <class Apply, class Precondition>
  int cycle(const Apply& apply, const Precondition& precondition, const Vector& from, double beta, double target,
            int steps) {
    rotated_.assign(steps, {});
    for (std::vector<double>* v : {&c_, &s_, &g_}) v->assign(steps, 0.0);
    left_.assign(steps + 1, 0.0);
    left_[0] = beta;
    basis_.begin(from, beta);
    int used = 0;
    for (int j = 0; j < steps; ++j) {
      precondition(basis_[j], direction_[j]);
      apply(direction_[j], basis_[j + 1]);
      if (basis_.add()) rotate(j - 1);
      rotate(j);
      const auto last = [&] {
        return !(std::abs(left_[j + 1]) > target) || basis_.column(j)[j + 1] == 0 || j + 1 == steps;
      };
      if (basis_.waits() && last()) {
        basis_.finish();
        rotate(j);
      }
      // The operator maps this direction into the space that is there already, up to round-off. It would only add
      // noise.
      if (!(rotated_[j][j] > round_off * basis_.length(j)) || !std::isfinite(rotated_[j][j])) break;
      used = j + 1;
      if (last()) break;
    }
    solve_triangle(used);
    return used;
  }

  /// Givens rotations of column j, and what the directions up to z_j leave of the right-hand side.
  void rotate(int j) {
    std::vector<double>& h = rotated_[j];
    h = basis_.column(j);
    for (int i = 0; i < j; ++i) {
      const double a = h[i], b = h[i + 1];
      h[i] = c_[i] * a + s_[i] * b;
      h[i + 1] = -s_[i] * a + c_[i] * b;
    }
    const double length = std::hypot(h[j], h[j + 1]);
    c_[j] = h[j] / length;
    s_[j] = h[j + 1] / length;
    h[j] = length;
    g_[j] = c_[j] * left_[j];
    left_[j + 1] = -s_[j] * left_[j];
  }

  /// y from the rotated columns and the rotated right-hand side.
  void solve_triangle(int used) {
    y_.assign(used, 0.0);
    for (int i = used - 1; i >= 0; --i) {
      double sum = g_[i];
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
      for (int i = 0; i <= j + 1; ++i) a[i] -= y_[j] * basis_.column(j)[i];
      cancelled_ += std::abs(y_[j]) * basis_.length(j);
    }
    basis_.sum(residual_, {0, a});
    return basis_.length_of(residual_);
  }

  /// Norm of b - A x, which becomes residual_.
  template <class Apply>
  double true_residual(const Apply& apply, const Vector& b, const Vector& x) {
    apply(x, residual_);
    combine(residual_, 1, b, -1);
    return basis_.length_of(residual_);
  }

  /// Relative size of a vector that is nothing but round-off.
  static constexpr double round_off = std::is_same_v<Real, double> ? 1e-14 : 5e-6;
  static constexpr double target_margin = 1.01, trusted = 0.01;

  int restart_;
  Vector residual_;
  GramSchmidt<Real> basis_;
  KrylovBasis<Real> direction_;
  std::vector<std::vector<double>> rotated_;  ///< columns of the matrix between direction_ and basis_, rotated
  std::vector<double> c_, s_;                 ///< rotations
  std::vector<double> g_;                     ///< rotated right-hand side
  std::vector<double> left_;                  ///< its entry below g_[j - 1] after rotation j - 1
  std::vector<double> y_;
  double cancelled_ = 0;  ///< lengths of the terms of the residual, added up
};
using Gmres = GmresOf<double>;

}  // namespace softwet
