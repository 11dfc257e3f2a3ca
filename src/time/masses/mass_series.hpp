// The kernels of the series that inverts a mass: each is one launch, with the ties of its ends.
#pragma once

#include "solver/krylov/mass_product.hpp"
#include "time/masses/end_ties.hpp"
#include "time/masses/mass_kernels.hpp"

namespace softwet {

/// The mass of a moved mesh (MassInverse) by control point, for vectors that are scaled with the roots:
///   s A c / a = left (s c) + right M (s c),   left = 1 - s (M s) / a,   right = s^2 / a.
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

/// A stage of the series with the ties of its ends: each value, the ties between values, and, where a stage has an end,
/// the result from each value; then what else is done with it. An item is a block of lines on a processor. On a device
/// it is a cluster of ties with all its values, or a value without ties.
template <class Stage, class Values = ValuesOfItem, class After = Nothing>
struct WithTies {
  static constexpr bool lines = std::is_same_v<Values, BlockOfLines>;
  Stage stage;
  TieClusters ties;
  After after = {};

  KOKKOS_FUNCTION void operator()(int item) const {
    if constexpr (lines) {
      stage.run(BlockOfLines{item});
      if (ties.count() > 0) stage.tie(ties, BlockOfLines{item});
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
    if (!stage.ends()) return;
    stage.blocks().for_values(values, [&](int i, int node) {
      stage.end(i, node);
      after(i);
    });
  }
};

/// x = W D^{-1} (factor b) with ties W and zeros where the mask has some. With roots, x is the scaled vector s x.
template <int D>
struct DivideBySums {
  LineBlocks<D> lines;
  RightSide<D> side;
  double factor;
  ConstArray mask;
  const double *sums, *root;
  double* x;

  KOKKOS_FORCEINLINE_FUNCTION const LineBlocks<D>& blocks() const { return lines; }
  KOKKOS_FORCEINLINE_FUNCTION static constexpr bool ends() { return false; }
  KOKKOS_FORCEINLINE_FUNCTION void end(int, int) const {}

  template <class Values>
  KOKKOS_FORCEINLINE_FUNCTION void run(Values values) const {
    side.visit([&](const auto& value) {
      const auto store = [&, free = mask.data(), a = sums, f = factor, to = x](int i, int node, double scale) {
        const double result = value(i) * (f * scale / a[node]);
        to[i] = free[i] != 0 ? result : 0.0;
      };
      if (root) return lines.for_values(values, [&, s = root](int i, int node) { store(i, node, s[node]); });
      lines.for_values(values, [&](int i, int node) { store(i, node, 1); });
    });
  }
  template <class Which>
  KOKKOS_FUNCTION void tie(const TieClusters& ties, Which which) const {
    ties.smooth(which, {x, sums, root, nullptr});
  }
};

/// One term of the series: next = x + e (factor y) with e y = y - W A y / a. All vectors are scaled with the roots.
template <int D, int P>
struct SeriesStep {
  BandProduct<D, P> product;  ///< of y
  WeightedPointers mass;
  const double* mask;
  double factor;  ///< of y
  const double* x;
  double *image, *next;  ///< W A (factor y) / a of values that ties connect; and the result
  double* result;        ///< next without the roots, or null

  KOKKOS_FORCEINLINE_FUNCTION const LineBlocks<D>& blocks() const { return product.blocks; }
  KOKKOS_FORCEINLINE_FUNCTION bool ends() const { return result; }

  template <class Values>
  KOKKOS_FORCEINLINE_FUNCTION void run(Values values) const {
    product.for_values(values, [from = x, y = product.in, free = mask, left = mass.left, right = mass.right, to = next,
                                f = factor](int i, int node, double sum) {
      to[i] = from[i] + f * (y[i] - free[i] * (left[node] * y[i] + right[node] * sum));
    });
  }
  template <class Which>
  KOKKOS_FUNCTION void tie(const TieClusters& ties, Which which) const {
    int first, last;
    ties.members(which, first, last);
    for (int m = first; m < last; ++m) {
      const int i = ties.member(m);
      image[i] = x[i] + factor * product.in[i] - next[i];
    }
    ties.smooth(which, {image, mass.sums, mass.root, next});
  }
  KOKKOS_FUNCTION void end(int i, int node) const { result[i] = next[i] / mass.root[node]; }
};

/// From the product of the roots: the factors of a mass.
template <int D, int P>
struct FindFactors {
  BandProduct<D, P> product;  ///< of root
  WeightedPointers mass;
  double *left, *right;

  Counted<FindFactors> on_all() const { return {product.blocks.items(1), *this}; }
  KOKKOS_FUNCTION void operator()(int item) const {
    product.for_values(ValuesOfItem{item}, [&](int i, int, double sum) {
      const double root = mass.root[i], per_sum = root / mass.sums[i];
      right[i] = root * per_sum;
      left[i] = 1 - sum * per_sum;
    });
  }
};

/// out = A z for a scalar.
template <int D, int P>
struct MultiplyByMass {
  BandProduct<D, P> product;  ///< of root z
  WeightedPointers mass;
  const double *mask, *z;
  double* out;

  KOKKOS_FUNCTION void operator()(int item) const {
    product.for_values(ValuesOfItem{item}, [&](int i, int, double sum) {
      const double image = mask[i] * (mass.left[i] * z[i] + mass.right[i] / mass.root[i] * sum);
      out[i] = image * mass.sums[i];
    });
  }
};

}  // namespace mass_kernels
}  // namespace softwet
