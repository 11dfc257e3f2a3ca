// Dense inverses of overlapping boxes of control points, stored in 16 bits, and their weighted sum.
#pragma once

#include <optional>

#include "solver/dense_inverse.hpp"
#include "solver/patches.hpp"

namespace softwet {

/// z += factor sum over boxes of W_b A_b^-1 W_b r_b. A_b: all fields of the box; W_b: one over the square root of the
/// number of boxes that hold the unknown. Sums have a fixed order.
///
/// Applying reads every inverse once. To read less, they are stored as the upper half of single precision (bfloat16,
/// 8 significant bits). This is a relative error of 2^-8 in each entry and was measured to cost no iterations. Sums are
/// in single precision.
template <int D>
class Boxes {
 public:
  /// Boxes `width` control points wide, `stride` apart; see make_patches.
  Boxes(const Layout<D>& layout, const ConstArray& mask, int width, int stride);

  void build(const StencilMatrix<D>& matrix);
  void add(const ConstArray& r, const Array& z, float factor) const;
  double bytes() const;

 private:
  using Indices = Kokkos::View<const int*, Exec>;
  /// [box][strip of rows][column][row in the strip]: what one thread of the host reads lies in one piece.
  using Inverses = Kokkos::View<std::uint16_t*, Exec>;

  int batch() const;

  int width_, count_, unknowns_, sites_, strip_;
  int row_;                   ///< boxes that follow each other along the first axis
  std::int64_t entries_ = 0;  ///< of all inverses
  int round_;                 ///< control points once around the first axis; 0: it is not periodic
  Indices size_, dof_, local_, start_, column_, place_, grouped_;
  Kokkos::View<const std::int64_t*, Exec> begin_;  ///< first entry of each inverse
  Kokkos::View<const float*, Exec> weight_;
  Inverses inverse_;
  Kokkos::View<float*, Exec> out_;
  DenseBlocks blocks_;  ///< matrices of some boxes during a build
  std::optional<BatchInverse> inverses_;
};

}  // namespace softwet
