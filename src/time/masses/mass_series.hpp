// The kernels of the series that inverts a mass: each is one launch, with the ties of its ends.
#pragma once

#include "solver/krylov/mass_product.hpp"
#include "time/masses/end_ties.hpp"
#include "time/masses/mass_kernels.hpp"

namespace softwet {

/// A c = a (left c + right M (root c)), by control point: the mass of a moved mesh (MassInverse).
struct WeightedMass {
  Array sums, unit;         ///< a, and the row sums m of M
  Array root, left, right;  ///< s = sqrt(a / m), and the factors
};

/// The pointers of that, for kernels.
struct WeightedPointers {
  const double *sums, *root, *left, *right;
  explicit WeightedPointers(const WeightedMass& m)
      : sums(m.sums.data()), root(m.root.data()), left(m.left.data()), right(m.right.data()) {}
};

namespace mass_kernels {

/// A stage of the series with the ties of its ends: each value, the ties between values, and, where a product follows,
/// its scaled vector from each value; then what else is done with it. An item is a block of lines on a processor. On a
/// device it is a cluster of ties with all its values, or a value without ties.
template <class Stage, class Values = ValuesOfItem, class After = Nothing>
struct WithTies {
  static constexpr bool lines = std::is_same_v<Values, BlockOfLines>;
  Stage stage;
  TieClusters ties;
  After after = {};

  KOKKOS_FUNCTION void operator()(int item) const {
    if constexpr (lines) {
      stage.run(BlockOfLines{item});
      if (ties.count() > 0)
        for (int c = ties.of_block(item); c < ties.of_block(item + 1); ++c) stage.tie(ties, c);
      end(BlockOfLines{item});
    } else if (item >= ties.count()) {
      const OneValue value{item - ties.count()};
      if (ties.count() > 0 && ties.tied(value.number)) return;
      stage.run(value);
      end(value);
    } else {
      const int first = ties.first_member(item), last = ties.first_member(item + 1);
      for (int m = first; m < last; ++m) stage.run(OneValue{ties.member(m)});
      stage.tie(ties, item);
      for (int m = first; m < last; ++m) end(OneValue{ties.member(m)});
    }
  }

  int items(int components) const {
    return lines ? components * stage.blocks().count() : ties.count() + components * stage.blocks().nodes;
  }
  Counted<WithTies> on(int components) const { return {items(components), *this}; }
  void launch(const char* name, int components) const {
    Kokkos::parallel_for(name, Items(0, items(components)), *this);
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION void end(Values values) const {
    if (stage.scaled) stage.blocks().for_values(values, [&](int i, int node) { stage.end(i, node); });
    if constexpr (!std::is_same_v<After, Nothing>) stage.blocks().for_values(values, [&](int i, int) { after(i); });
  }
};

/// x = W D^{-1} (factor b) with ties W and zeros where the mask has some, and scaled = start root x for the first
/// product.
template <int D>
struct DivideBySums {
  LineBlocks<D> lines;
  RightSide<D> side;
  double factor;
  ConstArray mask;
  WeightedPointers mass;
  double *x, *scaled;  ///< the latter null where no product follows
  double start;        ///< the first y of the series over x

  KOKKOS_FORCEINLINE_FUNCTION const LineBlocks<D>& blocks() const { return lines; }

  template <class Values>
  KOKKOS_FORCEINLINE_FUNCTION void run(Values values) const {
    lines.for_values(values, [&](int i, int node) {
      const double b = side(i);
      x[i] = mask(i) != 0 ? b * (factor / mass.sums[node]) : 0.0;
    });
  }
  KOKKOS_FUNCTION void tie(const TieClusters& ties, int cluster) const { ties.smooth(cluster, x, mass.sums); }
  KOKKOS_FUNCTION void end(int i, int node) const { scaled[i] = start * mass.root[node] * x[i]; }
};

/// One term of the series: next = x + e (factor y) with e y = y - W A y / a.
template <int D, int P>
struct SeriesStep {
  BandProduct<D, P> product;  ///< of factor root y
  WeightedPointers mass;
  const double* mask;
  double factor;  ///< of y
  const double *x, *y;
  double *image, *next;  ///< A (factor y) / a before the ties, and the result, which may be y
  double* scaled;        ///< root next, or null at the end

  KOKKOS_FORCEINLINE_FUNCTION const LineBlocks<D>& blocks() const { return product.blocks; }

  template <class Values>
  KOKKOS_FORCEINLINE_FUNCTION void run(Values values) const {
    product.for_values(values, [&](int i, int node, double sum) {
      const double value = factor * y[i], part = mask[i] * (mass.left[node] * value + mass.right[node] * sum);
      image[i] = part;
      next[i] = x[i] + value - part;
    });
  }
  KOKKOS_FUNCTION void tie(const TieClusters& ties, int cluster) const { ties.smooth(cluster, image, mass.sums, next); }
  KOKKOS_FUNCTION void end(int i, int node) const { scaled[i] = mass.root[node] * next[i]; }
};

/// From the product of the roots: the factors of A c = a (left c + right M (root c)).
template <int D, int P>
struct FindFactors {
  BandProduct<D, P> product;  ///< of root
  WeightedPointers mass;
  double *left, *right;

  Counted<FindFactors> on_all() const { return {product.blocks.items(1), *this}; }
  KOKKOS_FUNCTION void operator()(int item) const {
    product.for_values(ValuesOfItem{item}, [&](int i, int, double sum) {
      right[i] = mass.root[i] / mass.sums[i];
      left[i] = 1 - sum * right[i];
    });
  }
};

/// out = sums A z / a for a scalar, of which `in` is the product's vector.
template <int D, int P>
struct MultiplyByMass {
  BandProduct<D, P> product;  ///< of root z
  WeightedPointers mass;
  const double *mask, *z;
  double* out;

  KOKKOS_FUNCTION void operator()(int item) const {
    product.for_values(ValuesOfItem{item}, [&](int i, int, double sum) {
      const double image = mask[i] * (mass.left[i] * z[i] + mass.right[i] * sum);
      out[i] = image * mass.sums[i];
    });
  }
};

}  // namespace mass_kernels
}  // namespace softwet
