// The balance of a scene's energy: what feeds it, what it loses, and when it rises though nothing fed it. Plain
// numbers.
#pragma once

namespace softwet {

/// The energy of a state, and the powers that change it.
struct EnergyState {
  double time = 0;
  double energy = 0;   ///< sum of all parts, a b^2 L0^D
  double size = 0;     ///< sum of the sizes of the parts, of which the round-off of the energy is a part
  double kinetic = 0;  ///< one of the parts
  double fed = 0;      ///< power of the loads and of the stretching wall
  double lost = 0;     ///< dissipation
};

/// How far the energy rises from one state to another above the energy fed in meanwhile, by the trapezoidal rule:
///   E_1 - E_0 - dt/2 (fed_0 + fed_1)
/// Where the equations have an energy law this is minus the dissipation, up to the error of the discretisation.
inline double unfed_rise(const EnergyState& a, const EnergyState& b) {
  return b.energy - a.energy - 0.5 * (b.time - a.time) * (a.fed + b.fed);
}

/// Round-off that an energy of this size may rise by.
inline double round_off_of(const EnergyState& a) { return 1e-11 * a.size; }

/// The level above which an energy may not rise: its lowest value so far; or its first value, where steps do not keep
/// this energy and it oscillates below its first value.
enum class EnergyFloor { lowest, first };

/// When an energy counts as having risen.
struct EnergyRule {
  double share;  ///< of the energy in play by which it may rise
  EnergyFloor floor = EnergyFloor::lowest;
};

/// Follows a run and reports when its energy has risen though nothing fed it. The energy less all energy fed in can
/// only fall. It has risen where it stands above its floor by more than
///   share (largest kinetic energy so far + all energy lost so far) + 1/4 (all energy fed in so far, in size)
/// The largest kinetic energy counts because a wave that turns has none. The last part is there because power is known
/// at the states alone. Above its first value the energy includes all lost energy, so that it would stay there. All
/// members are numbers of a checkpoint.
/// Tested: tests/unit/time/test_energy_balance.cpp
struct EnergyBalance {
  bool begun = false;
  bool told = false;         ///< that it rises, in the episode that lasts
  EnergyState last;          ///< state
  double rise = 0;           ///< above the floor; below the first value it is negative
  double lost = 0, fed = 0;  ///< so far
  double moving = 0;         ///< largest kinetic energy so far

  /// Goes on to the next state. @return by how much the energy has risen, once in an episode, which ends when it falls;
  /// else 0
  double follow(const EnergyState& next, const EnergyRule&);
};

/// With the default tolerances the steps of generalized_alpha let the energy rise by up to 0.0003 of the energy in
/// play, and explicit steps beyond their limit by 0.01 and more before error control damped them.
inline constexpr EnergyRule with_energy_law{0.005};
/// The wall law "gradient" feeds the droplet: up to a quarter of the energy in play, near contact angles of 30 and 150
/// degrees.
inline constexpr EnergyRule without_energy_law{0.5};
/// A solid alone with lumped or corrected masses: they are at least as large as the consistent ones of the tables,
/// whose energy is the smaller the shorter the waves are. It stays below 1.05 of its first value in the study
/// stiff_solids; steps that feed waves make it many times larger.
inline constexpr EnergyRule with_other_masses{0.25, EnergyFloor::first};

}  // namespace softwet
