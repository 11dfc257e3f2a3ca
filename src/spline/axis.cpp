#include "spline/axis.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace softwet {

Axis::Axis(double length, int elements, int degree, AxisKind kind, int kink, int joint)
    : degree_(degree),
      elements_(elements),
      kink_(kink),
      joint_(joint),
      kind_(kind),
      length_(length),
      spacing_(length / elements) {
  place_knots();
}

Axis::Axis(std::vector<double> breaks, int degree, AxisKind kind, int kink, int joint)
    : degree_(degree),
      elements_(static_cast<int>(breaks.size()) - 1),
      kink_(kink),
      joint_(joint),
      kind_(kind),
      length_(breaks.back()),
      spacing_(breaks.back()),
      breaks_(std::move(breaks)) {
  for (int e = 0; e < elements_; ++e) spacing_ = std::min(spacing_, size(e));
  place_knots();
}

double Axis::end_of(int element) const {
  if (!graded()) return element == elements_ && !periodic() ? length_ : spacing_ * element;
  const int turns = element < 0 ? -1 : periodic() && element >= elements_ ? 1 : 0;
  return breaks_[element - turns * elements_] + turns * length_;
}

void Axis::place_knots() {
  if (periodic()) {
    for (int i = -degree_; i <= elements_ + degree_; ++i) knots_.push_back(end_of(i));
    for (int e = 0; e < elements_; ++e) span_.push_back(e);
  } else {
    knots_.insert(knots_.end(), degree_, 0.0);
    for (int e = 0; e <= elements_; ++e) {
      const int copies = e > 0 && (e == kink_ || e == joint_) ? degree_ : 1;
      knots_.insert(knots_.end(), copies, end_of(e));
      if (e < elements_) span_.push_back(static_cast<int>(knots_.size()) - 1 - degree_);
    }
    knots_.insert(knots_.end(), degree_, length_);
  }
  functions_ = static_cast<int>(knots_.size()) - degree_ - 1;
  for (int i = 0; i < functions_; ++i) {
    double sum = 0;
    for (int k = 1; k <= degree_; ++k) sum += knots_[i + k];
    greville_.push_back(sum / degree_);
  }
}

int Axis::element_at(double x) const {
  if (!graded()) return static_cast<int>(std::clamp(std::floor(x / spacing()), 0.0, elements_ - 1.0));
  const auto above = std::upper_bound(breaks_.begin(), breaks_.end(), x);
  return std::clamp(static_cast<int>(above - breaks_.begin()) - 1, 0, elements_ - 1);
}

int Axis::equal_parts(int element) const {
  if (!graded()) return elements_ - element;
  return static_cast<int>(std::ceil((length_ - lower(element)) / spacing_ - 1e-9));
}

double Axis::end_or_middle(int i) const {
  if (!graded()) return length_ * i / (2.0 * elements_);
  return i % 2 == 0 ? breaks_[i / 2] : 0.5 * (breaks_[i / 2] + breaks_[i / 2 + 1]);
}

// Cox-de Boor recursion: the degree + 1 functions alive on a knot span (de Boor, A Practical Guide to Splines, ch. X).
void Axis::evaluate(int element, double x, int degree, double* n) const {
  const int k = span_[element] + degree_;  // knots_[k] <= x <= knots_[k + 1]
  n[0] = 1.0;
  for (int p = 1; p <= degree; ++p) {
    double saved = 0.0;
    for (int r = 0; r < p; ++r) {
      const double right = knots_[k + r + 1], left = knots_[k + 1 - p + r];
      const double part = n[r] / (right - left);
      n[r] = saved + (right - x) * part;
      saved = (x - left) * part;
    }
    n[p] = saved;
  }
}

void Axis::values(int element, double x, double* result) const { evaluate(element, x, degree_, result); }

void Axis::slopes(int element, double x, double* result) const {
  evaluate(element, x, degree_ - 1, result);
  const int first = span_[element];
  double before = 0;  // what the function of the lower degree before adds
  for (int a = 0; a <= degree_; ++a) {
    const int i = first + a;
    const double lower = a < degree_ ? degree_ * result[a] / (knots_[i + degree_ + 1] - knots_[i + 1]) : 0;
    result[a] = before - lower;
    before = lower;
  }
}

std::vector<double> Axis::values(int element, double x) const {
  std::vector<double> result(degree_ + 1);
  values(element, x, result.data());
  return result;
}

std::vector<double> Axis::slopes(int element, double x) const {
  std::vector<double> result(degree_ + 1);
  slopes(element, x, result.data());
  return result;
}

std::vector<double> Axis::integrals(double a, double b, int first, int last) const {
  const Gauss rule(degree_ + 1);
  std::vector<double> result(functions_, 0.0);
  for (int e = first; e < last; ++e) {
    const double lo = std::max(a, lower(e)), hi = std::min(b, lower(e + 1));
    if (hi <= lo) continue;
    for (std::size_t q = 0; q < rule.point.size(); ++q) {
      const double x = lo + (hi - lo) * rule.point[q], own = (hi - lo) * rule.weight[q] * weight(x);
      const std::vector<double> v = values(e, x);
      for (int i = 0; i <= degree_; ++i) result[span_[e] + i] += own * v[i];
    }
  }
  return result;
}

Gauss::Gauss(int n) : point(n), weight(n) {
  for (int i = 0; i < n; ++i) {
    double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5)), slope = 1.0;
    for (int iteration = 0; iteration < 100; ++iteration) {
      double p = 1.0, previous = 0.0;
      for (int k = 1; k <= n; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * previous) / k;
        previous = p;
        p = next;
      }
      slope = n * (x * p - previous) / (x * x - 1.0);
      const double step = p / slope;
      x -= step;
      if (std::abs(step) < 1e-16) break;
    }
    point[n - 1 - i] = 0.5 * (1.0 + x);
    weight[n - 1 - i] = 1.0 / ((1.0 - x * x) * slope * slope);
  }
}

}  // namespace softwet
