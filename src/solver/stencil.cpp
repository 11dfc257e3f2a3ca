#include "solver/stencil.hpp"

#include <algorithm>

#include "solver/large_pages.hpp"
#include "solver/stencil_product.hpp"

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

namespace {

/// Rounds the values to 16 bits.
struct NarrowValues {
  StencilValues values;
  Kokkos::View<std::uint16_t*, Exec> out;
  KOKKOS_FUNCTION void operator()(std::int64_t i) const { out(i) = narrow(values(i)); }
};

}  // namespace

template <int D>
StencilMatrix<D>::StencilMatrix(const Layout<D>& layout, const ConstArray& mask, Products products)
    : layout_(layout), stencil_(layout), mask_(mask), products_(products) {
  bool periodic = false;
  int stride = 1, farthest = 0;
  for (int d = 0; d < D; ++d) {
    periodic = periodic || layout.axis[d].periodic();
    farthest += stride * stencil_.degree;
    stride *= stencil_.extent[d];
  }
  lines_.length = periodic ? stencil_.extent[0] : stencil_.points;
  lines_.margin = periodic ? stencil_.degree : farthest;
  lines_.stored = (lines_.length + pack - 1) / pack * pack + 2 * lines_.margin;
  spread_ =
      StencilValues("stencil.x", std::int64_t(stencil_.components) * (stencil_.points / lines_.length) * lines_.stored);
}

template <int D>
void StencilMatrix<D>::fill(const Jacobian& jacobian) {
  using Policy = Kokkos::RangePolicy<Exec, Kokkos::IndexType<std::int64_t>>;
  const auto all = Kokkos::make_pair(std::int64_t(0), stencil_.size());
  if (values_.extent(0) == 0) {
    values_ = large_array<StencilValues>("stencil", stencil_.size() + pack);  // a product reads beyond
    Kokkos::deep_copy(values_, 0.0f);
  }
  jacobian(Kokkos::subview(values_, all));
  if (products_ == Products::single) return;
  if (narrow_.extent(0) == 0) {
    narrow_ = large_array<Kokkos::View<std::uint16_t*, Exec>>("stencil.narrow", values_.extent(0));
    Kokkos::deep_copy(narrow_, std::uint16_t(0));
  }
  Kokkos::parallel_for("softwet::narrow", Policy(0, stencil_.size()), NarrowValues{values_, narrow_});
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
template <class Vector>
void StencilMatrix<D>::multiply_into(const ConstArray& r, const Vector& x, const Array& y) const {
  using Policy = Kokkos::RangePolicy<Exec, Kokkos::IndexType<std::int64_t>>;
  const ComponentPlaces<D> places(layout_);
  const SpreadValues<D, Vector> spread{stencil_, x, mask_, spread_, places, lines_};
  Kokkos::parallel_for("softwet::spread", Policy(0, spread_.extent(0)), spread);
  const auto run = [&](const auto& product) {
    Kokkos::parallel_for("softwet::stencil_multiply", Policy(0, product.items()), product);
  };
  const auto with = [&](const auto& values) {
    using Value = typename std::decay_t<decltype(values)>::non_const_value_type;
    if (lines_.length == stencil_.points) {
      run(MultiplyLongPieces<D, Value>{stencil_, values, spread_, mask_, r, y, places, lines_});
    } else {
      run(MultiplyPieces<D, Value>{stencil_, values, spread_, mask_, r, y, places, lines_});
    }
  };
  products_ == Products::single ? with(values_) : with(narrow_);
}

template <int D>
void StencilMatrix<D>::multiply(const ConstArray& x, const Array& y) const {
  multiply_into({}, x, y);
}
template <int D>
void StencilMatrix<D>::residual(const ConstArray& r, const ConstArray& x, const Array& y) const {
  multiply_into(r, x, y);
}
template <int D>
void StencilMatrix<D>::residual(const ConstArray& r, const SumAllAxes<D, double>& x, const Array& y) const {
  multiply_into(r, x, y);
}

template class UnknownTable<2>;
template class UnknownTable<3>;
template class StencilMatrix<2>;
template class StencilMatrix<3>;

}  // namespace softwet
