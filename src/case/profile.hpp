// A number of a case that may vary in space or time. No parser, no Kokkos: who reads a case file makes the formula.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace softwet {

/// A function of the position in the undeformed state (x, y, z; the last axis of a scene is vertical) and of the time t of all
/// results.
class Formula {
 public:
  virtual ~Formula() = default;
  virtual double at(const std::array<double, 3>& x, double t) const = 0;
  /// Times at which a derivative jumps, where they are known: steps end there.
  virtual std::vector<double> kinks() const { return {}; }
};

/// A number, or a formula in its place.
struct Profile {
  double number = 0;                       ///< where it does not vary
  std::string text = {};                   ///< of the formula, as it stands in the case file; empty: the number
  std::shared_ptr<const Formula> formula;  ///< none: the number

  Profile() = default;
  Profile(double constant) : number(constant) {}

  bool varies() const { return formula != nullptr; }
  double at(const std::array<double, 3>& x, double t = 0) const { return formula ? formula->at(x, t) : number; }
};

}  // namespace softwet
