// The Jacobian of a term as a matrix, with frozen geometry: element matrices by sum factorisation, added to a stencil.
//
// At a point the tangent of a term is a small matrix: test channel and its derivatives against unknown and its
// derivatives. Dual numbers seeded one by one give its columns; folding the axes one after another turns it into the
// element's matrix.
#pragma once

#include "field/stencil.hpp"
#include "operator/assemble.hpp"

namespace softwet {

/// Slots of a batch whose tangent is that of one reference derivative (0: value) of one unknown.
template <class Fields, class N, class Trial>
struct SeededFields {
  const Fields& fields;
  int unknown, derivative;

  KOKKOS_FORCEINLINE_FUNCTION N number(int s, int c, int q) const {
    const Slot kind = Trial::slot(s);
    const bool here = kind.unknown == unknown && c == derivative;
    using S = std::remove_cvref_t<decltype(fields.value[0][0][0])>;
    return N(fields.value[s][c][q], S(here ? fields.scale[static_cast<int>(kind.scale)] : 0.0));
  }
};

/// Integrates over one axis. in(k, l, pair, q): derivative k of the test and l of the trial function (0: none,
/// 1: along this axis, 2..: along a later one), pairs of functions of earlier axes, points with this axis fastest.
/// out[k][l][pair (P+1)^2 + (test, trial)][rest]: derivatives along later axes only.
template <int Later, int Pairs, int Rest, int P, int Q, class S, class Row, class Column, class In>
KOKKOS_FORCEINLINE_FUNCTION void fold_axis(const Row& row, const Column& column, const In& in,
                                           S (&out)[Later + 1][Later + 1][Pairs * (P + 1) * (P + 1)][Rest]) {
  constexpr int n = P + 1;
  for (int k = 0; k <= Later; ++k)
    for (int l = 0; l <= Later; ++l)
      for (int e = 0; e < Pairs * n * n; ++e)
        for (int r = 0; r < Rest; ++r) out[k][l][e][r] = S(0.0);
  for (int k = 0; k < Later + 2; ++k)
    for (int l = 0; l < Later + 2; ++l) {
      auto& sum = out[k > 0 ? k - 1 : 0][l > 0 ? l - 1 : 0];
      for (int pair = 0; pair < Pairs; ++pair)
        for (int r = 0; r < Rest; ++r)
          for (int q = 0; q < Q; ++q) {
            const S x = in(k, l, pair, r * Q + q);
            for (int i = 0; i < n; ++i) {
              const S left = (k == 1 ? row.slope[q][i] : row.value[q][i]) * x;
              for (int j = 0; j < n; ++j) {
                S& entry = sum[(pair * n + i) * n + j][r];
                entry = entry + (l == 1 ? column.slope[q][j] : column.value[q][j]) * left;
              }
            }
          }
    }
}

/// Adds an element matrix; pairs of functions with the first axis' pair slowest.
template <class S, int D, int P>
KOKKOS_FORCEINLINE_FUNCTION void add_element_matrix(const Stencil<D>& stencil, float* values, int row, int column,
                                                    int first, int count, const S (&matrix)[power(P + 1, 2 * D)]) {
  constexpr int n = P + 1, lanes = Lanes<S>::count;
  for (int e = 0; e < power(n, 2 * D); ++e) {
    int rest = e, point = first, offset = 0;
    for (int d = D - 1, pair = 0; d >= 0; --d) {
      pair = rest % (n * n);
      rest /= n * n;
      const int i = pair / n, j = pair % n;
      int stride = 1;
      for (int below = 0; below < d; ++below) stride *= stencil.extent[below];
      point += i * stride;
      offset = offset * (2 * P + 1) + j - i + P;
    }
    float* to = values + stencil.index(row, column, offset, point);
    if constexpr (lanes == 1) {
      *to += static_cast<float>(matrix[e]);
    } else {
      double lane[lanes];
      Kokkos::Experimental::simd_unchecked_store(matrix[e], lane, Kokkos::Experimental::simd_flag_default);
      for (int l = 0; l < count; ++l) to[l] += static_cast<float>(lane[l]);
    }
  }
}

/// The matrices of one batch: unknown by unknown, test channel by test channel.
template <class S, int D, int P, int QL, class Term, class Motion>
KOKKOS_FUNCTION void jacobian_batch(const Task<D, Term, Motion>& task, const Batch<D>& b, const Stencil<D>& stencil,
                                    float* values, int first_row, int first_column) {
  constexpr int Q = P + 1, n2 = (P + 1) * (P + 1), wall_points = power(Q, D - 1), points = wall_points * QL;
  using N = Dual<S>;
  using Trial = typename Term::template Trial<N, D>;
  using Test = typename Term::template Test<N, D>;
  constexpr int channels = Test::channel_count;
  const BatchBasis<S, D, P, Q, QL> basis(task.region, b);
  using Fields = BatchFields<S, S, D, P, Q, QL, typename Term::template Trial<S, D>>;
  const Fields fields(task, b, basis);
  const BatchGeometry<S, N, D, P, Q, Motion> geometry(task.region, b, basis.x, basis.y, task.motion);
  S at[1 + D][channels][1 + D][points];
  for (int u = 0; u < Trial::unknown_count; ++u) {
    for (int l = 0; l <= D; ++l)
      for (int q = 0; q < points; ++q) {
        const auto point = geometry.at(q, task.region.axis[D - 1].position(q / wall_points, b.element[D - 1]), QL == 1);
        using Point = std::remove_const_t<decltype(point)>;
        using Seeded = SeededFields<Fields, N, Trial>;
        const Seeded seeded{fields, u, l};
        for (int c = 0; c < channels; ++c)
          for (int k = 0; k <= D; ++k) at[l][c][k][q] = S(0.0);
        const Test test = task.term.residual(Trial::read(Reader<N, D, Seeded, Point>{seeded, point, q}));
        test.write(Writer<S, N, D, points, Point>{at[l], point, weight_at<S, D, Q>(task.region, b, q), q});
      }
    for (int c = 0; c < channels; ++c) {
      S x[D][D][n2][wall_points / Q * QL], matrix[1][1][power(n2, D)][1];
      fold_axis<D - 1, 1, wall_points / Q * QL, P, Q>(
          basis.x, basis.x, [&](int k, int l, int, int q) { return at[l][c][k][q]; }, x);
      if constexpr (D == 2) {
        fold_axis<0, n2, 1, P, QL>(
            basis.test, basis.last, [&](int k, int l, int pair, int q) { return x[k][l][pair][q]; }, matrix);
      } else {
        S y[2][2][n2 * n2][QL];
        fold_axis<1, n2, QL, P, Q>(
            basis.y, basis.y, [&](int k, int l, int pair, int q) { return x[k][l][pair][q]; }, y);
        fold_axis<0, n2 * n2, 1, P, QL>(
            basis.test, basis.last, [&](int k, int l, int pair, int q) { return y[k][l][pair][q]; }, matrix);
      }
      S flat[power(P + 1, 2 * D)];
      for (int e = 0; e < power(n2, D); ++e) flat[e] = matrix[0][0][e][0];
      add_element_matrix<S, D, P>(stencil, values, first_row + c, first_column + u, first_test(task.region, b), b.count,
                                  flat);
    }
  }
}

template <int D, int P, int QL, class Term, class Motion>
struct JacobianBatch {
  Task<D, Term, Motion> task;
  Stencil<D> stencil;
  StencilValues values;
  int first_row, first_column;

  KOKKOS_FUNCTION void operator()(const Batch<D>& b) const {
    jacobian_batch<BatchNumber<double>, D, P, QL, Term, Motion>(task, b, stencil, values.data(), first_row,
                                                                first_column);
  }
};

/// Adds the term's Jacobian with frozen geometry (task.motion without tangent) to a stencil; first_row and first_column
/// are the components of test channel 0 and of unknown 0.
template <int P, int QL, int D, class Term, class Motion>
void assemble_jacobian(const Task<D, Term, Motion>& task, const Stencil<D>& stencil, const StencilValues& values,
                       int first_row, int first_column) {
  for_colours("softwet::jacobian", task.region, P + 1,
              JacobianBatch<D, P, QL, Term, Motion>{task, stencil, values, first_row, first_column});
}

}  // namespace softwet
