// The foundation of a solid, springs and dashpots below it: its numbers, its keys and their checks, its groups.
#pragma once

#include <vector>

namespace softwet {

struct Checker;
struct FoundationTerms;  // kernels/foundation/terms.hpp
struct Key;

struct FoundationPart {
  using Terms = FoundationTerms;

  std::vector<double> springs = {};   ///< kap_n and kap_t below the solid, scale a b^2/L0; empty: none
  std::vector<double> dashpots = {};  ///< c_n and c_t beside them, scale b sqrt(ab); empty: none

  bool acts() const { return !springs.empty() || !dashpots.empty(); }
  static std::vector<Key> keys();
  void check(const Checker&) const;
  /// Calls add(name, value, meaning) for each dimensionless group of the part with its solid.
  template <class Solid, class Add>
  void add_groups(const Solid& s, const Add& add) const {
    if (!springs.empty())
      add("foundation_over_layer",
          springs[0] * s.thickness * (1 - 2 * s.poisson) / (2 * s.shear_modulus() * (1 - s.poisson)),
          "kap_n Hs / (lambda + 2 G): springs below the layer over its own stiffness");
  }
};

}  // namespace softwet
