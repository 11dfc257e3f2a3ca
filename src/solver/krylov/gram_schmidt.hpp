// The orthonormal basis of a Krylov method, made by classical Gram-Schmidt with one set of sums for each vector.
#pragma once

#include <algorithm>
#include <cmath>

#include "solver/krylov/krylov_basis.hpp"

namespace softwet {

/// Vectors v_0, v_1, ... of length 1, and columns h_j of A z_j = sum_i h_ij v_i for the directions z_j of the method.
///
/// One pass over the basis takes all products of a new vector, and a second one follows where the angles would be off
/// by a thousandth (Daniel, Gragg, Kaufman and Stewart 1976). The second pass waits for the first one of the next
/// vector, so that both read the basis once and share one reduction (Bielich et al. 2022). Meanwhile the vector is good
/// enough for a preconditioner. It comes at once only where a vector is far off, or where the method asks for it.
template <class Real>
class GramSchmidt {
 public:
  using Vector = ArrayOf<Real>;
  using Dots = typename KrylovBasis<Real>::Dots;

  GramSchmidt(const char* name, const VectorSpace& space, int size, int count)
      : space_(space), basis_(name, space, size, count) {}

  const Vector& operator[](int j) const { return basis_[j]; }
  const std::vector<double>& column(int j) const { return column_[j]; }
  double length(int j) const { return length_[j]; }  ///< of A z_j
  bool waits() const { return waits_; }              ///< the second pass of the last vector
  void sum(const Vector& out, const Combination& c) const { basis_.sum(out, c); }
  double length_of(const Vector& x) const { return weighted_norm<Real>(space_, x, weights_); }

  /// Begins with a vector of this length, over its length.
  void begin(const Vector& first, double length) {
    combine(basis_[0], 1 / length, first, 0);
    column_.clear();
    length_.clear();
    skew_ = 0;
    waits_ = false;
  }
  /// Sets the weights of the squares in norms, for the next begin.
  void set_weights(const RangeFactors& weights) { weights_ = weights; }

  /// Takes the next vector, which holds A z_j, as v_{j+1}; it is zero where nothing is left of A z_j. Its second pass
  /// may wait; the second pass of v_j is done. Returns whether column j - 1 has changed by it.
  bool add() {
    constexpr double most_blur = 0.02, may_wait = 0.1;
    const int j = static_cast<int>(column_.size());
    const bool both = waits_;
    Combination of_last;
    const Pass p = pass_of(both ? first_after_second(j, of_last) : basis_.dots(j + 1, basis_[j + 1], weights_));
    const bool enough = p.skew < most_skew && p.blur < most_blur;
    waits_ = !enough && p.skew < may_wait && p.blur < may_wait;
    const double divisor = enough || waits_ ? p.rest : 1;
    length_.push_back(std::sqrt(p.dots.square));
    column_.push_back(p.dots.along);
    column_[j].push_back(divisor);
    Combination of_next = without(p.dots.along, divisor);
    if (both) {
      const double link = of_next.a.back();
      of_next.a.pop_back();
      basis_.sum_two(basis_[j], of_last, basis_[j + 1], of_next, link);
    } else {
      basis_.sum(basis_[j + 1], of_next);
    }
    if (enough) skew_ = std::max(skew_, p.skew);
    if (!enough && !waits_) finish();
    return both;
  }

  /// The second pass of the last vector by itself; the last column changes.
  void finish() {
    const int j = static_cast<int>(column_.size()) - 1;
    const Dots d = basis_.dots(j + 1, basis_[j + 1], weights_);
    const double length = second_pass(j, d);
    basis_.sum(basis_[j + 1], without(d.along, length));
    waits_ = false;
  }

 private:
  /// Products of a vector, and what they leave of it.
  struct Pass {
    Dots dots;
    double rest = 0;  ///< length of what is left
    double skew = 0;  ///< bound of its products with the v_i, once it has the length 1
    double blur = 0;  ///< bound of the error of rest^2, relative
  };

  /// A pass leaves as much along the vectors before as their angles are off, and the square of what is left, a
  /// difference, is off as much.
  Pass pass_of(Dots dots) const {
    Pass p{std::move(dots)};
    double taken = 0;
    for (double a : p.dots.along) taken += a * a;
    const double square = p.dots.square, left = std::max(0.0, square - taken), off = p.dots.along.size() * skew_;
    p.rest = std::sqrt(left);
    p.skew = p.rest > 0 ? (off * std::sqrt(taken) + unit * std::sqrt(square)) / p.rest : 0;
    p.blur = (off * taken + 1e-14 * square) / left;
    return p;
  }

  /// The second pass of u = basis_[j], whose outcome v_j = (u - sum_i s_i v_i) / |.| is not there yet, and the products
  /// of w = basis_[j + 1]: the product with v_j follows from the products of u.
  Dots first_after_second(int j, Combination& of_last) {
    auto [of_w, of_u] = basis_.dots_with_last(j + 1, basis_[j + 1], weights_);
    const double length = second_pass(j - 1, of_u);
    double& last = of_w.along[j];
    for (int i = 0; i < j; ++i) last -= of_u.along[i] * of_w.along[i];
    last /= length;
    of_last = without(of_u.along, length);
    return std::move(of_w);
  }

  /// Column j after the second pass of basis_[j + 1], given its products. Returns the length of what is left of it.
  double second_pass(int j, const Dots& dots) {
    const Pass p = pass_of(dots);
    std::vector<double>& h = column_[j];
    for (int i = 0; i <= j; ++i) h[i] += h[j + 1] * dots.along[i];
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

  static constexpr double unit = std::is_same_v<Real, double> ? 1e-16 : 6e-8, most_skew = 1e-3;

  VectorSpace space_;
  KrylovBasis<Real> basis_;
  RangeFactors weights_;
  std::vector<std::vector<double>> column_;
  std::vector<double> length_;
  bool waits_ = false;
  double skew_ = 0;  ///< of two vectors of the basis: a bound of their product, from the steps so far
};

}  // namespace softwet
