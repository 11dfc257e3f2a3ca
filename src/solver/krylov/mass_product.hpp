// Products with the mass matrix of the fixed mesh, axis by axis.
#pragma once

#include "field/ghosts.hpp"

namespace softwet {

/// A c = a (left c + right M (root c)), by control point: the mass of a moved mesh (time/mass_inverse.hpp).
struct WeightedMass {
  Array sums, unit;         ///< a, and the row sums m of M
  Array root, left, right;  ///< s = sqrt(a / m), and the factors
};

/// One term of the series y <- x + e y with e y = y - W A y / a. Arrays of the components alone.
struct SeriesStep {
  ConstArray x, y;
  double factor = 1;  ///< of y
  ConstArray mask;
  Array image;  ///< A (factor y) / a, before the ties W
  Array next;   ///< x + factor y - image; may be y
};

/// The pointers of that, for kernels.
struct StepPointers {
  const double *x, *y, *mask, *root, *left, *right;
  double *image, *next;
  double factor;

  StepPointers(const WeightedMass& m, const SeriesStep& s)
      : x(s.x.data()),
        y(s.y.data()),
        mask(s.mask.data()),
        root(m.root.data()),
        left(m.left.data()),
        right(m.right.data()),
        image(s.image.data()),
        next(s.next.data()),
        factor(s.factor) {}

  /// @param product  of M with root factor y at value i, which belongs to a control point
  KOKKOS_FORCEINLINE_FUNCTION void finish(int i, int node, double product) const {
    const double value = factor * y[i], part = mask[i] * (left[node] * value + right[node] * product);
    image[i] = part;
    next[i] = x[i] + value - part;
  }
};

/// M = M_x (x) M_y (x) M_z for components of a vector of unknowns: entries (N_i, N_j) of the reference domain, in (r, z) with the
/// weight r.
/// An axis costs 2 degree + 1 products for each value, and no element is visited.
/// Source: tensor products of one-dimensional mass matrices.   Tested: tests/unit/solver/krylov/test_mass_product.cpp
template <int D, int P>
class MassProduct {
 public:
  /// @param points  of the quadrature, for an element and an axis; degree + 1 are exact
  MassProduct(const Layout<D>&, int points);

  /// out = M in for the components [first, last), which are either velocities or scalars; both are arrays of these alone.
  /// Reads ghosts, which have to be filled, and leaves those of the result open.
  void apply(const ConstArray& in, const Array& out, int first, int last) const;

  /// A step of the series by the same passes, and no other. Reads ghosts, and leaves those of the results open.
  void step(const WeightedMass&, const SeriesStep&, int first, int last) const;

  /// Ghosts of the components [first, last) take the values that they are copies of; the array is of these alone.
  void fill_ghosts(const Array& values, int first, int last) const;

 private:
  /// Entry (k, i) is M(i, i + k - degree).
  using Band = Kokkos::View<const double**, Kokkos::LayoutRight, Exec>;
  Band band(int d, const std::vector<ElementRun>&, int first_function, int functions, int points) const;
  int extent(int d, bool velocities) const;
  /// Closes a periodic axis at its ghosts. @param add  they are sums, which count for what the ghosts are copies of
  void close(int axis, const Array& values, int first, int last, bool add) const;
  template <bool Step>
  void run(const WeightedMass&, const SeriesStep&, const ConstArray& in, const Array& out, int first, int last) const;

  Layout<D> layout_;
  std::array<Band, D> velocity_, scalar_;
  Array scratch_[2];
};

}  // namespace softwet
