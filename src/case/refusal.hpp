// Why an attempted step does not count.
#pragma once

namespace softwet {

/// A cause, and the sentence for it. Empty: the step counts.
struct Refusal {
  enum Cause {
    none,
    not_finite,
    close_packed,
    negative_density,
    solid_inverted,
    mesh_folded,
    newton,
    linear_solver,
    density_of_moments,
    potential,
    acceleration,
    viscous_rate,
    beyond_bound
  };
  Cause cause = none;

  bool empty() const { return cause == none; }
  bool operator==(const Refusal&) const = default;

  const char* text() const {
    switch (cause) {
      case none:
        return "";
      case not_finite:
        return "the solution is not finite";
      case close_packed:
        return "the density reaches the close-packed limit (rho >= 0.999 b)";
      case negative_density:
        return "the density becomes negative (solver.newton.undershoot)";
      case solid_inverted:
        return "the solid is turned inside out somewhere (det F <= 0)";
      case mesh_folded:
        return "the mesh of the fluid folds over above the deformed solid (J < 0)";
      case newton:
        return "Newton's method did not converge";
      case linear_solver:
        return "the linear solver stalled";
      case density_of_moments:
        return "the density could not be found from its moments";
      case potential:
        return "the chemical potential could not be found";
      case acceleration:
        return "the acceleration could not be found";
      case viscous_rate:
        return "the acceleration by viscosity could not be found";
      case beyond_bound:
        return "at the end of the step the largest stable step is shorter than it";
    }
    return "";
  }
};

}  // namespace softwet
