// A solid that flows and fades: Maxwell branches parallel to its elasticity (generalised Maxwell).
#pragma once

#include "kernels/algebra/dual.hpp"
#include "kernels/algebra/symmetric.hpp"
#include "kernels/point/solid_fields.hpp"
#include "kernels/solid/isotropic.hpp"

namespace softwet {

/// Springs G_i that act in shear alone, each in series with a dashpot, so that its stress fades within the time tau_i:
///   psi_i = 1/2 (e - A_i) : C_i : (e - A_i),   C_i = 2 G_i dev,   tau_i A_i' = e - A_i
/// The dashpots dissipate tau_i A_i' : C_i : A_i'.
/// - Small strains: e = sym Grad u and A_i = sym Grad a_i of a displacement a_i of the dashpot, with tau_i a_i' = u -
///   a_i.
/// - Finite strains: e = E, the Green-Lagrange strain, and A_i is a symmetric tensor at each Gauss point. A rotation of
///   the deformed body changes neither E nor A_i.
/// A time scheme that finds e - A_i = tau_i / (tau_i + c) (e - h_i) at the end of a step, with h_i from its beginning
/// and a time c of its own, meets the stress W dev(e - h) with W = sum w_i and W h = sum w_i h_i, however many branches
/// there are.
/// Source: Simo, Hughes, Computational Inelasticity, chapter 10 (generalised relaxation).
/// Tested: tests/unit/solid/test_branches.cpp
struct Branches {
  static constexpr int most = 12;

  int count = 0;
  double modulus[most] = {};  ///< G_i, scale a b^2
  double time[most] = {};     ///< tau_i, scale L0/sqrt(ab)

  /// w_i = 2 G_i tau_i / (tau_i + c)
  KOKKOS_FORCEINLINE_FUNCTION double weight(int i, double c) const {
    return 2 * modulus[i] * (time[i] / (time[i] + c));
  }
  /// Share of the velocity in the rate of branch i at the time of a state. A scheme keeps the rate at a time `shift`
  /// before the state, a' - shift a''. With tau a'' = u' - a' the rate is (tau kept + shift u') / (tau + shift), of
  /// second order for any tau.
  KOKKOS_FORCEINLINE_FUNCTION double share_of_velocity(int i, double shift) const { return shift / (time[i] + shift); }
  /// Sum of w_i: the stiffness of all branches against a step.
  double weight(double c) const {
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += weight(i, c);
    return sum;
  }
};

/// Gradient of the displacement minus the displacements of the branches, with their weights or of one branch alone.
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
    return MomentumTest<N, D, M>::of_flux(add_diagonal(e, (-1.0 / 3) * trace(e)));
  }
};

/// Green-Lagrange strain of the solid, and what its points remember of it.
template <class N, int D, class M = Matrix<N, D>>
struct RememberedStrain {
  static constexpr int memory_size = symmetric_entries<M>;

  M displacement_gradient;
  Vector<N, memory_size> memory;  ///< entries of h, or of A_i of one branch
  bool remembers;                 ///< false in the matrices of preconditioners, which know no memory

  static constexpr int slot_count = D;
  static constexpr Slot slot(int s) { return gradient_slot<M>(Field::displacement, s); }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION RememberedStrain read(const Reader& at) {
    RememberedStrain t;
    t.displacement_gradient = gradient_of<M, N, D>(at, 0);
    t.remembers = at.remembers();
    SOFTWET_UNROLL
    for (int k = 0; k < memory_size; ++k) t.memory[k] = at.remembered(k);
    return t;
  }

  KOKKOS_FORCEINLINE_FUNCTION M remembered() const {
    return symmetric_of<M, D>([&](int k) { return memory[k]; });
  }
  /// E - h; where nothing is remembered the branches carry nothing, and it is 0 with the tangent of E.
  KOKKOS_FORCEINLINE_FUNCTION M strain() const {
    const M e = green_lagrange_strain(displacement_gradient);
    const auto all = entries_of(e);
    return e + (-1.0) * symmetric_of<M, D>([&](int k) { return remembers ? memory[k] : without_tangent(all[k]); });
  }
};

/// (Grad w, F dev(E - A)). In 2D the strain along the third axis is 0, and dev takes a third of the trace there too.
/// Tested: tests/unit/solid/test_branches.cpp
struct FiniteBranchStress {
  static constexpr Where where = Where::solid;

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = RememberedStrain<N, D, M>;
  template <class N, int D, class M = Matrix<N, D>>
  using Test = MomentumTest<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION MomentumTest<N, D, M> residual(const RememberedStrain<N, D, M>& t) const {
    const M e = t.strain(), s = add_diagonal(e, (-1.0 / 3) * trace(e));
    return MomentumTest<N, D, M>::of_flux(s + product(t.displacement_gradient, s));
  }
};

/// The entries of the Green-Lagrange strain, E, or of its rate, sym(F^T Grad v): what points may remember.
/// Tested: tests/unit/operator/test_at_points.cpp
struct StrainEntries {
  static constexpr Where where = Where::solid;

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = SolidStrain<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, symmetric_entries<M>> value(const SolidStrain<N, D, M>& t) const {
    return entries_of(green_lagrange_strain(t.displacement_gradient));
  }
};
struct StrainRateEntries {
  static constexpr Where where = Where::solid;

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = SolidStrainRate<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, symmetric_entries<M>> value(const SolidStrainRate<N, D, M>& t) const {
    return entries_of(green_lagrange_rate(t.displacement_gradient, t.velocity_gradient));
  }
};

/// dev e : dev e
template <class M>
KOKKOS_FORCEINLINE_FUNCTION auto shear_square(const M& e) {
  const auto tr = trace(e);
  return contract(e, e) - (1.0 / 3) * (tr * tr);
}

/// Integrand dev e : dev e of e = sym Grad q. Times G_i it is psi_i for q = u - a_i, and times 2 G_i tau_i it is the
/// dissipation for q = a_i'.
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
    return {{shear_square(t.strain())}};
  }
};

/// ShearSquare under finite strains, of the strains that points remember: e = E - A_i for the energy, e = A_i' for the
/// dissipation.
/// Tested: tests/unit/solid/test_branches.cpp
struct FiniteShearSquare {
  static constexpr Where where = Where::solid;
  static constexpr int count = 1;

  template <class N, int D, class M = Matrix<N, D>>
  using Trial = RememberedStrain<N, D, M>;

  template <class N, int D, class M>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const RememberedStrain<N, D, M>& t) const {
    return {{shear_square(t.remembered())}};
  }
};

}  // namespace softwet
