// A gel whose shear modulus grows as a power of the frequency, as branches and a dashpot.
#pragma once

#include "case/case.hpp"

namespace softwet {

/// Most branches that a solid may have, including the branches of its power law.
inline constexpr int most_branches = 12;

/// Maxwell branches and a viscosity whose modulus is near G (1 + (i w time)^n). The power is the integral of
/// sin(n pi)/pi (s time)^n i w / (i w + s) over ln s; a branch 1/s stands for each equal part d of that axis,
///   G_j = G sin(n pi)/pi (s_j time)^n d,
/// and the viscosity for all that is faster than half a part beyond the last one. About 1.5 branches stand for a
/// decade, and they reach one decade beyond the range of frequencies on both sides.
/// Tested: tests/unit/case/test_gel.cpp
struct GelFit {
  std::vector<Branch> branches;  ///< none where there is no power law
  double viscosity = 0;

  /// @param modulus  G
  static GelFit of(double modulus, const PowerLaw&);
  /// Largest |G - G_exact| / |G_exact| at the frequencies of the law.
  double error(double modulus, const PowerLaw&) const;
};

/// The branches of the case, then the branches of its power law.
std::vector<Branch> all_branches(const Substrate&);

/// Shear viscosity of the solid, including the viscosity of its power law.
double shear_viscosity(const Substrate&);

}  // namespace softwet
