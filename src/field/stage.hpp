// The state between steps, and the stage at which the equations are evaluated.
#pragma once

#include "field/layout.hpp"
#include "field/vector.hpp"

namespace softwet {

/// All integrator levels at time t: what a restart needs.
struct State {
  double time = 0;
  Array unknown;            ///< velocity, density, chemical potential (layout of the unknowns)
  Array velocity_rate;      ///< dv/dt, and d rho/dt in the rows of Layout::rate_rows
  Array displacement;       ///< solid rows
  Array displacement_rate;  ///< du/dt
  Array moment;             ///< p_i = (q_i, rho J)
  Array moment_rate;        ///< dp_i/dt
  Array memory = {};        ///< a_i or A_i of Branches, one behind the other
  Array memory_rate = {};   ///< their rates, of a time memory_shift before
  double memory_shift = 0;  ///< of the last step, for reporting only; 0 after a restart
};

/// Fields at the generalized-alpha point and at the end of the step. Unknowns are the values at n + af.
template <class Real>
struct StageOf {
  double time = 0;                 ///< t_{n+af}
  ArrayOf<Real> unknown;           ///< v, rho, mu at n+af
  ArrayOf<Real> acceleration;      ///< dv/dt at n+am, and d rho/dt in the rows of Layout::rate_rows
  ArrayOf<Real> displacement;      ///< at n+af
  ArrayOf<Real> displacement_end;  ///< at n+1
  ArrayOf<Real> density_end;       ///< at n+1
  double rate_scale = 0;           ///< d acceleration / d velocity
  double displacement_scale = 0;   ///< d displacement / d velocity
  double end_scale = 1;            ///< d density_end / d density = d displacement_end / d displacement
  double moment_rate = 0;          ///< am / (ga dt), factor of the moments at n+1; 0: fluxes alone
  double density_rate_scale = 0;   ///< d (d rho/dt) / d rho; 0 where the rates count as 0
  ArrayOf<Real> lag = {};          ///< q of BranchStress at n+af, or h of FiniteBranchStress at the points
  double branch_weight = 0;        ///< W of Branches: d q / d displacement; 0 where the branches carry nothing
  ConstArray memory = {}, memory_rate = {};  ///< of the branches, where the stage belongs to a state
  double memory_shift = 0;
};
using Stage = StageOf<double>;

/// Arrays for a stage of a layout.
template <class Real, int D>
StageOf<Real> make_stage(const Layout<D>& l) {
  StageOf<Real> s;
  s.unknown = ArrayOf<Real>("stage.unknown", l.size());
  s.acceleration = ArrayOf<Real>("stage.acceleration", l.rate_size());
  s.displacement = ArrayOf<Real>("stage.displacement", l.solid_size());
  s.displacement_end = ArrayOf<Real>("stage.displacement_end", l.solid_size());
  s.density_end = ArrayOf<Real>("stage.density_end", l.scalar_size());
  if (l.branches > 0) s.lag = ArrayOf<Real>("stage.lag", l.branch_size());
  return s;
}

/// to = from, rounded.
inline void round_stage(StageOf<float>& to, const Stage& from) {
  to.time = from.time;
  convert(to.unknown, from.unknown);
  convert(to.acceleration, from.acceleration);
  convert(to.displacement, from.displacement);
  convert(to.displacement_end, from.displacement_end);
  convert(to.density_end, from.density_end);
  to.rate_scale = from.rate_scale;
  to.displacement_scale = from.displacement_scale;
  to.end_scale = from.end_scale;
  to.moment_rate = from.moment_rate;
  to.density_rate_scale = from.density_rate_scale;
  if (from.lag.extent(0) > 0) convert(to.lag, from.lag);
  to.branch_weight = from.branch_weight;
}

/// The stage at a state itself, for integrals and output: its values, and no scales of a scheme.
template <int D>
Stage stage_at(const Layout<D>& l, const State& state) {
  Stage s;
  s.time = state.time;
  s.unknown = state.unknown;
  s.acceleration = state.velocity_rate;
  s.displacement = s.displacement_end = state.displacement;
  s.memory = state.memory;
  s.memory_rate = state.memory_rate;
  s.memory_shift = state.memory_shift;
  if (l.has_fluid)
    s.density_end = Kokkos::subview(state.unknown, Kokkos::make_pair(l.density_offset(), l.potential_offset()));
  return s;
}

}  // namespace softwet
