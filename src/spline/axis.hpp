// One axis of a tensor-product patch: knots, knot spans, Greville points, and B-spline evaluation (host).
#pragma once

#include <vector>

namespace softwet {

/// B-splines of one degree on a line of uniform elements: C^(degree-1), except C^0 at one optional knot; the ends are
/// interpolating, or the axis is periodic. A periodic axis stores `degree` ghost functions behind its own.
class Axis {
 public:
  /// @param length    extent, L0
  /// @param kink      element index whose lower knot is repeated `degree` times (C0 there); 0: none
  Axis(double length, int elements, int degree, bool periodic = false, int kink = 0);

  int degree() const { return degree_; }
  int elements() const { return elements_; }
  int functions() const { return functions_; }  ///< stored functions, ghosts included
  int owned() const { return periodic_ ? elements_ : functions_; }
  bool periodic() const { return periodic_; }
  double length() const { return length_; }
  double spacing() const { return length_ / elements_; }
  int span(int element) const { return span_[element]; }  ///< first function that is non-zero on the element
  double lower(int element) const { return length_ * element / elements_; }
  double greville(int function) const { return greville_[function]; }  ///< periodic: may lie outside [0, length]
  int element_at(double x) const;
  const std::vector<double>& knots() const { return knots_; }
  int kink() const { return kink_; }

  /// Values or first derivatives of the degree + 1 functions alive on an element at x (derivative: 1/L0).
  std::vector<double> values(int element, double x) const;
  std::vector<double> slopes(int element, double x) const;

  /// Exact integrals of all functions over [a, b], restricted to the elements [first, last).
  std::vector<double> integrals(double a, double b, int first, int last) const;

 private:
  std::vector<double> evaluate(int element, double x, int degree) const;

  int degree_, elements_, functions_, kink_;
  bool periodic_;
  double length_;
  std::vector<double> knots_;
  std::vector<int> span_;
  std::vector<double> greville_;
};

/// Gauss-Legendre points and weights on [0, 1], exact to degree 2 n - 1.
struct Gauss {
  explicit Gauss(int n);
  std::vector<double> point, weight;
};

}  // namespace softwet
