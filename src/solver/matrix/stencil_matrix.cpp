#include "solver/matrix/stencil_matrix.hpp"

#include <algorithm>

#include "memory/large_pages.hpp"
#include "solver/matrix/stencil_product.hpp"

namespace softwet {

template <int D>
UnknownTable<D>::UnknownTable(const Layout<D>& layout, const std::vector<double>& mask)
    : points_(layout.rows * layout.row_size), component_(mask.size(), -1), point_(mask.size(), -1) {
  unknown_.assign(static_cast<std::size_t>(layout.components()) * points_, -1);
  for (int c = 0; c < layout.components(); ++c)
    for (int p = layout.component_first(c); p < points_; ++p) {
      const int i = layout.component_shift(c) + p;
      if (mask[i] == 0) continue;
      unknown_[c * points_ + p] = i;
      component_[i] = c;
      point_[i] = p;
    }
}

template <int D>
StencilMatrix<D>::StencilMatrix(const Layout<D>& layout, const ConstArray& mask)
    : layout_(layout), stencil_(layout), mask_(mask) {
  const int n = stencil_.extent[0];
  stored_ = (n + stencil_pack - 1) / stencil_pack * stencil_pack + 2 * stencil_.degree;
  spread_ = StencilValues("stencil.x", std::int64_t(stencil_.components) * (stencil_.points / n) * stored_);
}

template <int D>
void StencilMatrix<D>::fill(const Jacobian& jacobian) {
  if (values_.extent(0) == 0) {
    values_ = large_array<StencilValues>("stencil", stencil_.size() + stencil_pack);  // a product reads beyond
    Kokkos::deep_copy(values_, 0.0f);
  }
  jacobian(Kokkos::subview(values_, Kokkos::make_pair(std::int64_t(0), stencil_.size())));
}

/// Some lines after the other, so that the memory for messages stays small.
template <int D>
void StencilMatrix<D>::update_copies() const {
  if (layout_.whole()) return;
  const std::int64_t lines = (std::int64_t(1) << 22) / layout_.axis[0].functions();  // the same for all processes
  const std::int64_t at_once = lines * layout_.columns.stored();
  for (std::int64_t first = 0; first < stencil_.size(); first += at_once) {
    const std::int64_t last = std::min(stencil_.size(), first + at_once);
    update_columns<float>(layout_.columns, *layout_.exchange, Kokkos::subview(values_, Kokkos::make_pair(first, last)));
  }
}

template <int D>
void StencilMatrix<D>::multiply(const ConstArray& x, const Array& y) const {
  const ComponentPlaces<D> places(layout_);
  const SpreadValues<D> spread{stencil_, x, mask_, spread_, places, stored_};
  Kokkos::parallel_for("softwet::spread", LongItems(0, spread_.extent(0)), spread);
  const MultiplyPieces<D> product{stencil_, values_, spread_, mask_, y, places, stored_};
  Kokkos::parallel_for("softwet::stencil_multiply", LongItems(0, product.items()), product);
}

template class UnknownTable<2>;
template class UnknownTable<3>;
template class StencilMatrix<2>;
template class StencilMatrix<3>;

}  // namespace softwet
