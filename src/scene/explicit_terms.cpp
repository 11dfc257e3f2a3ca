#include "scene/explicit_terms.hpp"

#include "scene/coordinates.hpp"

namespace softwet {

template <int D, int P>
template <class Motion, class Term>
void ExplicitTerms<D, P>::add(const Term& term, const Evaluation<D>& at) const {
  assemble<P, false, TermList<TermOnMesh<Term, Motion>>>(
      task_of<D, Term, Motion, double>(term, model_.fluid_region(), at, model_.blend()), at);
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
  if (model_.layout().has_fluid) add_fluid(MassFlux{}, {model_.layout(), stage, {}, out});
}

template <int D, int P>
void ExplicitTerms<D, P>::add_pressure(const Stage& stage, const Array& out) const {
  const Evaluation<D> at{model_.layout(), stage, {}, out};
  if (model_.layout().has_fluid) add_fluid(PressureForce{model_.fluid()}, at);
  model_.add_forces_of_solid(stage, out);
}

template <int D, int P>
void ExplicitTerms<D, P>::add_convection(const Stage& stage, bool viscous, const Array& out) const {
  const NavierStokesKorteweg& fluid = model_.fluid();
  if (model_.layout().has_fluid)
    add_fluid(ConvectionViscosity{viscous ? fluid.viscosity : 0.0, fluid.inertia_floor},
              {model_.layout(), stage, {}, out});
  if (viscous) model_.add_viscosity_of_solid(stage, out);
}

template <int D, int P>
void ExplicitTerms<D, P>::collect(const Array& out) const {
  move_ghosts(model_.layout(), out, GhostAction::add);
}

template class ExplicitTerms<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
