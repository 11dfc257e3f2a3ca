// How explicit schemes invert the masses of velocity, density and chemical potential.
#pragma once

#include <string>

namespace softwet {

/// consistent: as they are, by conjugate gradients. lumped: replaced by their row sums, of second order in space.
/// corrected: row sums followed by three products with the mass, of sixth order for smooth fields; see MassInverse.
enum class MassKind { consistent, lumped, corrected };

inline MassKind mass_kind(const std::string& name) {
  if (name == "lumped") return MassKind::lumped;
  return name == "consistent" ? MassKind::consistent : MassKind::corrected;
}

}  // namespace softwet
