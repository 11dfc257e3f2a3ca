// How a scene is computed: time steps and solvers.
#pragma once

#include "case/choices.hpp"

namespace softwet {

struct TimeControl {
  TimeScheme scheme = TimeScheme::generalized_alpha;
  bool automatic = false;               ///< generalized_alpha or kick_drift, whichever takes less time
  MassKind mass = MassKind::corrected;  ///< of explicit schemes
  double safety = 0.9;                  ///< of explicit schemes: step over the largest stable one
  StartState start = StartState::initial;
  double rho_inf = 0.5;
  double end = 0;  ///< in t, the time of all results, which is 0 at the start of the first load
  double dt_initial = 1e-2;
  double dt_min = 1e-8;
  double dt_max = 50;
  double tolerance = 2e-3;  ///< of the error indicator that sets the step (src/time/step_control.hpp)
  long max_steps = 1000000;

  bool implicit() const { return scheme == TimeScheme::generalized_alpha; }
};

struct SolverControl {
  double newton_rtol = 1e-3;
  double newton_atol = 1e-10;
  int newton_max = 10;
  double newton_undershoot = 0.05;  ///< by which a control value of the density may fall below 0
  double krylov_rtol = 1e-2;
  int krylov_restart = 30;
  int krylov_max = 200;
  JacobianKind jacobian = JacobianKind::exact;
  PreconditionerKind preconditioner = PreconditionerKind::automatic;
  Launch launch = Launch::kernels;
  PrecisionChoice precision = PrecisionChoice::automatic;
};

}  // namespace softwet
