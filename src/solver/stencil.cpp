#include "solver/stencil.hpp"

#include <algorithm>

#include "field/array.hpp"

namespace softwet {

namespace {

template <int D>
struct Point {
  int index[D];
};

/// Rows of the patch on which a component's first row lies: components share control points by patch position.
template <int D>
int first_row(const Layout<D>& layout, std::size_t component) {
  return component < static_cast<std::size_t>(D) ? 0 : layout.wall_row;
}

/// Colours along an axis such that equal colours are more than 2 degree apart (cyclically on a periodic axis).
std::vector<int> axis_colours(const Axis& axis, int& colours) {
  const int width = 2 * axis.degree() + 1, n = axis.owned();
  std::vector<int> colour(axis.functions());
  const int regular = axis.periodic() ? n - n % width : n;
  for (int i = 0; i < n; ++i) colour[i] = i < regular ? i % width : width + i - regular;
  for (int i = n; i < axis.functions(); ++i) colour[i] = colour[i - n];
  colours = *std::max_element(colour.begin(), colour.end()) + 1;
  return colour;
}

}  // namespace

template <int D>
StencilMatrix<D>::StencilMatrix(const Layout<D>& layout, const ConstArray& mask) : mask_(to_host(mask)) {
  const std::vector<Box<D>> all = boxes(layout);
  std::vector<int> colour[D];
  int colours[D], total = 1;
  for (int d = 0; d < D; ++d) {
    colour[d] = axis_colours(layout.axis[d], colours[d]);
    total *= colours[d];
  }
  columns_of_colour_.resize(total * all.size());
  start_.push_back(0);
  for (std::size_t c = 0; c < all.size(); ++c) {
    int points = 1;
    for (int d = 0; d < D; ++d) points *= all[c].extent[d];
    for (int p = 0; p < points; ++p) {
      add_column(all, layout, c, p);
      const int index = all[c].offset + p, entries = static_cast<int>(row_.size()) - start_[index];
      int key = 0, rest = p;
      for (int d = 0, scale = 1; d < D; ++d) {
        const int i = rest % all[c].extent[d] + (d == D - 1 ? first_row(layout, c) : 0);
        rest /= all[c].extent[d];
        key += scale * colour[d][i];
        scale *= colours[d];
      }
      if (mask_[index] != 0) columns_of_colour_[c * total + key].push_back({index, start_[index], entries});
      start_.push_back(static_cast<int>(row_.size()));
    }
  }
  values_.assign(row_.size(), 0.0);
}

template <int D>
void StencilMatrix<D>::add_column(const std::vector<Box<D>>& all, const Layout<D>& layout, std::size_t component,
                                  int point) {
  const int index = all[component].offset + point;
  if (mask_[index] == 0) {
    row_.push_back(index);
    return;
  }
  int centre[D];
  for (int d = 0, rest = point; d < D; ++d) {
    centre[d] = rest % all[component].extent[d] + (d == D - 1 ? first_row(layout, component) : 0);
    rest /= all[component].extent[d];
  }
  std::vector<int> rows;
  for (std::size_t c = 0; c < all.size(); ++c) {
    const int width = 2 * layout.axis[0].degree() + 1;
    int neighbours = 1;
    for (int d = 0; d < D; ++d) neighbours *= width;
    for (int k = 0; k < neighbours; ++k) {
      int row = 0, stride = 1, rest = k;
      bool inside = true;
      for (int d = 0; d < D; ++d) {
        const Axis& axis = layout.axis[d];
        int i = centre[d] + rest % width - axis.degree();
        rest /= width;
        if (axis.periodic()) i = (i + axis.owned()) % axis.owned();
        i -= d == D - 1 ? first_row(layout, c) : 0;
        inside = inside && i >= 0 && i < all[c].extent[d];
        row += stride * i;
        stride *= all[c].extent[d];
      }
      if (inside && mask_[all[c].offset + row] != 0) rows.push_back(all[c].offset + row);
    }
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  row_.insert(row_.end(), rows.begin(), rows.end());
}

template <int D>
void StencilMatrix<D>::fill(const Product& product) {
  for (int i = 0; i < size(); ++i)
    if (mask_[i] == 0) values_[start_[i]] = 1.0;
  Array seed("stencil.seed", mask_.size()), out("stencil.out", mask_.size());
  auto host_seed = Kokkos::create_mirror_view(seed);
  auto host_out = Kokkos::create_mirror_view(out);
  for (const std::vector<Column>& columns : columns_of_colour_) {
    if (columns.empty()) continue;
    Kokkos::deep_copy(host_seed, 0.0);
    for (const Column& c : columns) host_seed(c.index) = 1.0;
    Kokkos::deep_copy(seed, host_seed);
    product(seed, out);
    Kokkos::deep_copy(host_out, out);
    for (const Column& c : columns)
      for (int e = c.first_entry; e < c.first_entry + c.entries; ++e) values_[e] = host_out(row_[e]);
  }
}

template class StencilMatrix<2>;
template class StencilMatrix<3>;

}  // namespace softwet
