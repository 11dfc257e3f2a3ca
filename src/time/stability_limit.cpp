#include "time/stability_limit.hpp"

#include <algorithm>
#include <cmath>

#include "field/vector.hpp"
#include "time/noise.hpp"

namespace softwet {
namespace {

constexpr double margin = 0.98;  ///< growth of a per cent in a step counts as none

}  // namespace

StabilityLimit::StabilityLimit(const VectorSpace& space, int size, ConstArray free)
    : space_(space), free_(std::move(free)) {
  for (Array* a : {&first_, &second_, &third_, &mode_, &rates_, &first_rates_}) *a = Array("stability.vector", size);
}

void StabilityLimit::step(RungeKutta& scheme, Evolution& f, double t, double dt) {
  ++steps_;
  const double length = norm(space_, second_);
  valid_ = length > 0 && std::isfinite(length);
  if (!valid_) return;
  combine(first_, 1 / length, second_, 0);
  combine(second_, 1 / length, third_, 0);
  Kokkos::deep_copy(Exec(), third_, second_);
  const Refusal problem = scheme.treats_stiff_part() ? f.gentle_rates(t, third_, rates_) : f.rates(t, third_, rates_);
  valid_ = problem.empty() && scheme.advance(f, t, dt, third_, rates_).empty() && std::isfinite(norm(space_, third_));
}

StabilityLimit::Eigenvalue StabilityLimit::pair(const ConstArray& a, const ConstArray& b, const ConstArray& c) const {
  // c = sum b - product a, by least squares; sum and product are those of a pair of eigenvalues.
  const auto product_of = [this](const ConstArray& x, const ConstArray& y) { return dot(space_, x, y); };
  const double aa = product_of(a, a), ab = product_of(a, b), bb = product_of(b, b), ac = product_of(a, c);
  const double bc = product_of(b, c), det = aa * bb - ab * ab;
  if (!(det > 1e-8 * aa * bb)) return {std::abs(bc) / bb, bc / bb};  // one real eigenvalue
  const double half = 0.5 * (aa * bc - ab * ac) / det, product = (ab * bc - bb * ac) / det;
  const double square = half * half - product;
  if (square < 0) return {std::sqrt(product), half};
  const double largest = half + std::copysign(std::sqrt(square), half);
  return {std::abs(largest), largest};
}

bool StabilityLimit::grows_by_itself(Evolution& f, double t, double dt, double size) {
  if (!f.rates(t, third_, first_rates_).empty() || !f.rates(t, first_rates_, rates_).empty()) return false;
  return std::log(size) < 2 * dt * pair(third_, first_rates_, rates_).real;
}

StabilityLimit::Growth StabilityLimit::growth(RungeKutta& scheme, Evolution& f, double t, double dt, int sure,
                                              int least) {
  constexpr int most = 24;
  constexpr double settled = 0.005;
  Growth now;
  for (int k = 0; k < most; ++k) {
    step(scheme, f, t, dt);
    if (!valid_) return {};
    if (k < 1) continue;  // the three vectors are of steps of different sizes
    const double before = now.size;
    now.size = pair(first_, second_, third_).size;
    if (k >= (now.size > 1.01 ? least : sure) && std::abs(now.size - before) < settled * now.size) break;
  }
  now.of_scheme = now.size > 1 && !grows_by_itself(f, t, dt, now.size);
  return now;
}

void StabilityLimit::begin() {
  if (!known_) Kokkos::deep_copy(Exec(), mode_, 0.0);
  add_noise(space_, mode_, free_);
  Kokkos::deep_copy(Exec(), second_, mode_);
  Kokkos::deep_copy(Exec(), third_, mode_);
}

StabilityLimit::Growth StabilityLimit::climb(RungeKutta& scheme, Evolution& f, double t, double& dt) {
  constexpr int most = 12;
  const double clear = known_ ? 1.02 : 1.3;
  for (int k = 0; k < most; ++k) {
    const Growth now = growth(scheme, f, t, dt);
    if (!valid_ || (now.unstable() && now.size > clear)) return now;
    dt *= now.unstable() ? 1.1 : 1.25;
  }
  return {};
}

void StabilityLimit::visit_memory(StepMemory& memory) {
  memory.number("stability/unstable", unstable_);
  memory.number("stability/exponent", exponent_);
  memory.flag("stability/known", known_);
  if (known_) memory.vector("stability/mode", mode_);
}

double StabilityLimit::follow(RungeKutta& scheme, Evolution& f, double t, Sight sight) {
  constexpr int most = 5, few = 6;
  constexpr double above = 1.04, fast = 1.4, other = 2, steep = 2, longer = 1.06;
  double dt = above * unstable_;
  begin();
  for (int k = 0; k < most && known_; ++k) {
    const bool look = sight == Sight::far && k == 0;
    const Growth now = growth(scheme, f, t, dt, look ? 2 * few : few, look ? 2 * few : 4);
    if (!valid_) break;
    if (now.unstable() && now.size > other) {  // the search begins with this mode
      Kokkos::deep_copy(Exec(), mode_, third_);
      break;
    }
    if (now.unstable() && now.size < fast) {
      Kokkos::deep_copy(Exec(), mode_, third_);
      unstable_ = dt / above;
      return margin * dt * std::pow(now.size, -1 / std::min(exponent_, steep));
    }
    dt *= now.unstable() ? std::clamp(std::pow(now.size, -1 / steep), 0.92, 0.97) : longer;
  }
  return 0;
}

double StabilityLimit::search(RungeKutta& scheme, Evolution& f, double t, double near) {
  constexpr int most = 20;
  constexpr double close = 1.02, slow = 1.04;
  begin();
  double unstable = (known_ ? 1.08 : 1.2) * near, stable = 0;
  Growth now = climb(scheme, f, t, unstable);
  known_ = now.unstable();
  if (!known_) return 0;
  Kokkos::deep_copy(Exec(), mode_, third_);
  unstable_ = unstable;
  for (int k = 0; k < most; ++k) {
    // The growth near the limit is at least like the step itself.
    if (now.size < slow) return margin * unstable / now.size;
    if (stable > 0 && unstable < close * stable) return margin * stable;
    const double guess = unstable * std::clamp(std::pow(now.size, -1 / exponent_), 0.75, 0.99);
    const double dt = stable > 0 ? std::sqrt(stable * unstable) : guess;
    // Each length of step begins with the mode of the next longer one: at a stable step it is lost.
    Kokkos::deep_copy(Exec(), second_, mode_);
    Kokkos::deep_copy(Exec(), third_, mode_);
    const Growth next = growth(scheme, f, t, dt);
    if (!valid_) break;
    if (next.unstable()) {
      exponent_ = std::clamp(std::log(now.size / next.size) / std::log(unstable / dt), 0.8, 5.0);
      unstable = unstable_ = dt, now = next;
      Kokkos::deep_copy(Exec(), mode_, third_);
    } else {
      stable = dt;
    }
  }
  known_ = false;
  return 0;
}

}  // namespace softwet
