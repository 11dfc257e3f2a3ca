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
/// Norms may be weighted, ||x||^2 = sum_i w_i x_i^2: as if each row of the system was multiplied by the root of its weight
/// (Essai 1998).
///
/// Orthogonalisation is classical Gram-Schmidt: one pass over the basis for all products, and a second one where the angles
/// would be off by a thousandth (Daniel, Gragg, Kaufman and Stewart 1976). The second pass of a vector waits for the first
/// one of the next vector, so that both read the basis once and share one reduction (Bielich et al. 2022); meanwhile the
/// vector is good enough for the preconditioner. Only where a vector is far off, or is the last one, it comes at once. The
/// residual at the end of a cycle follows from A z_j = sum_i h_ij v_i, whatever angles the v_i have. It is the true one up
/// to the round-off of the A z_j. Where these cancel so much that their round-off counts, it is computed from x.
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
  /// @param weights  of the squares in norms
  template <class Apply, class Precondition>
  KrylovResult solve(const Apply& apply, const Precondition& precondition, const Vector& b, const Vector& x,
                     double tolerance, int limit, const RangeFactors& weights = {}) {
    KrylovResult result;
    weights_ = weights;
    const double start = length_of(b), target = tolerance * start;
    Kokkos::deep_copy(Exec(), x, Real(0));
    Kokkos::deep_copy(Exec(), basis_[0], b);
    if (start == 0) return {0, 0, true};
    double beta = start;
    while (result.iterations < limit) {
      const int used = cycle(apply, precondition, beta, target, std::min(restart_, limit - result.iterations));
      result.iterations += used;
      direction_.sum(x, {1, y_});
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
  /// Coefficients of a pass of Gram-Schmidt and what it leaves of a vector.
  struct Pass {
    std::vector<double> along;  ///< (v_i, w)
    double square = 0;          ///< (w, w)
    double taken = 0;           ///< sum of along^2
    double rest = 0;            ///< length of what is left
    double skew = 0;            ///< bound of its products with the v_i, once it has the length 1
    double blur = 0;            ///< bound of the error of rest^2, relative
  };

  /// One cycle of Arnoldi from basis_[0] (norm beta): fills direction_ and the coefficients y_; returns their number.
  template <class Apply, class Precondition>
  int cycle(const Apply& apply, const Precondition& precondition, double beta, double target, int steps) {
    rotated_.assign(steps, {});
    column_.assign(steps, {});
    length_.assign(steps, 0.0);
    for (std::vector<double>* v : {&c_, &s_, &g_}) v->assign(steps, 0.0);
    left_.assign(steps + 1, 0.0);
    combine(basis_[0], 1 / beta, basis_[0], 0);
    left_[0] = beta;
    skew_ = 0;
    waits_ = false;
    int used = 0;
    for (int j = 0; j < steps; ++j) {
      precondition(basis_[j], direction_[j]);
      apply(direction_[j], basis_[j + 1]);
      orthogonalise(j);
      rotate(j);
      const auto last = [&] { return !(std::abs(left_[j + 1]) > target) || column_[j][j + 1] == 0 || j + 1 == steps; };
      if (waits_ && last()) {
        finish(j);
        rotate(j);
      }
      // The operator maps this direction into the space that is there already, up to round-off. It would only add noise.
      if (!(rotated_[j][j] > round_off * length_[j]) || !std::isfinite(rotated_[j][j])) break;
      used = j + 1;
      if (last()) break;
    }
    solve_triangle(used);
    return used;
  }

  /// Givens rotations of column j, and what the directions up to z_j leave of the right-hand side.
  void rotate(int j) {
    std::vector<double>& h = rotated_[j];
    h = column_[j];
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

  /// What a pass with these products leaves. It leaves as much along the vectors before as their angles are off, and the
  /// square of what is left, a difference, is off as much.
  Pass pass_of(std::vector<double> along, double square) const {
    Pass p{std::move(along), square};
    for (double a : p.along) p.taken += a * a;
    const double left = std::max(0.0, square - p.taken), off = p.along.size() * skew_;
    p.rest = std::sqrt(left);
    p.skew = p.rest > 0 ? (off * std::sqrt(p.taken) + unit * std::sqrt(square)) / p.rest : 0;
    p.blur = (off * p.taken + 1e-14 * square) / left;
    return p;
  }

  /// Makes basis_[j + 1] = A z_j orthogonal to the vectors before it, of length 1 (or 0 where nothing is left), with
  /// column_[j] such that A z_j = sum_i column_[j][i] v_i. Its second pass may wait (waits_); that of basis_[j] is done.
  void orthogonalise(int j) {
    constexpr double most_blur = 0.02, may_wait = 0.1;
    const bool both = waits_;
    Combination of_last;
    const Pass p = both ? first_pass_after_second(j, of_last) : first_pass(j);
    length_[j] = std::sqrt(p.square);
    const bool enough = p.skew < most_skew && p.blur < most_blur;
    waits_ = !enough && p.skew < may_wait && p.blur < may_wait;
    const bool scaled = enough || waits_;
    column_[j] = p.along;
    column_[j].push_back(scaled ? p.rest : 1);
    Combination of_next = without(p.along, scaled ? p.rest : 1);
    if (both) {
      const double link = of_next.a.back();
      of_next.a.pop_back();
      basis_.sum_two(basis_[j], of_last, basis_[j + 1], of_next, link);
    } else {
      basis_.sum(basis_[j + 1], of_next);
    }
    if (enough) skew_ = std::max(skew_, p.skew);
    if (!scaled) finish(j);
  }

  Pass first_pass(int j) const {
    std::vector<double> along = basis_.dots(j + 1, basis_[j + 1], weights_);
    const double square = along.back();
    along.pop_back();
    return pass_of(std::move(along), square);
  }

  /// The second pass of u = basis_[j], whose outcome v_j = (u - sum_i s_i v_i) / |.| is not there yet, and the first one of
  /// w = basis_[j + 1]: (v_j, w) follows from the products of u.
  Pass first_pass_after_second(int j, Combination& of_last) {
    auto [along, s] = basis_.dots_with_last(j + 1, basis_[j + 1], weights_);
    const double square = along.back(), square_of_last = s.back();
    along.pop_back();
    s.pop_back();
    const double length = second_pass(j - 1, s, square_of_last);
    rotate(j - 1);
    for (int i = 0; i < j; ++i) along[j] -= s[i] * along[i];
    along[j] /= length;
    of_last = without(s, length);
    return pass_of(std::move(along), square);
  }

  /// The second pass of basis_[j + 1] by itself.
  void finish(int j) {
    std::vector<double> along = basis_.dots(j + 1, basis_[j + 1], weights_);
    const double square = along.back();
    along.pop_back();
    const double length = second_pass(j, along, square);
    basis_.sum(basis_[j + 1], without(along, length));
    waits_ = false;
  }

  /// Column j after the second pass of basis_[j + 1], given its products. Returns the length of what is left of it.
  double second_pass(int j, const std::vector<double>& along, double square) {
    const Pass p = pass_of(along, square);
    std::vector<double>& h = column_[j];
    for (int i = 0; i <= j; ++i) h[i] += h[j + 1] * along[i];
    h[j + 1] *= p.rest;
    skew_ = std::max(skew_, std::min(p.skew, most_skew));
    return p.rest;
  }

  /// A vector without what it has along the v_i, divided by the length of what is left; zero where nothing is.
  static Combination without(std::vector<double> along, double length) {
    const double scale = length > 0 && std::isfinite(length) ? 1 / length : 0;
    for (double& a : along) a *= -scale;
    return {scale, std::move(along)};
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
      for (int i = 0; i <= j + 1; ++i) a[i] -= y_[j] * column_[j][i];
      cancelled_ += std::abs(y_[j]) * length_[j];
    }
    basis_.sum(residual_, {0, a});
    return length_of(residual_);
  }

  /// Norm of b - A x, which becomes basis_[0].
  template <class Apply>
  double true_residual(const Apply& apply, const Vector& b, const Vector& x) {
    apply(x, residual_);
    Kokkos::deep_copy(Exec(), basis_[0], b);
    add_scaled(basis_[0], 0, -1, residual_);
    return length_of(basis_[0]);
  }
  double length_of(const Vector& x) const { return weighted_norm<Real>(x, weights_); }

  /// Relative size of a vector that is nothing but round-off.
  static constexpr double round_off = std::is_same_v<Real, double> ? 1e-14 : 5e-6;
  static constexpr double unit = std::is_same_v<Real, double> ? 1e-16 : 6e-8;
  static constexpr double target_margin = 1.01, trusted = 0.01, most_skew = 1e-3;

  int restart_;
  Vector residual_;
  KrylovBasis<Real> basis_, direction_;
  RangeFactors weights_;
  std::vector<std::vector<double>> column_, rotated_;  ///< of the matrix between direction_ and basis_
  std::vector<double> length_;                         ///< of A z_j
  std::vector<double> c_, s_;                          ///< rotations
  std::vector<double> g_;                              ///< rotated right-hand side
  std::vector<double> left_;                           ///< its entry below g_[j - 1] after rotation j - 1
  std::vector<double> y_;
  bool waits_ = false;    ///< the second pass of the last vector
  double skew_ = 0;       ///< of two vectors of the basis: a bound of their product, from the steps so far
  double cancelled_ = 0;  ///< lengths of the terms of the residual, added up
};
using Gmres = GmresOf<double>;

}  // namespace softwet
