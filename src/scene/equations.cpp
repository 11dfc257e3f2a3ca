#include "scene/equations.hpp"

#include "field/vector.hpp"

namespace softwet {
template <int D, int P>
Equations<D, P>::Equations(const Regions<D>& regions, const Forces<D>& forces, const Terms<D, P>& terms,
                           Precision precision)
    : layout_(regions.layout()),
      mask_(regions.mask()),
      forces_(forces),
      pieces_(terms.pieces()),
      single_(terms.single_pieces()),
      precision_(precision) {}

template <int D, int P>
void Equations<D, P>::finish_residual(const Stage& stage, const Array& out) const {
  forces_.add_to_residual(stage.time, stage.displacement, out);
  if (source_) source_(stage.time, out);
  move_ghosts(layout_, out, GhostAction::add);
  multiply(out, mask_);
}

template <int D, int P>
void Equations<D, P>::add_forces_of_solid(const Stage& stage, TileSums<D, double>& sums, const Array& out,
                                          const double* force_numbers) const {
  Evaluation<D> at{layout_, stage, {}, out};
  at.sums = &sums;
  for (std::size_t i = 0; i < pieces_.first_viscous; ++i) pieces_.list[i].piece->residual(at);
  for (std::size_t i : pieces_.on_wall) {
    const auto& entry = pieces_.list[i];
    (entry.exact ? entry.exact : entry.piece)->residual(at);
  }
  forces_.add_to_residual(stage.time, stage.displacement, out, force_numbers);
  if (source_) source_(stage.time, out);
}

template <int D, int P>
void Equations<D, P>::add_viscosity_of_solid(const Stage& stage, TileSums<D, double>& sums, const Array& out) const {
  Evaluation<D> at{layout_, stage, {}, out};
  at.sums = &sums;
  for (std::size_t i = pieces_.first_viscous; i < pieces_.first_of_fluid; ++i) pieces_.list[i].piece->residual(at);
}

template <int D, int P>
void Equations<D, P>::residual(const Stage& stage, const Array& out) const {
  pieces_.run({layout_, stage, {}, out});
  finish_residual(stage, out);
}

template <int D, int P>
void Equations<D, P>::add_potential(const Stage& stage, TileSums<D, double>& sums, const Array& out) const {
  Evaluation<D> at{layout_, stage, {}, out};
  at.sums = &sums;
  pieces_.variational_derivative->residual(at);
  if (pieces_.wall_law) pieces_.wall_law->residual(at);
  if (source_) source_(stage.time, out);
}

template <int D, int P>
void Equations<D, P>::fluid_residual(const Stage& stage, const Array& out) const {
  const Evaluation<D> at{layout_, stage, {}, out};
  pieces_.run(at, pieces_.first_of_fluid);
  if (pieces_.rigid_traction) pieces_.rigid_traction->residual(at);
  move_ghosts(layout_, out, GhostAction::add);
}

template <int D, int P>
template <class Real>
void Equations<D, P>::run_product(const Pieces<D, Real>& pieces, const StageOf<Real>& stage,
                                  const ArrayOf<Real>& direction, const ArrayOf<Real>& out, Geometry geometry,
                                  const ConstArrayOf<Real>& unbalanced) const {
  const Evaluation<D, Real> at{layout_, stage, direction, out, geometry, unbalanced};
  const auto further = [&] {
    if (unbalanced.data()) pieces.friction_bend->product(at);
    forces_.needles().add_to_product(layout_, stage.displacement_scale, direction, out);
  };
  if (!has_ghosts(layout_)) {
    pieces.run(at, 0, mask_);
    return further();
  }
  move_ghosts(layout_, direction, GhostAction::update);
  pieces.run(at);
  further();
  move_ghosts(layout_, out, GhostAction::add);
  multiply(out, mask_);
  multiply(direction, mask_);
}

template <int D, int P>
void Equations<D, P>::product(const Stage& stage, const Array& direction, const Array& out, Geometry geometry,
                              const ConstArray& unbalanced) const {
  run_product(pieces_, stage, direction, out, geometry, unbalanced);
}

template <int D, int P>
void Equations<D, P>::product(const StageOf<float>& stage, const ArrayOf<float>& direction, const ArrayOf<float>& out,
                              Geometry geometry, const ConstArrayOf<float>& unbalanced) const {
  run_product(single_, stage, direction, out, geometry, unbalanced);
}

template <int D, int P>
void Equations<D, P>::jacobian(const StageOf<float>& stage, const StencilValues& values) const {
  Kokkos::deep_copy(Exec(), values, 0.0f);
  const Stencil<D> stencil(layout_);
  for (const auto& entry : single_.list)
    entry.piece->jacobian({layout_, stage, {}, stage.unknown, Geometry::frozen}, stencil, values);
  forces_.needles().add_to_matrix(stage.displacement_scale, stencil, values);
  fold_ghosts(layout_, stencil, values);
}

template class Equations<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
