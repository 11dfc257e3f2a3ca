// The axes of the matrix of a row of elements, folded one after another by a team of threads.
#pragma once

#include "operator/device/team_element.hpp"
#include "operator/matrix_point.hpp"

namespace softwet {

/// The elements of a row share their functions along the other axes, so the first fold adds them up, and the others
/// have one matrix for all of them. A pair of the first axis is a test function of the row and the distance of its
/// neighbour; test functions are numbered fastest everywhere, so that neighbouring threads read and write neighbouring
/// numbers.
template <class Shape>
struct MatrixFolds {
  using Tables = RowTables<Shape>;
  static constexpr int D = Shape::D, P = Shape::P, Q = Shape::Q, QL = Shape::QL, E = Shape::E, n = P + 1, n2 = n * n;
  static constexpr int tests = E + P, distances = 2 * P + 1, pairs = tests * distances;  ///< of the first axis
  static constexpr int rest = Shape::points / Q;                                         ///< points of the other axes
  static constexpr int before = D == 3 ? n2 : 1;                                         ///< pairs of the axis between

  /// Products of a test and a trial function at a point: of their values, of the value and the slope, and so on. A
  /// device reads them at once.
  struct alignas(16) Products {
    float of[2][2];  ///< [slope of the test function][slope of the trial function]
  };
  // Room in the scratch, in numbers. Products of the first axis are numbered [element and point][pair], others
  // [pair][point].
  static constexpr int of_x = E * Q * n2, of_y = D == 3 ? Q * n2 : 0, of_last = QL * n2;
  static constexpr int products = 4 * (of_x + of_y + of_last);
  static constexpr int after_x = D * D * rest * pairs, after_y = D == 3 ? 4 * n2 * QL * pairs : 0;
  static constexpr int size = after_x + after_y;

  /// The elements [begin, end) of the row are present. A pair lives on the elements [first, last] among them, on none
  /// where first > last.
  struct Held {
    int begin, end;
    KOKKOS_FORCEINLINE_FUNCTION int first(int pair) const {
      const int test = pair % tests, other = neighbour(pair), low = (other > test ? other : test) - P;
      return low > begin ? low : begin;
    }
    KOKKOS_FORCEINLINE_FUNCTION int last(int pair) const {
      const int test = pair % tests, other = neighbour(pair), high = other < test ? other : test;
      return high < end ? high : end - 1;
    }
  };
  /// Distances between the entries of the next functions of the last axis.
  struct Steps {
    std::int64_t test, trial;
  };
  static KOKKOS_FORCEINLINE_FUNCTION int neighbour(int pair) { return pair % tests + pair / tests - P; }

  template <class Team>
  static KOKKOS_FORCEINLINE_FUNCTION void load(const Team& team, const Tables& table, Products* to) {
    share(team, of_x, [&](int i) { to[i] = products_of(table, 0, 0, i / n2, i % n2); });
    if constexpr (D == 3) share(team, of_y, [&](int i) { to[of_x + i] = products_of(table, 1, 1, i % Q, i / Q); });
    share(team, of_last, [&](int i) { to[of_x + of_y + i] = products_of(table, D, D - 1, i % QL, i / QL); });
  }

  /// @param in     in(k, l, q): derivative k of the test and l of the trial function at point q
  /// @param entry  entry(pair, middle): place of the entry of a pair of the first axis and of the axis between, for the
  ///   test and trial functions 0 of the last axis; the entry of functions i and j is i steps.test + j steps.trial
  ///   further
  template <class Team, class In, class Entry>
  static KOKKOS_FORCEINLINE_FUNCTION void run(const Team& team, const Products* products, float* x, const Held& held,
                                              const In& in, const Entry& entry, const Steps& steps) {
    float* const y = x + after_x;
    team.barrier();  // the previous folds have been read
    share(team, rest * pairs, [&](int i) { fold_x(products, held, i % pairs, i / pairs, in, x + i); });
    team.barrier();
    if constexpr (D == 3) {
      share(team, n * QL * pairs, [&](int item) {
        const int pair = item % pairs, q = item / pairs % QL, i = item / pairs / QL;
        const Values<D, Q> values(
            [&](int k, int l, int p) { return x[((k * D + l) * rest + q * Q + p) * pairs + pair]; });
        for (int j = 0; j < n; ++j) {
          float sum[2][2];
          values.sum(products + of_x + (i * n + j) * Q, sum);
          for (int k = 0; k < 2; ++k)
            for (int l = 0; l < 2; ++l) y[(((k * 2 + l) * n2 + i * n + j) * QL + q) * pairs + pair] = sum[k][l];
        }
      });
      team.barrier();
    }
    const float* const from = D == 3 ? y : x;
    share(team, before * pairs, [&](int item) {
      const int pair = item % pairs, middle = item / pairs;
      if (held.first(pair) > held.last(pair)) return;
      const Values<2, QL> values(
          [&](int k, int l, int q) { return from[(((k * 2 + l) * before + middle) * QL + q) * pairs + pair]; });
      add(values, products + of_x + of_y, entry(pair, middle), steps);
    });
  }

 private:
  static KOKKOS_FORCEINLINE_FUNCTION Products products_of(const Tables& table, int row, int column, int q, int pair) {
    Products p;
    for (int k = 0; k < 2; ++k)
      for (int l = 0; l < 2; ++l)
        p.of[k][l] = table.basis(row, k == 1, q, pair / n) * table.basis(column, l == 1, q, pair % n);
    return p;
  }

  /// The sums of a pair at one point of the other axes: to[derivatives along these], of test and trial function. Of the
  /// derivatives of `in`, 0 is the value, 1 the derivative along this axis, and the others are derivatives along later
  /// axes.
  template <class In>
  static KOKKOS_FORCEINLINE_FUNCTION void fold_x(const Products* products, const Held& held, int pair, int r,
                                                 const In& in, float* to) {
    const int test = pair % tests, other = neighbour(pair), last = held.last(pair);
    float sum[D][D] = {};
    for (int e = held.first(pair); e <= last; ++e)
      for (int q = 0; q < Q; ++q) {
        const Products p = products[(e * Q + q) * n2 + (test - e) * n + other - e];
        for (int k = 0; k <= D; ++k)
          for (int l = 0; l <= D; ++l)
            sum[k > 1 ? k - 1 : 0][l > 1 ? l - 1 : 0] += p.of[k == 1][l == 1] * in(k, l, (e * rest + r) * Q + q);
      }
    for (int k = 0; k < D; ++k)
      for (int l = 0; l < D; ++l) to[(k * D + l) * rest * pairs] = sum[k][l];
  }

  /// Values to fold along an axis: of their derivatives, 1 is along this axis, 2 along a later one.
  template <int derivatives, int points>
  struct Values {
    float value[derivatives][derivatives][points];

    template <class In>
    explicit KOKKOS_FORCEINLINE_FUNCTION Values(const In& in) {
      for (int k = 0; k < derivatives; ++k)
        for (int l = 0; l < derivatives; ++l)
          for (int q = 0; q < points; ++q) value[k][l][q] = in(k, l, q);
    }
    /// Sums with products of a pair at all points: [test function has a derivative along a later axis][trial function].
    KOKKOS_FORCEINLINE_FUNCTION void sum(const Products* products,
                                         float (&to)[derivatives - 1][derivatives - 1]) const {
      for (int k = 0; k < derivatives - 1; ++k)
        for (int l = 0; l < derivatives - 1; ++l) to[k][l] = 0;
      for (int q = 0; q < points; ++q) {
        const Products p = products[q];
        for (int k = 0; k < derivatives; ++k)
          for (int l = 0; l < derivatives; ++l) to[k / 2][l / 2] += p.of[k == 1][l == 1] * value[k][l][q];
      }
    }
  };

  /// All entries are read before the first is written, so that a device waits for memory once.
  template <class Values>
  static KOKKOS_FORCEINLINE_FUNCTION void add(const Values& values, const Products* products, float* to,
                                              const Steps& steps) {
    float entry[n][n];
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) entry[i][j] = to[i * steps.test + j * steps.trial];
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        float sum[1][1];
        values.sum(products + (i * n + j) * QL, sum);
        to[i * steps.test + j * steps.trial] = entry[i][j] + sum[0][0];
      }
  }
};

}  // namespace softwet
