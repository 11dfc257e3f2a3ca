// The size of the next step: from the local error, the effort of Newton's method, and the times that must be met.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace softwet {

struct StepLimits {
  double initial = 1e-2, smallest = 1e-8, largest = 50;
  double tolerance = 2e-3;                                ///< of the error indicator
  double slow = std::numeric_limits<double>::infinity();  ///< a longer step skips the oscillations of the scene
};

/// Effort of the solver in a step: `laborious` means that it almost failed.
enum class Effort { usual, laborious };

/// Step-size controller. The indicator compares a step's result with the linear extrapolation of the two states before:
///   e = max( rms(rho - rho_pred) / (rho_l - rho_v),  dt rms(v - v_pred) / H )  ~ dt^2,   H the thinner layer
class StepControl {
 public:
  /// @param events  in any order; of those that are the same but for a rounding the first one is met
  StepControl(const StepLimits& limits, std::vector<double> events);

  /// Step to take from t: the proposed one, cut (or slightly stretched) to meet the next event exactly, where it does
  /// not end behind it by a rounding either. It may be shorter than the smallest one for that, and is never longer than
  /// the largest one.
  /// @param largest  that the scheme can take from there, at least the smallest one; it is not exceeded but by a
  ///   rounding
  /// @param jump  an event that is not in the list: no step ends behind it
  double next(double t, double largest = std::numeric_limits<double>::infinity(),
              double jump = std::numeric_limits<double>::infinity()) const;

  /// Makes the next step as after a first state.
  void begin_anew() { proposed_ = std::min(proposed_, limits_.initial); }

  /// Takes an accepted step of size dt with its indicator.
  void accept(double dt, double indicator, Effort effort = Effort::usual);

  /// After a step that failed: halves. Returns false when the step has become smaller than allowed.
  bool reject(double dt);

  /// Indicator that a step of size dt may have. Swings forget the error of a step; creeping motion, which is all that a
  /// step longer than they are can follow, adds errors of one sign up along its path. So longer steps may have less:
  ///   tolerance * slow / dt,  not above the tolerance and not below a quarter of it
  double allowed(double dt) const;

  double proposed() const { return proposed_; }
  /// The longest step that may be taken next.
  double most() const { return stretch * proposed_; }
  double smallest() const { return limits_.smallest; }
  /// Kept within the limits, which may have changed since the step was proposed.
  void set_proposed(double dt) { proposed_ = std::clamp(dt, limits_.smallest, limits_.largest); }
  /// Indicator above which a converged step of size dt is repeated with a smaller one.
  double rejection_level(double dt) const { return 4 * allowed(dt); }

 private:
  static constexpr double stretch = 1.1;  ///< of a step that meets an event

  StepLimits limits_;
  std::vector<double> events_;  ///< ascending
  double proposed_;
};

}  // namespace softwet
