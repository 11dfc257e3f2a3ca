// The state a run starts from.
#pragma once

#include "field/stage.hpp"
#include "scene/scene.hpp"

namespace softwet {

/// A state with all arrays allocated for the layout, at rest, at time zero.
template <int D>
State empty_state(const Layout<D>& l) {
  State s;
  s.unknown = Array("state.unknown", l.size());
  s.velocity_rate = Array("state.velocity_rate", l.rate_size());
  s.displacement = Array("state.displacement", l.solid_size());
  s.displacement_rate = Array("state.displacement_rate", l.solid_size());
  s.moment = Array("state.moment", l.scalar_size());
  s.moment_rate = Array("state.moment_rate", l.scalar_size());
  if (l.branches == 0) return s;
  s.memory = Array("state.memory", l.memory_size());
  s.memory_rate = Array("state.memory_rate", l.memory_size());
  return s;
}

/// Fluid: the profile of the planar interface (kernels/fluid/interface_profile.hpp) around each droplet and film, its
/// middle density on the circle or the face, with curvature-corrected densities (Kelvin, Laplace), so that the vapour
/// need not equilibrate: mu = mu_sat + (D - 1) sigma / (R (rho_l - rho_v)). A droplet centred on the
/// wall is lowered to R cos(alpha) below it, so that its circle meets the wall at the contact angle. An ellipse
/// (`stretch`) meets it at another angle. A droplet with a velocity carries it times the same profile; all else is at
/// rest. The solid is undeformed. What the case gives under [initial] takes the place of these fields
/// (scene/given_start.hpp). Then the waves are added, and what the sides prescribe is kept.
/// Errors, the same on all processes: what cannot be computed, see scene/admissible.hpp.
/// Tested: tests/unit/scene/test_initial.cpp
template <int D, int P>
State initial_state(const Case&, const Scene<D, P>&);

}  // namespace softwet
