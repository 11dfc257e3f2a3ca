// The state at the start of a scene.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/choices.hpp"
#include "case/profile.hpp"

namespace softwet {

struct Droplet {
  std::vector<double> centre;  ///< of the circle or sphere; on the interface it becomes a cap cut at the contact angle
  double radius = 0;
  std::vector<double> stretch = {};   ///< semi-axes over the radius; empty: 1 along each axis
  std::vector<double> velocity = {};  ///< of its liquid at the start; empty: at rest
};

/// A box of liquid at the start.
struct Film {
  std::vector<double> lower, upper;
};

/// amplitude prod_d cos(mode_d pi x_d / L_d), added to a field at the start; sin along the field's own direction.
struct Wave {
  WaveField field = WaveField::density;
  double amplitude = 0;
  std::vector<double> mode;
};

struct EarlierState;  // scene/earlier_state.hpp

/// The state at the start where it is given at each point, in place of what droplets and films make.
struct Initial {
  std::string from;                             ///< output folder of an earlier run; empty: none
  std::vector<double> time;                     ///< of the field files of that run; empty: its last checkpoint
  std::shared_ptr<const EarlierState> earlier;  ///< that run, read where a run begins (run/earlier_run.hpp)
  std::optional<Profile> density;
  std::vector<Profile> velocity, displacement;  ///< one for each axis, or empty
};

}  // namespace softwet
