// A solid that flows and fades: Maxwell branches beside its elasticity (generalised Maxwell).
#pragma once

#include "kernels/point/solid_fields.hpp"

namespace softwet {

/// Springs G_i that act in shear alone, each in series with a dashpot, so that its stress fades within the time tau_i:
///   psi_i = 1/2 (e - A_i) : C_i : (e - A_i),   C_i = 2 G_i dev,   tau_i A_i' = e - A_i,   e = sym Grad u
/// A_i = sym Grad a_i of a displacement a_i of the dashpot, with tau_i a_i' = u - a_i. The dashpots dissipate
/// tau_i A_i' : C_i : A_i'. A time scheme that finds u - a_i = tau_i / (tau_i + c) (u - h_i) at the end of a step, with h_i from its
/// beginning and a time c of its own, meets the stress dev sym Grad q of one vector q = sum w_i (u - h_i), however many branches there are.
/// Source: Simo, Hughes, Computational Inelasticity, chapter 10 (generalised relaxation).   Tested: tests/unit/solid/test_branches.cpp
struct Branches {
  static constexpr int most = 12;

  int count = 0;
  double modulus[most] = {};  ///< G_i, scale a b^2
  double time[most] = {};     ///< tau_i, scale L0/sqrt(ab)

  /// w_i = 2 G_i tau_i / (tau_i + c)
  KOKKOS_FORCEINLINE_FUNCTION double weight(int i, double c) const {
    return 2 * modulus[i] * (time[i] / (time[i] + c));
  }
  /// What of the rate of branch i at the time of a state is the velocity, where the rate that a scheme keeps is that of a time `shift` before
  /// it, a' - shift a'': with tau a'' = u' - a' the rate is (tau kept + shift u') / (tau + shift), of second order for any tau.
  KOKKOS_FORCEINLINE_FUNCTION double share_of_velocity(int i, double shift) const { return shift / (time[i] + shift); }
  /// Sum of w_i: the stiffness of all branches against a step.
  double weight(double c) const {
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += weight(i, c);
    return sum;
  }
};

/// Gradient of what the displacement is ahead of those of the branches, with their weights or of one branch alone.
template <class N, int D, class M = Matrix<N, D>>
struct LagStrain {
  M gradient;

  static constexpr int slot_count = D;
  static constexpr Slot slot(int s) { return gradient_slot<M>(Field::lag, s); }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION LagStrain read(const Reader& at) {
    return {gradient_of<M, N, D>(at, 0)};
  }

  /// sym Grad q
  KOKKOS_FORCEINLINE_FUNCTION M strain() const { return 0.5 * (gradient + transpose(gradient)); }
};

/// (Grad w, dev sym Grad q). In 2D the strain along the third axis is 0, and dev takes a third of the trace there too.
/// Tested: tests/unit/solid/test_branches.cpp
struct BranchStress {
  static constexpr Where where = Where::solid;

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = LagStrain<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const LagStrain<N, D, M>& t) const {
    const M e = t.strain();
    MomentumTest<N, D, M> r;
    SOFTWET_UNROLL
    for (int i = 0; i < D; ++i) r.momentum[i] = N(0.0);
    r.momentum_flux = add_diagonal(e, (-1.0 / 3) * trace(e));
    return r;
  }
};

/// Integrand dev e : dev e of e = sym Grad q. Times G_i it is psi_i of q = u - a_i, and times 2 G_i tau_i what is dissipated, of q = a_i'.
/// Tested: tests/unit/solid/test_branches.cpp
struct ShearSquare {
  static constexpr Where where = Where::solid;
  static constexpr int count = 1;
  static constexpr const char* energy_column = "energy_branches";
  static constexpr const char* dissipation_column = "dissipation_solid";

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = LagStrain<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const LagStrain<N, D, M>& t) const {
    const M e = t.strain();
    const N tr = trace(e);
    return {{contract(e, e) - (1.0 / 3) * (tr * tr)}};
  }
};

}  // namespace softwet
