// The energy and the dissipation of a term as functionals.
#pragma once

#include "kernels/point/fields.hpp"

namespace softwet {

/// Integrand: the energy of a term, whose residual is its derivative. The term names the column with `energy_part`, and what the
/// energy reads with `EnergyTrial`.
template <class Term>
struct EnergyOf {
  static constexpr Where where = Term::where;
  static constexpr bool axisymmetric = is_axisymmetric<Term>;
  static constexpr int count = 1;

  Term term;

  template <class N, int D>
  using Trial = typename Term::template EnergyTrial<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const Trial<N, D>& t) const {
    return {{term.energy(t)}};
  }
};

/// Integrand: the power that a term dissipates.
template <class Term>
struct DissipationOf {
  static constexpr Where where = Term::where;
  static constexpr bool axisymmetric = is_axisymmetric<Term>;
  static constexpr int count = 1;

  Term term;

  template <class N, int D>
  using Trial = typename Term::template Trial<N, D>;

  template <class N, int D>
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, count> value(const Trial<N, D>& t) const {
    return {{term.dissipation(t)}};
  }
};

template <class Term>
concept HasEnergy = requires {
  Term::energy_part;
};
template <class Term>
concept HasDissipation = requires {
  Term::dissipates;
};

}  // namespace softwet
