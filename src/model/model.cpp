#include "model/model.hpp"

#include "case/error.hpp"
#include "case/gel.hpp"
#include "field/exchange.hpp"
#include "field/ranks.hpp"
#include "field/vector.hpp"
#include "model/patch_axes.hpp"

namespace softwet {
namespace {

/// This process's columns of an axis, with those beside them that the boxes of `schwarz` reach where it may be chosen.
Columns own_columns(const Axis& axis, const Case& c) {
  const bool boxes = c.dimension() == 3 || c.solver.preconditioner == PreconditionerKind::schwarz;
  const int count = ranks::count(), most = most_ranks(axis);
  if (count > most)
    throw Error(Exit::invalid_input, std::to_string(count) + " processes: this scene has " + std::to_string(most) +
                                         " strips of " + std::to_string(strip_width) +
                                         " elements along x, and a process needs one; start " + std::to_string(most) +
                                         " or fewer");
  return cut_columns(axis, ranks::mine(), count, boxes ? box_width(c.dimension()) - 1 : 0);
}

/// out -= force weight, by control point of the solid.
template <int D>
struct SubtractForce {
  Array out;
  ConstArray weight;
  double minus[D];
  int apart;  ///< from one velocity to the next
  KOKKOS_FUNCTION void operator()(int i) const {
    for (int d = 0; d < D; ++d) out(d * apart + i) += minus[d] * weight(i);
  }
};
template <int D>
void subtract_force(const Layout<D>& l, const std::vector<double>& force, const ConstArray& weight, const Array& out) {
  SubtractForce<D> subtract{out, weight, {}, l.rows * l.row_size};
  bool any = false;
  for (int d = 0; d < D; ++d) {
    subtract.minus[d] = -force[d];
    any = any || force[d] != 0;
  }
  if (any) Kokkos::parallel_for("softwet::subtract_force", Items(0, weight.extent(0)), subtract);
}

}  // namespace

template <int D, int P>
Model<D, P>::Model(const Case& c) : precision_(precision_of(c)), points_(c.domain.points()) {
  if (!has_reduced_quadrature && points_ <= P)
    throw Error(
        Exit::invalid_input,
        "domain.quadrature = \"reduced\": this program was built without it; write domain.quadrature = \"full\", or "
        "build it with -DSOFTWET_REDUCED_QUADRATURE=ON");
  build_axes(c);
  if (layout_.has_solid) build_solid(c);
  if (layout_.has_fluid) build_fluid(c);
  build_mask(c);
  pieces_ = pieces_of<double>(c);
  single_ = pieces_of<float>(c);
}

template <int D, int P>
template <class Real>
Pieces<D, Real> Model<D, P>::pieces_of(const Case& c) const {
  if constexpr (D == 2)
    if (layout_.axisymmetric) return make_axisymmetric_pieces<D, P, Real>(*this, c);
  return make_pieces<D, P, Real>(*this, c);
}

template <int D, int P>
void Model<D, P>::build_axes(const Case& c) {
  layout_.has_fluid = c.fluid.has_value();
  layout_.has_solid = c.substrate.has_value();
  layout_.axisymmetric = c.axisymmetric();
  layout_.solid_elements = solid_elements(c);
  layout_.row_size = 1;
  for (int d = 0; d < D; ++d) {
    layout_.axis.push_back(axis_of(c, d, P));
    if (d == 0) layout_.columns = own_columns(layout_.axis[0], c);
    if (d < D - 1) layout_.row_size *= layout_.extent(d);
  }
  if (!layout_.whole()) layout_.exchange = plan_exchange(layout_.axis[0], layout_.columns);
  const Axis& vertical = layout_.axis[D - 1];
  layout_.rows = vertical.functions();
  if (layout_.has_solid)
    layout_.wall_row = layout_.has_fluid ? vertical.span(layout_.solid_elements) : layout_.rows - 1;
  if (c.fluid && c.fluid->resists_lines() && c.boundary.side[D - 1][0] != Side::periodic) layout_.rate_rows = P + 1;
  if (c.substrate) layout_.branches = static_cast<int>(all_branches(*c.substrate).size());
  blend_.low = vertical.lower(layout_.solid_elements);
  blend_.height = vertical.length() - blend_.low;
  if (layout_.has_solid) solid_region_ = region(Where::solid, points_);
  if (!layout_.has_fluid) return;
  fluid_region_ = region(Where::fluid, points_);
  wall_region_ = region(Where::wall, points_);
}

template <int D, int P>
Region<D> Model<D, P>::region(Where where, int points) const {
  const int wall = layout_.solid_elements, all = layout_.axis[D - 1].elements();
  if (where == Where::solid) return region(0, wall, points);
  if (where == Where::means) return region(0, wall, points, mean_rules);
  if (where == Where::top) {
    Region<D> r = region(wall - 1, wall, points);
    r.axis[D - 1] = r.test = high_face_rule(layout_.axis[D - 1], wall - 1);
    return r;
  }
  if (where == Where::bottom) {
    Region<D> r = region(0, 1, points);
    r.axis[D - 1] = r.test = low_face_rule(layout_.axis[D - 1], 0);
    return r;
  }
  Region<D> r = region(wall, where == Where::beside_wall ? wall + 1 : all, points);
  if (where == Where::beside_wall) r.test = restricted_to(r.test, 0);
  if (where == Where::wall) r.axis[D - 1] = r.test = low_face_rule(layout_.axis[D - 1], wall);
  return r;
}

template <int D, int P>
std::vector<Region<D>> Model<D, P>::regions(Where where, int points) const {
  const int joint = layout_.axis[D - 1].joint();
  const int wall = layout_.solid_elements;
  if (joint > 0 && where == Where::solid) return {region(0, joint, points), region(joint, wall, points)};
  if (joint > 0 && where == Where::means)
    return {region(0, joint, points, mean_rules), region(joint, wall, points, mean_rules)};
  return {region(where, points)};
}

template <int D, int P>
Region<D> Model<D, P>::region(int first, int last, int points, const RuleMakers& rule) const {
  Region<D> r;
  int stride = 1;
  for (int d = 0; d < D; ++d) {
    const Axis& axis = layout_.axis[d];
    const int low = d < D - 1 ? 0 : first, high = d < D - 1 ? axis.elements() : last;
    r.axis[d] = d == 0 ? rule.of_columns(axis, layout_.columns.elements, points) : rule.of(axis, low, high, points);
    r.stride[d] = stride;
    stride *= layout_.extent(d);
  }
  r.columns = layout_.columns.elements;
  r.test = r.axis[D - 1];
  return r;
}

template <int D, int P>
void Model<D, P>::build_mask(const Case& c) {
  std::vector<double> mask(layout_.size(), 1.0);
  const std::vector<Box<D>> all = boxes(layout_);
  for (std::size_t k = 0; k < all.size(); ++k) {
    int n = 1;
    for (int d = 0; d < D; ++d) n *= all[k].extent[d];
    for (int i = 0; i < n; ++i) {
      int rest = i;
      for (int d = 0; d < D; ++d) {
        const int place = rest % all[k].extent[d], index = layout_.function(place, d);
        rest /= all[k].extent[d];
        const Axis& axis = layout_.axis[d];
        if (!layout_.own(place, d) || (axis.periodic() && index >= axis.owned())) mask[all[k].offset + i] = 0;
        if (k >= D) continue;  // density and potential have no prescribed values
        for (int end = 0; end < 2; ++end) {
          const Side side = c.boundary.side[d][end];
          const bool here = index == (end == 0 ? 0 : (d == D - 1 ? all[k].extent[d] : axis.functions()) - 1);
          if (here && holds(side, static_cast<int>(k) == d)) mask[all[k].offset + i] = 0;
        }
      }
    }
  }
  mask_ = to_device<Array>(mask, "mask");
}

template <int D, int P>
void Model<D, P>::add_loads(double time, const Array& out) const {
  for (const LoadVector<D>& load : loads_) {
    const std::vector<double> force = load.force(time);
    subtract_force(layout_, force, load.weight(layout_, time), out);
  }
  if (!gravity_.force.empty()) subtract_force(layout_, gravity_.force, gravity_.weight, out);
}

template <int D, int P>
template <class Real>
void Model<D, P>::finish_residual(const StageOf<Real>& stage, const Array& out) const {
  add_loads(stage.time, out);
  needles_.add_to_residual(layout_, stage.time, stage.displacement, out);
  if (source_) source_(stage.time, out);
  move_ghosts(layout_, out, GhostAction::add);
  multiply(out, mask_);
}

template <int D, int P>
void Model<D, P>::add_forces_of_solid(const Stage& stage, TileSums<D, double>& sums, const Array& out) const {
  Evaluation<D> at{layout_, stage, {}, out};
  at.sums = &sums;
  for (std::size_t i = 0; i < pieces_.first_viscous; ++i) pieces_.list[i].piece->residual(at);
  for (std::size_t i : pieces_.on_wall) {
    const auto& entry = pieces_.list[i];
    (entry.exact ? entry.exact : entry.piece)->residual(at);
  }
  add_loads(stage.time, out);
  needles_.add_to_residual(layout_, stage.time, stage.displacement, out);
  if (source_) source_(stage.time, out);
}

template <int D, int P>
void Model<D, P>::add_viscosity_of_solid(const Stage& stage, TileSums<D, double>& sums, const Array& out) const {
  Evaluation<D> at{layout_, stage, {}, out};
  at.sums = &sums;
  for (std::size_t i = pieces_.first_viscous; i < pieces_.first_of_fluid; ++i) pieces_.list[i].piece->residual(at);
}

template <int D, int P>
void Model<D, P>::residual(const Stage& stage, const Array& out) const {
  pieces_.run({layout_, stage, {}, out});
  finish_residual(stage, out);
}

template <int D, int P>
void Model<D, P>::residual(const StageOf<float>& stage, const ArrayOf<float>& work, const Array& out) const {
  single_.run({layout_, stage, {}, work});
  convert(out, work);
  finish_residual(stage, out);
}

template <int D, int P>
void Model<D, P>::add_potential(const Stage& stage, TileSums<D, double>& sums, const Array& out) const {
  Evaluation<D> at{layout_, stage, {}, out};
  at.sums = &sums;
  pieces_.variational_derivative->residual(at);
  if (pieces_.wall_law) pieces_.wall_law->residual(at);
  if (source_) source_(stage.time, out);
}

template <int D, int P>
void Model<D, P>::fluid_residual(const Stage& stage, const Array& out) const {
  const Evaluation<D> at{layout_, stage, {}, out};
  pieces_.run(at, pieces_.first_of_fluid);
  if (pieces_.rigid_traction) pieces_.rigid_traction->residual(at);
  move_ghosts(layout_, out, GhostAction::add);
}

template <int D, int P>
template <class Real>
void Model<D, P>::run_product(const Pieces<D, Real>& pieces, const StageOf<Real>& stage, const ArrayOf<Real>& direction,
                              const ArrayOf<Real>& out, Geometry geometry, const ConstArrayOf<Real>& unbalanced) const {
  const Evaluation<D, Real> at{layout_, stage, direction, out, geometry, unbalanced};
  const auto further = [&] {
    if (unbalanced.data()) pieces.friction_bend->product(at);
    needles_.add_to_product(layout_, stage.displacement_scale, direction, out);
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
void Model<D, P>::product(const Stage& stage, const Array& direction, const Array& out, Geometry geometry,
                          const ConstArray& unbalanced) const {
  run_product(pieces_, stage, direction, out, geometry, unbalanced);
}

template <int D, int P>
void Model<D, P>::product(const StageOf<float>& stage, const ArrayOf<float>& direction, const ArrayOf<float>& out,
                          Geometry geometry, const ConstArrayOf<float>& unbalanced) const {
  run_product(single_, stage, direction, out, geometry, unbalanced);
}

template <int D, int P>
void Model<D, P>::jacobian(const StageOf<float>& stage, const StencilValues& values) const {
  Kokkos::deep_copy(Exec(), values, 0.0f);
  const Stencil<D> stencil(layout_);
  for (const auto& entry : single_.list)
    entry.piece->jacobian({layout_, stage, {}, stage.unknown, Geometry::frozen}, stencil, values);
  needles_.add_to_matrix(stage.displacement_scale, stencil, values);
  fold_ghosts(layout_, stencil, values);
}

template class Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
