#include "time/implicit/convergence.hpp"

#include <algorithm>
#include <cmath>

namespace softwet {
namespace {

/// Where residuals count as solved because steps make them hardly smaller: the weighted norm of all fields at this many
/// times its measured round-off, or each field at this many times its own. The round-off at the solution differs from the
/// measured one, most where a field begins at rest.
constexpr double weighted_margin = 2, field_margin = 8;
/// A residual of fewer times its round-off is not worth the full weight of a field.
constexpr double signal_over_round_off = 100;

/// Accepted error of velocity and density up to which the prediction of a step may stand without an iteration: a fluid at
/// rest costs nothing so, and a solid one linear solve, see Newton::settled. A looser `atol` ends iterations, but does not
/// save the first one, for steps that extrapolate the states before and solve nothing drift away.
constexpr double at_rest = 1e-10;

/// What the first linear solve of a step is solved to. With 0.02 steps take a fifth fewer iterations, but end closer to
/// `rtol`: a droplet at rest then differs 25 times more from its mirror image (docs/development/solver_choices.md).
constexpr double first_forcing = 0.1;

}  // namespace

void Convergence::set_weights() {
  const double least = smallest_ * *std::max_element(sizes_.begin(), sizes_.end());
  weight_.resize(fields_.size());
  for (std::size_t f = 0; f < fields_.size(); ++f)
    weight_[f] = 1 / std::max({sizes_[f], fields_[f].floor, least, signal_over_round_off * fields_[f].round_off});
}

double Convergence::weighted_norm(const std::vector<double>& sizes) const {
  double sum = 0;
  for (std::size_t f = 0; f < sizes.size(); ++f) sum += std::pow(weight_[f] * sizes[f], 2);
  return std::sqrt(sum);
}

void Convergence::add(const std::vector<double>& sizes) {
  ++iteration_;
  sizes_ = sizes;
  if (iteration_ == 0) {
    set_weights();
    start_ = std::sqrt(static_cast<double>(fields_.size()));
  }
  previous_ = size_;
  size_ = weighted_norm(sizes_);
}

bool Convergence::finite() const { return std::isfinite(size_); }

bool Convergence::at_floor() const {
  // A field below its floor has a weight by that floor, so that the prediction may look small without being it.
  const double part = iteration_ == 0 ? std::min(1.0, at_rest / control_.atol) : 1;
  for (std::size_t f = 0; f < fields_.size(); ++f)
    if (!(sizes_[f] <= std::max(part * fields_[f].floor, field_margin * fields_[f].round_off))) return false;
  return true;
}

bool Convergence::reached() const {
  if (iteration_ > 0 && size_ <= control_.rtol * start_) return true;
  // When every field is at its floor it is as exact as asked for, whatever the relative reduction.
  if (at_floor()) return true;
  std::vector<double> round_off;
  for (const FieldRange& f : fields_) round_off.push_back(f.round_off);
  return size_ <= weighted_margin * weighted_norm(round_off);
}

bool Convergence::accepts(double remaining) {
  const bool stalls = std::isfinite(remaining_) && !(remaining < 0.5 * remaining_);
  insists_ = std::isfinite(remaining);
  remaining_ = remaining;
  return remaining <= 1 || stalls;
}

bool Convergence::diverges() {
  if (iteration_ <= 2) return false;
  constexpr double far = 1e4;
  if (control_.bends) return size_ > far * start_;
  const double ratio = size_ / previous_;
  const bool again = risen_ && ratio > 2;
  risen_ = risen_ || ratio > 2;
  return again || (size_ / start_ > 1 && ratio > 0.5);
}

double Convergence::forcing() const {
  if (insists_) return std::min(0.1, control_.krylov_rtol);
  double forcing = first_forcing;
  if (iteration_ > 0) {
    const double ratio = size_ / previous_;
    forcing = std::clamp(0.9 * ratio * ratio, std::min(0.1, control_.krylov_rtol), 0.1);
  }
  return std::max(forcing, std::min(0.1, 0.5 * control_.rtol * start_ / size_));
}

RangeFactors Convergence::weights() const {
  RangeFactors weights;
  for (std::size_t f = 0; f < fields_.size(); ++f)
    weights.add(fields_[f].first, fields_[f].last, weight_[f] * weight_[f]);
  return weights;
}

}  // namespace softwet
