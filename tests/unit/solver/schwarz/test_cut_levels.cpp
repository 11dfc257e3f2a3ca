// Parts of a level of Schwarz's method, as several processes store them, have the bits of the whole in their own
// columns.
#include "solver/schwarz/boxes.hpp"
#include "solver/schwarz/coarse_image.hpp"
#include "unit/solver/random_matrix.hpp"

namespace softwet::testing_tools {
namespace {

template <int D>
Layout<D> cut_layout(const Layout<D>& whole, int rank, const std::vector<int>& first, int beside) {
  Layout<D> part = whole;
  part.columns = cut_before(whole.axis[0], rank, first, beside);
  part.row_size = part.row_size / part.axis[0].functions() * part.columns.stored();
  return part;
}

/// What a process stores of a vector or of the values of a matrix; copies have the values of those they repeat.
template <int D, class View>
View stored_part(const Layout<D>& part, const View& all) {
  const Axis& axis = part.axis[0];
  const auto from = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), all);
  const int n = axis.functions(), width = part.columns.stored(), lines = static_cast<int>(all.extent(0)) / n;
  const View own("part", static_cast<std::size_t>(lines) * width);
  const auto to = Kokkos::create_mirror_view(own);
  for (int line = 0; line < lines; ++line)
    for (int i = 0; i < width; ++i) to(line * width + i) = from(line * n + part.columns.function[i] % axis.owned());
  Kokkos::deep_copy(own, to);
  return own;
}

/// Counts entries of own columns whose bits differ from the entries of the whole.
template <int D, class View>
int differences(const Layout<D>& part, const View& found, const View& expected, int* compared) {
  const auto a = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), found);
  const auto b = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), expected);
  const Columns& c = part.columns;
  const int n = part.axis[0].functions(), lines = static_cast<int>(b.extent(0)) / n;
  int different = 0;
  for (int line = 0; line < lines; ++line)
    for (int i = c.begin; i < c.end && c.function[i] < part.axis[0].owned(); ++i) {
      different += a(line * c.stored() + i) != b(line * n + c.function[i]);
      *compared += b(line * n + c.function[i]) != 0;
    }
  return different;
}

/// The values of a matrix without what lies behind them.
template <int D>
StencilValues values_of(const StencilMatrix<D>& matrix) {
  return Kokkos::subview(matrix.values(), Kokkos::make_pair(std::int64_t(0), matrix.stencil().size()));
}

template <int D>
struct CutLevels {
  RandomMatrix<D> all;
  int width, stride, shared = 0;
  static constexpr float share = 0.7f;  ///< so far that some of these random boxes share
  CoarseSpace<D> space;
  Array z, coarse_r, coarse_z, fine_z, left;
  StencilMatrix<D> coarse;

  CutLevels(const Shape& shape, int width, int stride)
      : all(shape),
        width(width),
        stride(stride),
        space(all.layout, all.mask, 2),
        z("z", all.layout.size()),
        coarse_r("coarse_r", space.layout().size()),
        fine_z("fine_z", all.layout.size()),
        left("left", all.layout.size()),
        coarse(space.layout(), space.mask()) {}

  void check(const std::vector<int>& first) {
    const Array r = to_array(all.direction());
    Boxes<D> boxes(all.layout, all.mask, width, stride, share);
    boxes.build(all.matrix);
    shared += boxes.count() - boxes.inverses();
    boxes.add(r, z, 1);
    space.restrict_to(r, coarse_r);
    coarse.fill([&](const StencilValues& values) { space.galerkin(all.matrix, values); });
    const DenseVector x = DenseVector::Random(space.layout().size());
    coarse_z = to_array(x);
    space.prolong(coarse_z, fine_z);
    CoarseImage<D> image(all.layout, all.mask, space);
    image.build(all.matrix);
    image.residual(r, coarse_z, left);
    for (int rank = 0; rank + 1 < static_cast<int>(first.size()); ++rank) check_part(rank, first, r);
    Kokkos::deep_copy(z, 0.0);
  }
  void check_part(int rank, const std::vector<int>& first, const Array& r) {
    const Layout<D> part = cut_layout(all.layout, rank, first, width - 1);
    const Array mask = stored_part(part, all.mask), here = stored_part(part, r), found("found", part.size());
    StencilMatrix<D> matrix(part, mask);
    matrix.fill(
        [&](const StencilValues& values) { Kokkos::deep_copy(values, stored_part(part, values_of(all.matrix))); });
    int compared = 0;
    Boxes<D> boxes(part, mask, width, stride, share);
    boxes.build(matrix);
    boxes.add(here, found, 1);
    EXPECT_EQ(differences(part, found, z, &compared), 0) << "boxes, rank " << rank;
    CoarseSpace<D> below(part, mask, 2);
    const Array down("down", below.layout().size());
    below.restrict_to(here, down);
    EXPECT_EQ(differences(below.layout(), down, coarse_r, &compared), 0) << "residual, rank " << rank;
    StencilMatrix<D> product(below.layout(), below.mask());
    product.fill([&](const StencilValues& values) { below.galerkin(matrix, values); });
    EXPECT_EQ(differences(below.layout(), values_of(product), values_of(coarse), &compared), 0)
        << "matrix, rank " << rank;
    below.prolong(stored_part(below.layout(), coarse_z), found);
    EXPECT_EQ(differences(part, found, fine_z, &compared), 0) << "correction, rank " << rank;
    CoarseImage<D> image(part, mask, below);
    image.build(matrix);
    image.residual(here, stored_part(below.layout(), coarse_z), found);
    EXPECT_EQ(differences(part, found, left, &compared), 0) << "what the correction leaves, rank " << rank;
    EXPECT_GT(compared, part.size());
  }
};

TEST(CutLevels, HaveTheBitsOfTheWholeInThePlane) {
  CutLevels<2> coupled({{24, 8}, 4}, 8, 6), around({{24, 28}, 0, 2, true}, 8, 6), cubic({{20, 8}, 0, 3, true}, 8, 6);
  for (CutLevels<2>* levels : {&coupled, &around, &cubic}) {
    const int end = levels->all.layout.axis[0].functions();
    levels->check({0, 12, end});
    levels->check({0, 4, 8, 16, end});
    levels->check({0, 5, end});  // between two coarse elements
  }
  EXPECT_GT(around.shared, 0);
}

TEST(CutLevels, HaveThemInSpace) {
  for (const Shape& shape : shapes_3d()) {
    CutLevels<3> levels(shape, 4, 3);
    const int end = levels.all.layout.axis[0].functions();
    levels.check({0, 4, end});
    levels.check({0, 3, 6, end});
    EXPECT_GT(levels.shared, 0);
  }
}

}  // namespace
}  // namespace softwet::testing_tools
