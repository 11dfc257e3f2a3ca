#include "model/masses.hpp"

#include "field/vector.hpp"

namespace softwet {

template <int D, int P>
template <class Motion>
void Masses<D, P>::add_scalar(const Binding<D>& b, const Array& z) const {
  Task<D, ScalarMass, Motion> task{model_.fluid_region(), {}, {}, {}, {}, {}, {}};
  if constexpr (std::is_same_v<Motion, WallMotion<D>>) task.motion = b.motion(model_.blend());
  task.slot[0] = b.component(z, D);
  task.test[0] = b.component(b.test, D);
  assemble<P, P + 1, false>(task);
}

template <int D, int P>
template <class Motion>
void Masses<D, P>::add_fluid(const Binding<D>& b, double inertia, double viscosity, const Array& z) const {
  const WeightedViscosity term{inertia, viscosity, model_.fluid().inertia_floor};
  Task<D, WeightedViscosity, Motion> task{model_.fluid_region(), term, {}, {}, {}, {}, {}};
  if constexpr (std::is_same_v<Motion, WallMotion<D>>) task.motion = b.motion(model_.blend());
  task.slot[0] = b.density();
  for (int d = 0; d < D; ++d) {
    task.slot[1 + d] = b.component(z, d);
    task.test[d] = b.component(b.test, d);
  }
  assemble<P, P + 1, false>(task);
}

template <int D, int P>
void Masses<D, P>::add_solid(const Binding<D>& b, const Array& z) const {
  Task<D, SolidMass, NoMotion> task{model_.solid_region(), {model_.solid().density}, {}, {}, {}, {}, {}};
  for (int d = 0; d < D; ++d) {
    task.slot[d] = b.component(z, d);
    task.test[d] = b.component(b.test, d);
  }
  assemble<P, P + 1, false>(task);
}

template <int D, int P>
void Masses<D, P>::collect(const Array& out) const {
  move_ghosts(model_.layout(), out, GhostAction::add);
  multiply(out, model_.mask());
}

template <int D, int P>
void Masses<D, P>::scalar(const Stage& stage, const Array& z, const Array& out) const {
  const Layout<D>& l = model_.layout();
  Kokkos::deep_copy(Exec(), out, 0.0);
  move_ghosts(l, z, GhostAction::update);
  const Binding<D> b{l, stage, {}, out};
  l.has_solid ? add_scalar<WallMotion<D>>(b, z) : add_scalar<NoMotion>(b, z);
  collect(out);
}

template <int D, int P>
void Masses<D, P>::velocity(const Stage& stage, double inertia, double viscosity, const Array& z,
                            const Array& out) const {
  const Layout<D>& l = model_.layout();
  Kokkos::deep_copy(Exec(), out, 0.0);
  move_ghosts(l, z, GhostAction::update);
  const Binding<D> b{l, stage, {}, out};
  if (l.has_solid && inertia != 0) add_solid(b, z);
  if (l.has_fluid)
    l.has_solid ? add_fluid<WallMotion<D>>(b, inertia, viscosity, z) : add_fluid<NoMotion>(b, inertia, viscosity, z);
  collect(out);
}

template class Masses<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
