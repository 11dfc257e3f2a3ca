// Newton's method where contact lines have friction: what its products read beside the stage.
#pragma once

#include <optional>

#include "field/ghosts.hpp"
#include "field/stage.hpp"
#include "solver/krylov/kronecker_mass.hpp"

namespace softwet {

/// to(k row_size + i) = weight(k) from(i)
struct SpreadOverRows {
  Array to;
  ConstArray from, weight;
  int row_size;
  KOKKOS_FUNCTION void operator()(int i) const { to(i) = weight(i / row_size) * from(i % row_size); }
};

/// The residual of the potential at the wall for each area, f = M^{-1} R with the mass M of the functions on the
/// undeformed wall: what LineFrictionBend reads. The inverse of the mass of the fluid is at hand. It makes f on the
/// wall, and 0 above, of R times the masses of the wall's function along the vertical.
template <int D>
class LineFrictionNewton {
 public:
  LineFrictionNewton(const Layout<D>& layout, int points, const ConstArray& mask) : layout_(layout) {
    if (layout.rate_rows == 0) return;
    mass_.emplace(layout, points, mask);
    unbalanced_ = Array("newton.unbalanced", layout.size());
    single_ = ArrayOf<float>("newton.unbalanced", layout.size());
    const Axis& vertical = layout.axis[D - 1];
    const Gauss gauss(points);
    std::vector<double> column(vertical.degree() + 1, 0.0);
    for (int q = 0; q < points; ++q) {
      const int e = layout.solid_elements;
      const auto value = vertical.values(e, vertical.lower(e) + vertical.size(e) * gauss.point[q]);
      for (std::size_t k = 0; k < column.size(); ++k)
        column[k] += vertical.size(e) * gauss.weight[q] * value[0] * value[k];
    }
    column_ = to_device<Array>(column, "newton.column");
  }

  /// @param residual  zero on ghosts
  void set(const ConstArray& residual) {
    if (layout_.rate_rows == 0) return;
    const int first = layout_.potential_offset(), row = layout_.row_size,
              count = row * static_cast<int>(column_.extent(0));
    Kokkos::deep_copy(Exec(), unbalanced_, 0.0);
    const Array rows = Kokkos::subview(unbalanced_, Kokkos::make_pair(first, first + count));
    Kokkos::parallel_for("softwet::spread_over_rows", Items(0, count),
                         SpreadOverRows{rows, part(residual, first, first + row), column_, row});
    mass_->solve(unbalanced_, D + 1, D + 2);
    move_ghosts(layout_, unbalanced_, GhostAction::update);
    convert(single_, unbalanced_);
  }

  /// In the layout of the unknowns; empty where no line has friction.
  ConstArray unbalanced() const { return unbalanced_; }
  ConstArrayOf<float> single_unbalanced() const { return single_; }

 private:
  const Layout<D>& layout_;
  std::optional<KroneckerMass<D>> mass_;
  Array unbalanced_, column_;
  ArrayOf<float> single_;
};

}  // namespace softwet
