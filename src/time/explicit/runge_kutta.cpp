#include "time/explicit/runge_kutta.hpp"

#include <algorithm>
#include <cmath>

#include "time/step/sum_of.hpp"

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

Rkl2::Rkl2(int size) {
  for (Array* a : {&first_rate_, &rate_, &before_, &now_, &next_}) *a = Array("rkl2.vector", size);
}

int Rkl2::stages(double dt, double radius) {
  const int s = static_cast<int>(std::ceil(0.5 * (std::sqrt(9 + 8 * dt * radius) - 1)));
  return std::max(3, s % 2 == 1 ? s : s + 1);  // odd numbers damp the stiffest part more
}

Refusal Rkl2::advance(const Rates& g, double dt, const Array& y, double radius) {
  Refusal problem = g(y, first_rate_);
  if (!problem.empty()) return problem;
  const auto b = [](int j) { return j < 2 ? 1.0 / 3 : (j * j + j - 2.0) / (2.0 * j * (j + 1)); };
  const int s = stages(dt, radius);
  const double w = 4.0 / (s * s + s - 2);
  Kokkos::deep_copy(Exec(), before_, y);
  sum_of(now_, 1, y, b(1) * w * dt, first_rate_, 0, y);
  for (int j = 2; j <= s; ++j) {
    const double mu = (2.0 * j - 1) / j * b(j) / b(j - 1), nu = -(j - 1.0) / j * b(j) / b(j - 2);
    problem = g(now_, rate_);
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

}  // namespace softwet
