// Dense inverses of overlapping boxes of control points, stored in 16 bits, and their weighted sum.
#pragma once

#include <optional>

#include "solver/schwarz/box_products.hpp"
#include "solver/schwarz/dense_inverse.hpp"
#include "solver/schwarz/shared_inverses.hpp"

namespace softwet {

/// z += damping sum over boxes of W_b A_b^-1 W_b r_b. A_b: all fields of the box; W_b: one over the square root of the
/// number of boxes that hold the unknown. Sums have a fixed order.
///
/// Applying reads every inverse once. To read less, they are stored as the upper half of single precision (bfloat16,
/// 8 significant bits). This is a relative error of 2^-8 in each entry and was measured to cost no iterations. Sums are
/// in single precision. Boxes whose matrices are alike use one inverse (solver/schwarz/shared_inverses.hpp).
template <int D>
class Boxes {
 public:
  /// Boxes `width` control points wide, `stride` apart; see make_patches.
  /// @param share  distance below which boxes share an inverse; 0: none does
  Boxes(const Layout<D>& layout, const ConstArray& mask, int width, int stride, float share = 0);

  void build(const StencilMatrix<D>& matrix);
  void add(const ConstArray& r, const Array& z, float damping) const {
    multiply(r, NothingBeside());
    collect(ConstArray(z), damping, {}, z);
  }
  /// The two kernels of this, for vectors of any precision. The first one does the items of something else too:
  /// beside(i) for i < beside.items(), and the second one begins with start(i): z = factors (start + sum over boxes).
  template <class Real, class Beside>
  void multiply(const ConstArrayOf<Real>& r, const Beside& beside) const {
    ApplyBoxes<Real, Beside>{size_, dof_, member_,   first_member_, inverses_, weight_,
                             r,     out_, unknowns_, items_,        beside,    0}
        .run();
  }
  template <class Start, class Real>
  void collect(const Start& start, float damping, const RangeFactors& factors, const ArrayOf<Real>& z) const {
    CollectBoxes<Start, Real>{grouped_, place_, weight_, out_, start, damping, factors, z}.run();
  }
  /// Before the first build as if no inverse was shared.
  double bytes() const;
  int count() const { return count_; }
  /// Number of inverses of the last build.
  int inverses() const { return built_; }

 private:
  using Indices = Kokkos::View<const int*, Exec>;
  using Table = Kokkos::View<int*, Exec>;

  Boxes(const Layout<D>&, const PatchTables&, int width, float share);
  int batch() const;
  void allocate();
  void build_some(const StencilMatrix<D>&, const int* boxes, int count);
  void place_inverses(const int* boxes, int count);
  void group();

  int width_, count_, unknowns_, sites_;
  int row_;    ///< boxes that follow each other along the first axis
  int round_;  ///< control points once around the first axis; 0: it is not periodic
  std::vector<int> sizes_;
  Indices size_, dof_, local_, start_, column_, place_, grouped_;
  Kokkos::View<const float*, Exec> weight_;
  SharedInverses shared_;
  BoxInverses inverses_;
  std::int64_t most_ = 0, used_ = 0;  ///< entries of all inverses: if none is shared, and as built
  std::vector<std::int64_t> begin_;   ///< as inverses_.begin
  int built_ = 0;
  Table member_, first_member_;  ///< boxes in the order of their inverses, cut into items that are multiplied together
  int items_ = 0;
  Kokkos::View<float*, Exec> out_;
  DenseBlocks blocks_;  ///< matrices of some boxes during a build
  Table block_box_;     ///< which boxes these are
  Table to_invert_;     ///< how many rows of each are inverted: 0 where an inverse is shared
  std::optional<BatchInverse> invert_;
};

}  // namespace softwet
