// The energy and the dissipation of a term as functionals. A functional names the column of history.csv to which each
// of its integrals belongs (src/scene/integrals.hpp).
#pragma once

#include "kernels/point/fields.hpp"

namespace softwet {

/// What the energy of a term reads: its trial, or less where the term has an `EnergyTrial`.
template <class Term, class N, int D>
struct EnergyTrialOf {
  using type = typename Term::template Trial<N, D>;
};
template <class Term, class N, int D>
  requires requires { typename Term::template EnergyTrial<N, D>; }
struct EnergyTrialOf<Term, N, D> {
  using type = typename Term::template EnergyTrial<N, D>;
};

/// Integrand: the energy of a term, whose residual is its derivative. The term names the column with `energy_column`.
template <class Term>
struct EnergyOf {
  static constexpr Where where = Term::where;
  static constexpr bool axisymmetric = is_axisymmetric<Term>;
  static constexpr int count = 1;
  static constexpr const char* column(int) { return Term::energy_column; }

  Term term;

  template <class N, int D>
  using Trial = typename EnergyTrialOf<Term, N, D>::type;

  template <class Seen>
  KOKKOS_FORCEINLINE_FUNCTION auto value(const Seen& t) const {
    return Vector<decltype(term.energy(t)), count>{{term.energy(t)}};
  }
};

/// Integrand: the power that a term dissipates. The term names the column with `dissipation_column`.
template <class Term>
struct DissipationOf {
  static constexpr Where where = Term::where;
  static constexpr bool axisymmetric = is_axisymmetric<Term>;
  static constexpr int count = 1;
  static constexpr const char* column(int) { return Term::dissipation_column; }

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
  Term::energy_column;
};
template <class Term>
concept HasDissipation = requires {
  Term::dissipation_column;
};

}  // namespace softwet
