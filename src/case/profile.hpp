// A number of a case that may vary in space or time. No parser, no Kokkos: who reads a case file makes the formula.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace softwet {

/// A function of the position in the undeformed state (x, y, z; the last axis of a scene is vertical) and of the time t
/// of all results. The host evaluates it at control points and at points of the output. Several threads may: they take
/// turns where a formula has variables of its own.
class Formula {
 public:
  virtual ~Formula() = default;
  virtual double at(const std::array<double, 3>& x, double t) const = 0;
  /// Times at which a derivative jumps, where they are known: steps end there.
  virtual std::vector<double> kinks() const { return {}; }
  /// What tells formulas apart that have one text: the contents of a table.
  virtual std::string identity() const { return {}; }
};

/// A number, or a formula in its place.
struct Profile {
  double number = 0;                       ///< where it does not vary
  std::string text = {};                   ///< of the formula, as it stands in the case file; empty: the number
  std::shared_ptr<const Formula> formula;  ///< none: the number
  double lowest = 0, highest = 0;          ///< of the formula, over the part of the scene that it is for

  Profile() = default;
  Profile(double constant) : number(constant) {}

  bool varies() const { return formula != nullptr; }
  /// Smallest and largest value, for what needs one number.
  double least() const { return formula ? lowest : number; }
  double most() const { return formula ? highest : number; }
  double at(const std::array<double, 3>& x, double t = 0) const { return formula ? formula->at(x, t) : number; }
};

}  // namespace softwet
