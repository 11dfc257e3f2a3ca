// One axis of a tensor-product patch: knots, knot spans, Greville points, and B-spline evaluation (host).
#pragma once

#include <vector>

namespace softwet {

/// Bounded: with two ends. Periodic: the ends are joined. Radial: bounded, the distance from an axis of symmetry.
enum class AxisKind { bounded, periodic, radial };

/// B-splines of one degree on a line of elements, equal or graded ones: C^(degree-1), except C^0 at up to two optional
/// knots; ends are interpolating. A periodic axis stores `degree` ghost functions behind its own.
class Axis {
 public:
  /// @param length    extent, L0
  /// @param kink      index of the element at the wall, whose lower knot is repeated `degree` times (C0 there); 0: none
  /// @param joint     index of the element at a joint, with a knot repeated in the same way; 0: none
  Axis(double length, int elements, int degree, AxisKind kind = AxisKind::bounded, int kink = 0, int joint = 0);
  /// Elements between ascending breaks, of which the first is 0 and the last the length.
  Axis(std::vector<double> breaks, int degree, AxisKind kind = AxisKind::bounded, int kink = 0, int joint = 0);

  int degree() const { return degree_; }
  int elements() const { return elements_; }
  int functions() const { return functions_; }  ///< stored functions, ghosts included
  int owned() const { return periodic() ? elements_ : functions_; }
  AxisKind kind() const { return kind_; }
  bool periodic() const { return kind_ == AxisKind::periodic; }
  /// What a length along the axis counts at x in an integral over the patch: the radius r in (r, z), else 1.
  double weight(double x) const { return kind_ == AxisKind::radial ? x : 1.0; }
  double length() const { return length_; }
  bool graded() const { return !breaks_.empty(); }
  double spacing() const {
    return spacing_;
  }  ///< length of the shortest element, which all have unless they are graded
  double size(int element) const { return graded() ? breaks_[element + 1] - breaks_[element] : spacing_; }
  /// Into how many equal parts the axis above an element falls that are about as long as the shortest element.
  int equal_parts(int element = 0) const;
  /// Integral of a function, without the weight; L0.
  double integral(int function) const { return (knots_[function + degree_ + 1] - knots_[function]) / (degree_ + 1); }
  /// Point number i of those at the ends and in the middle of the elements: 2 elements() + 1.
  double end_or_middle(int i) const;
  int span(int element) const { return span_[element]; }  ///< first function that is non-zero on the element
  double lower(int element) const { return graded() ? breaks_[element] : length_ * element / elements_; }
  double greville(int function) const { return greville_[function]; }  ///< periodic: may lie outside [0, length]
  int element_at(double x) const;
  const std::vector<double>& knots() const { return knots_; }
  const std::vector<double>& breaks() const { return breaks_; }  ///< empty unless graded
  int kink() const { return kink_; }
  int joint() const { return joint_; }

  /// Values or first derivatives of the degree + 1 functions alive on an element at x (derivative: 1/L0).
  std::vector<double> values(int element, double x) const;
  std::vector<double> slopes(int element, double x) const;
  /// Writes the values of the functions to result[0 .. degree].
  void values(int element, double x, double* result) const;
  void slopes(int element, double x, double* result) const;

  /// Exact integrals of all functions over [a, b] with the weight, restricted to the elements [first, last).
  std::vector<double> integrals(double a, double b, int first, int last) const;

 private:
  void evaluate(int element, double x, int degree, double* n) const;
  double end_of(int element) const;  ///< lower end; beyond the ends of a periodic axis it goes on
  void place_knots();

  int degree_, elements_, functions_, kink_, joint_;
  AxisKind kind_;
  double length_, spacing_;
  std::vector<double> breaks_;
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
