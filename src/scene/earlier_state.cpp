#include "scene/earlier_state.hpp"

#include <algorithm>

#include "spline/transfer.hpp"

namespace softwet {
namespace {

using TransferRows = std::vector<TransferRow>;

/// A component as a box [k][j][i], i fastest, with the functions of one axis exchanged.
std::vector<double> with_axis(const std::vector<double>& values, std::size_t stride, std::size_t extent,
                              const TransferRows& rows, int first_from) {
  const std::size_t outer = values.size() / (stride * extent);
  std::vector<double> result(outer * rows.size() * stride, 0.0);
  for (std::size_t o = 0; o < outer; ++o)
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t k = 0; k < rows[i].function.size(); ++k)
        for (std::size_t s = 0; s < stride; ++s)
          result[(o * rows.size() + i) * stride + s] +=
              rows[i].weight[k] * values[(o * extent + rows[i].function[k] - first_from) * stride + s];
  return result;
}

/// TransferRows of control points of the vertical axis that a component has, and the elements where it lives.
struct RowsOfPart {
  int first, rows, low, high;
};

enum class PatchPart { all, solid, fluid };

RowsOfPart rows_of_part(const Axis& vertical, int solid_elements, bool has_fluid, bool has_solid, PatchPart part) {
  const int rows = vertical.functions(), elements = vertical.elements();
  const int wall = !has_solid ? 0 : has_fluid ? vertical.span(solid_elements) : rows - 1;
  if (part == PatchPart::solid) return {0, wall + 1, 0, solid_elements};
  if (part == PatchPart::fluid) return {wall, rows - wall, has_solid ? solid_elements : 0, elements};
  return {0, rows, 0, elements};
}

/// A component of the earlier run on the whole patch of another mesh.
template <int D>
std::vector<double> on_patch(const EarlierState& from, const Layout<D>& to, PatchPart part,
                             std::vector<double> values) {
  const RowsOfPart old = rows_of_part(from.axis[D - 1], from.solid_elements, from.has_fluid, from.has_solid, part);
  const RowsOfPart now = rows_of_part(to.axis[D - 1], to.solid_elements, to.has_fluid, to.has_solid, part);
  std::size_t stride = 1;
  for (int d = 0; d < D; ++d) {
    const Axis &a = from.axis[d], &b = to.axis[d];
    const bool up = d == D - 1;
    TransferRows rows = projection(a, up ? old.low : 0, up ? old.high : a.elements(), b, up ? now.low : 0,
                                   up ? now.high : b.elements());
    if (up) rows = TransferRows(rows.begin() + now.first, rows.begin() + now.first + now.rows);
    values = with_axis(values, stride, up ? old.rows : a.functions(), rows, up ? old.first : 0);
    stride *= rows.size();
  }
  return values;
}

/// Copies the values of a component of the whole patch that this process stores.
template <int D>
void take_stored(const Layout<D>& l, const std::vector<double>& all, double* values) {
  const std::size_t width = l.axis[0].functions(), stored = l.extent(0), lines = all.size() / width;
  for (std::size_t line = 0; line < lines; ++line)
    for (std::size_t i = 0; i < stored; ++i)
      values[line * stored + i] = all[line * width + l.function(static_cast<int>(i), 0)];
}

}  // namespace

std::vector<double> control_values_of_samples(const std::vector<Axis>& axes, int low, int high,
                                              std::vector<double> samples) {
  std::size_t stride = 1;
  for (std::size_t d = 0; d < axes.size(); ++d) {
    const bool up = d + 1 == axes.size();
    const int first = up ? low : 0, last = up ? high : axes[d].elements();
    TransferRows rows = from_samples(axes[d], first, last);
    if (up) rows = {rows.begin() + axes[d].span(low), rows.begin() + axes[d].span(high - 1) + axes[d].degree() + 1};
    samples = with_axis(samples, stride, 2 * (last - first) + 1, rows, 0);
    stride *= rows.size();
  }
  return samples;
}

template <int D>
void give_earlier(const EarlierState& from, const Layout<D>& l, std::vector<double>& unknown,
                  std::vector<double>& displacement) {
  auto next = from.unknown.begin();
  const auto component = [&](auto& place, PatchPart part) {
    const RowsOfPart reach = rows_of_part(from.axis[D - 1], from.solid_elements, from.has_fluid, from.has_solid, part);
    std::size_t size = reach.rows;
    for (int d = 0; d + 1 < D; ++d) size *= from.axis[d].functions();
    const std::vector<double> values(place, place + size);
    place += size;
    return values;
  };
  for (int d = 0; d < D; ++d)
    take_stored(l, on_patch(from, l, PatchPart::all, component(next, PatchPart::all)), &unknown[l.velocity_offset(d)]);
  if (from.has_fluid && l.has_fluid) {
    const std::vector<double> density = component(next, PatchPart::fluid);
    std::vector<double> now = on_patch(from, l, PatchPart::fluid, density);
    const auto [least, most] = std::minmax_element(density.begin(), density.end());
    for (double& rho : now) rho = std::clamp(rho, *least, *most);
    take_stored(l, now, &unknown[l.density_offset()]);
    take_stored(l, on_patch(from, l, PatchPart::fluid, component(next, PatchPart::fluid)),
                &unknown[l.potential_offset()]);
  }
  auto moved = from.displacement.begin();
  for (int d = 0; d < D && from.has_solid && l.has_solid; ++d)
    take_stored(l, on_patch(from, l, PatchPart::solid, component(moved, PatchPart::solid)),
                &displacement[l.displacement_offset(d)]);
}

template void give_earlier(const EarlierState&, const Layout<2>&, std::vector<double>&, std::vector<double>&);
template void give_earlier(const EarlierState&, const Layout<3>&, std::vector<double>&, std::vector<double>&);

}  // namespace softwet
