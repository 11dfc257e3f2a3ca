#include "time/runge_kutta.hpp"

#include <algorithm>
#include <cmath>

#include "time/sum_of.hpp"

namespace softwet {

Refusal SspRk3::advance(Evolution& f, double t, double dt, const Array& y, const Array& k) {
  sum_of(stage_, 1, y, dt, k, 0, k);
  Refusal problem = f.rates(t + dt, stage_, rate_);
  if (!problem.empty()) return problem;
  sum_of(stage_, 0.75, y, 0.25, stage_, 0.25 * dt, rate_);
  problem = f.rates(t + 0.5 * dt, stage_, rate_);
  sum_of(y, 1.0 / 3, y, 2.0 / 3, stage_, 2.0 / 3 * dt, rate_);
  return problem;
}

namespace {

/// An evolution without its stiff part.
class Gentle final : public Evolution {
 public:
  explicit Gentle(Evolution& whole) : whole_(whole) {}
  int size() const override { return whole_.size(); }
  Refusal rates(double t, const Array& y, const Array& out) override { return whole_.gentle_rates(t, y, out); }
  Refusal gentle_rates(double t, const Array& y, const Array& out) override { return rates(t, y, out); }
  Refusal stiff_rates(const Array&, const Array& out) override {
    Kokkos::deep_copy(Exec(), out, 0.0);
    return {};
  }
  Refusal hold(const Array&) override { return {}; }
  Refusal implicit_part(double, const Array&, const Array& out) override {
    Kokkos::deep_copy(Exec(), out, 0.0);
    return {};
  }

 private:
  Evolution& whole_;
};

}  // namespace

StrangRkl2::StrangRkl2(int size) : gentle_(size) {
  for (Array* a : {&gentle_rate_, &first_rate_, &rate_, &before_, &now_, &next_}) *a = Array("rkl2.vector", size);
}

int StrangRkl2::stages(double step, double radius) {
  constexpr double margin = 1.05;  // the radius is measured
  const int s = static_cast<int>(std::ceil(0.5 * (std::sqrt(9 + 8 * margin * step * radius) - 1)));
  return std::max(3, s % 2 == 1 ? s : s + 1);  // odd numbers damp the stiffest part more
}

Refusal StrangRkl2::stiff_step(Evolution& f, double dt, const Array& y) {
  Refusal problem = f.hold(y);
  if (problem.empty()) problem = f.stiff_rates(y, first_rate_);
  if (!problem.empty()) return problem;
  const auto b = [](int j) { return j < 2 ? 1.0 / 3 : (j * j + j - 2.0) / (2.0 * j * (j + 1)); };
  const int s = stages(dt, stiff_radius_);
  const double w = 4.0 / (s * s + s - 2);
  Kokkos::deep_copy(Exec(), before_, y);
  sum_of(now_, 1, y, b(1) * w * dt, first_rate_, 0, y);
  for (int j = 2; j <= s; ++j) {
    const double mu = (2.0 * j - 1) / j * b(j) / b(j - 1), nu = -(j - 1.0) / j * b(j) / b(j - 2);
    problem = f.stiff_rates(now_, rate_);
    if (!problem.empty()) return problem;
    sum_of(next_, mu, now_, nu, before_, 1 - mu - nu, y);
    add_scaled(next_, 0, mu * w * dt, rate_);
    add_scaled(next_, 0, -(1 - b(j - 1)) * mu * w * dt, first_rate_);
    std::swap(before_, now_);
    std::swap(now_, next_);
  }
  Kokkos::deep_copy(Exec(), y, now_);
  return {};
}

Refusal StrangRkl2::advance(Evolution& f, double t, double dt, const Array& y, const Array&) {
  Gentle gentle(f);
  Refusal problem = stiff_step(f, 0.5 * dt, y);
  if (problem.empty()) problem = gentle.rates(t, y, gentle_rate_);
  if (problem.empty()) problem = gentle_.advance(gentle, t, dt, y, gentle_rate_);
  return problem.empty() ? stiff_step(f, 0.5 * dt, y) : problem;
}

ImexArs343::ImexArs343(int size) : stage_("imex.stage", size) {
  for (Array& a : gentle_) a = Array("imex.gentle", size);
  for (Array& a : stiff_) a = Array("imex.stiff", size);
}

Refusal ImexArs343::advance(Evolution& f, double t, double dt, const Array& y, const Array& k) {
  // gamma is the middle root of 6 x^3 - 18 x^2 + 9 x - 1; the free coefficients are chosen as in the source.
  constexpr double g = 0.4358665215084590, b1 = -1.5 * g * g + 4 * g - 0.25, b2 = 1.5 * g * g - 5 * g + 1.25;
  constexpr double a42 = 0.5529291480359398, a43 = a42;
  constexpr double a31 =
      (1 - 4.5 * g + 1.5 * g * g) * a42 + (2.75 - 10.5 * g + 3.75 * g * g) * a43 - 3.5 + 13 * g - 4.5 * g * g;
  constexpr double a32 =
      (-1 + 4.5 * g - 1.5 * g * g) * a42 + (-2.75 + 10.5 * g - 3.75 * g * g) * a43 + 4 - 12.5 * g + 4.5 * g * g;
  constexpr double gentle[3][3] = {{g, 0, 0}, {a31, a32, 0}, {1 - a42 - a43, a42, a43}};
  constexpr double stiff[3][3] = {{g, 0, 0}, {(1 - g) / 2, g, 0}, {b1, b2, g}};
  constexpr double weight[3] = {b1, b2, g}, node[3] = {g, (1 + g) / 2, 1};
  Refusal problem;
  for (int i = 0; i < 3 && problem.empty(); ++i) {
    Kokkos::deep_copy(Exec(), stage_, y);
    for (int j = 0; j <= i; ++j) add_scaled(stage_, 0, dt * gentle[i][j], j == 0 ? k : gentle_[j - 1]);
    for (int j = 0; j < i; ++j) add_scaled(stage_, 0, dt * stiff[i][j], stiff_[j]);
    problem = f.hold(stage_);
    if (problem.empty()) problem = f.implicit_part(dt * g, stage_, stiff_[i]);
    if (problem.empty()) problem = f.gentle_rates(t + node[i] * dt, stage_, gentle_[i]);
  }
  if (!problem.empty()) return problem;
  for (int i = 0; i < 3; ++i) {
    add_scaled(y, 0, dt * weight[i], gentle_[i]);
    add_scaled(y, 0, dt * weight[i], stiff_[i]);
  }
  return {};
}

}  // namespace softwet
