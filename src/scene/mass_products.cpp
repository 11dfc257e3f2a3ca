#include "scene/mass_products.hpp"

#include "field/ghosts.hpp"
#include "field/vector.hpp"
#include "scene/coordinates.hpp"

namespace softwet {

template <int D, int P>
template <class Motion, class Term>
void Masses<D, P>::add(const Term& term, const Region<D>& region, const Evaluation<D>& at) const {
  assemble<P, false, TermList<TermOnMesh<Term, Motion>>>(
      task_of<D, Term, Motion, double>(term, region, at, regions_.blend()), at);
}

template <int D, int P>
template <class Term>
void Masses<D, P>::add_fluid(const Term& term, const Evaluation<D>& at) const {
  const Region<D>& region = regions_.fluid();
  in_coordinates_of(at.layout, term, [&](const auto& here) {
    at.layout.has_solid ? add<WallMotion<D>>(here, region, at) : add<NoMotion>(here, region, at);
  });
}

template <int D, int P>
void Masses<D, P>::collect(const Array& out) const {
  move_ghosts(regions_.layout(), out, GhostAction::add);
  multiply(out, regions_.mask());
}

template <int D, int P>
void Masses<D, P>::add_scalar(const Stage& stage, const Array& z, const Array& out) const {
  const Layout<D>& l = regions_.layout();
  Stage with_z = stage;
  with_z.unknown = z;
  add_fluid(DensityMoment{}, {l, with_z, {}, out});
  move_ghosts(l, out, GhostAction::add);
}

template <int D, int P>
void Masses<D, P>::scalar(const Stage& stage, const Array& z, const Array& out) const {
  const Layout<D>& l = regions_.layout();
  Kokkos::deep_copy(Exec(), out, 0.0);
  move_ghosts(l, z, GhostAction::update);
  add_scalar(stage, z, out);
  multiply(out, regions_.mask());
}

template <int D, int P>
void Masses<D, P>::velocity(const Stage& stage, double inertia, double viscosity, const Array& z,
                            const Array& out) const {
  const Layout<D>& l = regions_.layout();
  Kokkos::deep_copy(Exec(), out, 0.0);
  move_ghosts(l, z, GhostAction::update);
  const Evaluation<D> at{l, stage, {}, out, Geometry::exact, z};
  const double density = coefficients_.solid().density();
  if (l.has_solid && inertia != 0)
    in_coordinates_of(l, SolidMass{density}, [&](const auto& here) { add<NoMotion>(here, regions_.solid(), at); });
  if (l.has_fluid) add_fluid(WeightedViscosity{inertia, viscosity, coefficients_.fluid().inertia_floor}, at);
  collect(out);
}

template class Masses<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
