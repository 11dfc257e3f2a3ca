// What a matrix makes of the correction of a coarse level, without the correction itself.
#pragma once

#include "solver/schwarz/coarse_space.hpp"

namespace softwet {

/// Along one axis: the coarse places whose functions reach the neighbours of a fine one, and how much of each they
/// have. All fine places have room for as many; those that are not needed come last and have the weight zero.
struct AxisColumns {
  Kokkos::View<int*, Exec> count;                            ///< [fine place]
  Kokkos::View<int**, Kokkos::LayoutRight, Exec> place;      ///< [fine place][column]
  Kokkos::View<float***, Kokkos::LayoutRight, Exec> weight;  ///< [column][shift + degree][fine place]

  KOKKOS_FUNCTION int columns() const { return static_cast<int>(place.extent(1)); }
};

/// The values of A P: component a of a fine control point, component u of one of its coarse columns. They are the upper
/// halves of single precision. On a device neighbouring threads read neighbouring points; on the host a thread reads
/// all values of a row (all axes but the last) one after another.
template <int D>
struct CoarseImageValues {
  Stencil<D> stencil;  ///< of the matrix
  AxisColumns axis[D] = {};
  Kokkos::View<std::uint16_t*, Exec> entry = {};
  int in_row = 1;      ///< columns of a control point in one coarse row
  int row_points = 1;  ///< control points of a row
  int length = 0;      ///< of a row in storage

  KOKKOS_FUNCTION int rows() const { return stencil.extent[D - 1]; }
  KOKKOS_FUNCTION int columns() const { return in_row * axis[D - 1].columns(); }
  std::int64_t size() const { return std::int64_t(stencil.pairs()) * columns() * rows() * length; }
  /// Where the values of a row of control points begin, for a pair of components that couple.
  KOKKOS_FUNCTION std::int64_t begin(int pair, int column, int row) const {
    if constexpr (host_algorithms) return ((std::int64_t(row) * stencil.pairs() + pair) * columns() + column) * length;
    return ((std::int64_t(pair) * columns() + column) * rows() + row) * length;
  }
};

/// y = r - A P z for a vector z of a coarse space. The values of A P are kept, so that P z need not be computed before,
/// and in two and three dimensions 16 and 64 of them are read in the place of 25 and 125 of A (degree 2). Prescribed
/// values lie on whole sides, where free coarse functions are zero.
/// Each of several processes makes the rows of its own columns.
template <int D>
class CoarseImage {
 public:
  CoarseImage(const Layout<D>& fine, const ConstArray& mask, const CoarseSpace<D>& space);

  /// Allocates in the first call.
  void build(const StencilMatrix<D>& matrix);
  /// @param z  zero where it is prescribed, with the copies of other processes' columns
  /// @param y  zero where it is prescribed
  void residual(const ConstArray& r, const ConstArray& z, const Array& y) const;
  double bytes() const { return 2.0 * values_.size(); }

 private:
  CoarseImageValues<D> values_;
  ConstArray mask_;
  ComponentPlaces<D> places_, coarse_places_;
  int coarse_rows_, coarse_row_points_;
  Kokkos::View<int**, Kokkos::LayoutRight, Exec>
      source_;            ///< [column in a row][point of a row] its place in a coarse row
  StencilValues spread_;  ///< on the host: what each point of a row needs of each coarse row
};

}  // namespace softwet
