#include "solver/stencil.hpp"

#include <algorithm>
#include <limits>

#include "app/error.hpp"
#include "solver/colours.hpp"

namespace softwet {

template <int D>
StencilMatrix<D>::StencilMatrix(const Layout<D>& layout, const ConstArray& mask)
    : mask_(to_host(mask)), seed_("stencil.seed", mask_.size()), product_("stencil.product", mask_.size()) {
  const Colours colours = make_colours(layout, mask_);
  columns_of_colour_.resize(colours.count);
  for (int i = 0; i < layout.size(); ++i) {
    start_.push_back(static_cast<int>(row_.size()));
    if (mask_[i] == 0) {
      row_.push_back(i);
      continue;
    }
    add_column(layout, &colours.point[3 * i]);
    if (row_.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      throw Error(
          Exit::invalid_input,
          "solver.krylov.preconditioner: a matrix of this mesh has more entries than \"lu\" and \"umfpack\" can "
          "number (2147483647); choose \"schwarz\" or take fewer elements");
    columns_of_colour_[colours.of[i]].push_back({i, start_[i], static_cast<int>(row_.size()) - start_[i]});
  }
  start_.push_back(static_cast<int>(row_.size()));
  values_.assign(row_.size(), 0.0);
}

template <int D>
void StencilMatrix<D>::add_column(const Layout<D>& layout, const int* centre) {
  const int width = 2 * layout.axis[0].degree() + 1;
  int neighbours = 1;
  for (int d = 0; d < D; ++d) neighbours *= width;
  std::vector<int> rows;
  const std::vector<Box<D>> all = boxes(layout);
  for (std::size_t c = 0; c < all.size(); ++c)
    for (int k = 0; k < neighbours; ++k) {
      int row = all[c].offset, stride = 1, rest = k;
      bool inside = true;
      for (int d = 0; d < D; ++d) {
        const Axis& axis = layout.axis[d];
        int i = centre[d] + rest % width - axis.degree();
        rest /= width;
        if (axis.periodic()) i = (i + axis.owned()) % axis.owned();
        if (d == D - 1 && c >= static_cast<std::size_t>(D)) i -= layout.wall_row;  // fluid components start there
        inside = inside && i >= 0 && i < all[c].extent[d];
        row += stride * i;
        stride *= all[c].extent[d];
      }
      if (inside && mask_[row] != 0) rows.push_back(row);
    }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  row_.insert(row_.end(), rows.begin(), rows.end());
}

template <int D>
void StencilMatrix<D>::fill(const Product& product) {
  for (int i = 0; i < size(); ++i)
    if (mask_[i] == 0) values_[start_[i]] = 1.0;
  const auto host_seed = Kokkos::create_mirror_view(seed_);
  const auto host_product = Kokkos::create_mirror_view(product_);
  for (const std::vector<Column>& columns : columns_of_colour_) {
    if (columns.empty()) continue;
    Kokkos::deep_copy(host_seed, 0.0);
    for (const Column& c : columns) host_seed(c.index) = 1.0;
    Kokkos::deep_copy(seed_, host_seed);
    product(seed_, product_);
    Kokkos::deep_copy(host_product, product_);
    for (const Column& c : columns)
      for (int e = c.first_entry; e < c.first_entry + c.entries; ++e) values_[e] = host_product(row_[e]);
  }
}

template class StencilMatrix<2>;
template class StencilMatrix<3>;

}  // namespace softwet
