#include "scene/explicit_terms.hpp"

#include "field/ghosts.hpp"
#include "scene/coordinates.hpp"

namespace softwet {

template <int D, int P>
template <class Motion, class Term>
void ExplicitTerms<D, P>::add(const Term& term, const Evaluation<D>& at) const {
  assemble<P, false, TermList<TermOnMesh<Term, Motion>>>(
      task_of<D, Term, Motion, double>(term, regions_.fluid(), at, regions_.blend()), sums_);
}

template <int D, int P>
template <class Term>
void ExplicitTerms<D, P>::add_fluid(const Term& term, const Evaluation<D>& at) const {
  in_coordinates_of(at.layout, term, [&](const auto& here) {
    at.layout.has_solid ? add<WallMotion<D>>(here, at) : add<NoMotion>(here, at);
  });
}

template <int D, int P>
void ExplicitTerms<D, P>::add_mass_flux(const Stage& stage, const Array& out) const {
  if (regions_.layout().has_fluid) add_fluid(MassFlux{}, {regions_.layout(), stage, {}, out});
}

template <int D, int P>
void ExplicitTerms<D, P>::add_pressure(const Stage& stage, const Array& out, const double* force_numbers) const {
  const Evaluation<D> at{regions_.layout(), stage, {}, out};
  if (regions_.layout().has_fluid) add_fluid(PressureForce{coefficients_.fluid()}, at);
  equations_.add_forces_of_solid(stage, sums_, out, force_numbers);
}

template <int D, int P>
void ExplicitTerms<D, P>::add_convection(const Stage& stage, Viscosity viscosity, const Array& out) const {
  const NavierStokesKorteweg& fluid = coefficients_.fluid();
  if (regions_.layout().has_fluid)
    add_fluid(ConvectionViscosity{viscosity == Viscosity::among_all ? fluid.viscosity : 0.0, fluid.inertia_floor},
              {regions_.layout(), stage, {}, out});
  if (viscosity == Viscosity::among_all) add_viscosity_of_solid(stage, out);
}

template <int D, int P>
void ExplicitTerms<D, P>::add_potential(const Stage& stage, const Array& out) const {
  equations_.add_potential(stage, sums_, out);
}

template <int D, int P>
void ExplicitTerms<D, P>::add_viscosity_of_solid(const Stage& stage, const Array& out) const {
  equations_.add_viscosity_of_solid(stage, sums_, out);
}

template <int D, int P>
void ExplicitTerms<D, P>::collect(const Array& out) const {
  sums_.add_to(out);
  move_ghosts(regions_.layout(), out, GhostAction::add);
}

template <int D, int P>
TileSumsOf<D> ExplicitTerms<D, P>::taken(const Array& out) const {
  if constexpr (!host_algorithms)
    if (!has_ghosts(regions_.layout())) return sums_.taken();
  collect(out);
  return {};
}

template class ExplicitTerms<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
