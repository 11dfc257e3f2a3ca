#include "solver/direct/device/level_scale.hpp"

namespace softwet {

namespace {

/// One over the largest entry of each row (or column); an entry of a column counts with the factor of its row. An item
/// is an unknown, which looks at its entries in the order of the offsets.
template <int D, bool Columns>
struct InvertLargest {
  using Factors = typename LevelScale<D>::Factors;
  Stencil<D> stencil;
  ComponentPlaces<D> places;
  StencilValues values;
  Kokkos::View<const std::int8_t*, Exec> component;
  Factors row, result;

  KOKKOS_FUNCTION void operator()(int i) const {
    const int c = component(i), point = c < 0 ? 0 : i - places.shift[c];
    float largest = 0;
    for (int o = 0; c >= 0 && o < stencil.offsets; ++o) {
      const int to = stencil.neighbour(point, Columns ? stencil.offsets - 1 - o : o);
      for (int u = 0; to >= 0 && u < stencil.components; ++u) {
        if (to < places.first[u] || !(Columns ? stencil.couples(u, c) : stencil.couples(c, u))) continue;
        const int other = places.shift[u] + to;
        if (component(other) < 0) continue;
        const float entry = values(Columns ? stencil.index(u, c, o, to) : stencil.index(c, u, o, point));
        const float size = Columns ? Kokkos::abs(entry) * row(other) : Kokkos::abs(entry);
        if (size > largest) largest = size;
      }
    }
    result(i) = largest > 0 ? 1 / largest : 1;
  }
};

}  // namespace

template <int D>
LevelScale<D>::LevelScale(const Layout<D>& layout, const UnknownTable<D>& table)
    : stencil_(layout),
      places_(layout),
      row_("lu.row_scale", layout.size()),
      column_("lu.column_scale", layout.size()) {
  std::vector<std::int8_t> component(layout.size());
  for (int i = 0; i < layout.size(); ++i) component[i] = static_cast<std::int8_t>(table.component(i));
  component_ = to_device<Kokkos::View<std::int8_t*, Exec>>(component, "lu.component");
}

template <int D>
void LevelScale<D>::compute(const StencilValues& values) const {
  const Items unknowns(0, static_cast<int>(row_.extent(0)));
  Kokkos::parallel_for("softwet::row_scale", unknowns,
                       InvertLargest<D, false>{stencil_, places_, values, component_, row_, row_});
  Kokkos::parallel_for("softwet::column_scale", unknowns,
                       InvertLargest<D, true>{stencil_, places_, values, component_, row_, column_});
}

template class LevelScale<2>;
template class LevelScale<3>;

}  // namespace softwet
