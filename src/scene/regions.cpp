#include "scene/regions.hpp"

#include <algorithm>
#include <climits>
#include <string>

#include "case/error.hpp"
#include "case/gel.hpp"
#include "case/mesh.hpp"
#include "field/exchange.hpp"
#include "field/ghosts.hpp"
#include "field/ranks.hpp"
#include "field/vector.hpp"
#include "operator/task.hpp"
#include "scene/patch_axes.hpp"

namespace softwet {
namespace {

/// This process's columns of an axis, with the neighbouring columns that the boxes of `schwarz` reach where it may be
/// chosen.
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

/// What branches remember: a displacement under small strains, a strain at each point under finite ones.
template <int D>
void set_branches(Layout<D>& l, const Substrate& s, int points) {
  l.branches = static_cast<int>(all_branches(s).size());
  if (l.branches == 0) return;
  l.branches_at_points = s.strain != Strain::small;
  const int rows = D == 3 ? l.axis[1].elements() : 1, entries = l.axisymmetric() ? 4 : D * (D + 1) / 2;
  const double of_points = static_cast<double>(l.solid_elements) * rows * entries * power(points, D);
  const double lines = l.branches_at_points ? of_points : l.solid_size() / l.extent(0);
  if (const double all = l.branches * lines * l.extent(0); all > INT_MAX)
    throw Error(Exit::invalid_input, "substrate.branch: the branches of this solid remember " + std::to_string(all) +
                                         " numbers, and at most " + std::to_string(INT_MAX) +
                                         " can be; write fewer branches, fewer domain.elements, or strain = \"small\"");
  l.branch_lines = static_cast<int>(lines);
}

}  // namespace

template <int D>
Regions<D>::Regions(const Case& c) : points_(c.domain.points()) {
  if (!has_reduced_quadrature && points_ <= c.domain.degree)
    throw Error(Exit::invalid_input,
                "domain.quadrature = \"reduced\": this program was built without it; write domain.quadrature = "
                "\"full\", or build it with -DSOFTWET_REDUCED_QUADRATURE=ON");
  build_axes(c);
  build_mask(c);
}

template <int D>
void Regions<D>::build_axes(const Case& c) {
  const int degree = c.domain.degree;
  layout_.has_fluid = c.fluid.has_value();
  layout_.has_solid = c.substrate.has_value();
  layout_.solid_elements = solid_elements(c);
  layout_.row_size = 1;
  for (int d = 0; d < D; ++d) {
    layout_.axis.push_back(axis_of(c, d, degree));
    if (d == 0) layout_.columns = own_columns(layout_.axis[0], c);
    if (d < D - 1) layout_.row_size *= layout_.extent(d);
  }
  if (!layout_.whole()) layout_.exchange = plan_exchange(layout_.axis[0], layout_.columns);
  const Axis& vertical = layout_.axis[D - 1];
  layout_.rows = vertical.functions();
  if (layout_.has_solid)
    layout_.wall_row = layout_.has_fluid ? vertical.span(layout_.solid_elements) : layout_.rows - 1;
  has_wall_ = layout_.has_fluid && c.boundary.side[D - 1][0] != Side::periodic;
  if (has_wall_ && c.fluid->resists_lines()) layout_.rate_rows = degree + 1;
  if (c.substrate) set_branches(layout_, *c.substrate, points_);
  blend_.low = vertical.lower(layout_.solid_elements);
  blend_.height = vertical.length() - blend_.low;
  if (layout_.has_solid) solid_ = of(Where::solid, points_);
  if (!layout_.has_fluid) return;
  fluid_ = of(Where::fluid, points_);
  wall_ = of(Where::wall, points_);
}

template <int D>
Region<D> Regions<D>::of(Where where, int points) const {
  const int wall = layout_.solid_elements, all = layout_.axis[D - 1].elements();
  if (where == Where::solid) return rows(0, wall, points);
  if (where == Where::means) return means_of_rows(0, wall, points);
  if (where == Where::top) {
    Region<D> r = rows(wall - 1, wall, points);
    r.axis[D - 1] = r.test = high_face_rule(layout_.axis[D - 1], wall - 1);
    return r;
  }
  if (where == Where::bottom) {
    Region<D> r = rows(0, 1, points);
    r.axis[D - 1] = r.test = low_face_rule(layout_.axis[D - 1], 0);
    return r;
  }
  Region<D> r = rows(wall, where == Where::beside_wall ? wall + 1 : all, points);
  if (where == Where::beside_wall) r.test = restricted_to(r.test, 0);
  if (where == Where::wall) r.axis[D - 1] = r.test = low_face_rule(layout_.axis[D - 1], wall);
  return r;
}

template <int D>
std::vector<Region<D>> Regions<D>::parts_of(Where where, int points) const {
  const int joint = layout_.axis[D - 1].joint();
  const int wall = layout_.solid_elements;
  if (joint > 0 && where == Where::solid) return {rows(0, joint, points), rows(joint, wall, points)};
  if (joint > 0 && where == Where::means) return {means_of_rows(0, joint, points), means_of_rows(joint, wall, points)};
  return {of(where, points)};
}

template <int D>
template <class Along>
Region<D> Regions<D>::rows_of(int first, int last, const Along& rule) const {
  Region<D> r;
  int stride = 1;
  for (int d = 0; d < D; ++d) {
    const int low = d < D - 1 ? 0 : first, high = d < D - 1 ? layout_.axis[d].elements() : last;
    r.axis[d] = rule(d, low, high);
    r.stride[d] = stride;
    stride *= layout_.extent(d);
  }
  r.columns = layout_.columns.elements;
  r.test = r.axis[D - 1];
  return r;
}

template <int D>
Region<D> Regions<D>::rows(int first, int last, int points) const {
  return rows_of(first, last, [&](int d, int low, int high) {
    const Axis& axis = layout_.axis[d];
    return d == 0 ? gauss_rule(axis, layout_.columns.elements, points) : gauss_rule(axis, low, high, points);
  });
}

template <int D>
Region<D> Regions<D>::means_of_rows(int first, int last, int points) const {
  const MeanWeight weight = layout_.axisymmetric() ? MeanWeight::radius : MeanWeight::uniform;
  return rows_of(first, last, [&](int d, int low, int high) {
    const Axis& axis = layout_.axis[d];
    return d == 0 ? mean_rule(axis, layout_.columns.elements, points, weight) : mean_rule(axis, low, high, points);
  });
}

template <int D>
void Regions<D>::build_mask(const Case& c) {
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
          if (here && holds(side, static_cast<int>(k), d)) mask[all[k].offset + i] = 0;
        }
      }
    }
  }
  mask_ = to_device<Array>(mask, "mask");
}

template class Regions<2>;
template class Regions<3>;

}  // namespace softwet
