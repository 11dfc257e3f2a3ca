// The Jacobian of a term as a matrix, with frozen geometry: element matrices by sum factorisation, added to a stencil.
// It is computed in single precision, in which preconditioners keep it.
//
// At a point the tangent of a term is a small matrix: test channel and its derivatives against unknown and its
// derivatives. Dual numbers seeded one by one give its columns; folding the axes one after another turns it into the
// element's matrix. Most of the small matrix is zero, and what is zero at all points of a batch is not folded. A thread of the
// host does this for a batch of elements, a team of a device for one element (team_jacobian.hpp).
#pragma once

#include <stdexcept>

#include "operator/device/team_jacobian.hpp"

namespace softwet {

/// Which blocks of a small matrix are not zero: [derivative of the test function][of the trial function].
template <int Size>
struct Blocks {
  bool used[Size][Size];

  KOKKOS_FORCEINLINE_FUNCTION Blocks() {
    for (int k = 0; k < Size; ++k)
      for (int l = 0; l < Size; ++l) used[k][l] = false;
  }
};

/// Integrates over one axis. in(k, l, pair, q): derivative k of the test and l of the trial function (0: none,
/// 1: along this axis, 2..: along a later one), pairs of functions of earlier axes, points with this axis fastest.
/// out[k][l][pair (P+1)^2 + (test, trial)][rest]: derivatives along later axes only. Blocks that are not used are neither
/// read nor written.
template <int Later, int Pairs, int Rest, int P, int Q, class S, class Row, class Column, class In>
KOKKOS_FORCEINLINE_FUNCTION void fold_axis(const Row& row, const Column& column, const Blocks<Later + 2>& blocks,
                                           const In& in,
                                           S (&out)[Later + 1][Later + 1][Pairs * (P + 1) * (P + 1)][Rest],
                                           Blocks<Later + 1>& left_over) {
  constexpr int n = P + 1;
  for (int k = 0; k < Later + 2; ++k)
    for (int l = 0; l < Later + 2; ++l) {
      if (!blocks.used[k][l]) continue;
      auto& sum = out[k > 0 ? k - 1 : 0][l > 0 ? l - 1 : 0];
      bool& begun = left_over.used[k > 0 ? k - 1 : 0][l > 0 ? l - 1 : 0];
      if (!begun)
        for (int e = 0; e < Pairs * n * n; ++e)
          for (int r = 0; r < Rest; ++r) sum[e][r] = S(0.0);
      begun = true;
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

/// Adds an element matrix.
template <class S, int D, int P>
KOKKOS_FORCEINLINE_FUNCTION void add_element_matrix(const Stencil<D>& stencil, float* values, int row, int column,
                                                    int first, int count, const S* matrix) {
  for (int e = 0; e < power(P + 1, 2 * D); ++e)
    add_lanes<S>(values + place_of_entry<D, P>(stencil, row, column, first, e), matrix[e], count);
}

/// The small matrices of one unknown at the points of a batch: [derivative of the trial function][channel]
/// [derivative of the test function][point].
template <class S, int D, int channels, int points>
struct PointMatrices {
  S at[1 + D][channels][1 + D][points];

  KOKKOS_FORCEINLINE_FUNCTION Blocks<1 + D> blocks(int channel) const {
    Blocks<1 + D> b;
    for (int k = 0; k <= D; ++k)
      for (int l = 0; l <= D; ++l)
        for (int q = 0; q < points && !b.used[k][l]; ++q) b.used[k][l] = any_nonzero(at[l][channel][k][q]);
    return b;
  }
};

/// The matrices of one batch: unknown by unknown, test channel by test channel.
template <class S, int D, int P, int Q, class Term, class Motion>
KOKKOS_FUNCTION void jacobian_batch(const Task<D, Term, Motion, float>& task, const Batch<D>& b,
                                    const Stencil<D>& stencil, float* values) {
  constexpr int QL = points_across<Term, Q>, n2 = (P + 1) * (P + 1), wall_points = power(Q, D - 1);
  constexpr int points = wall_points * QL;
  using N = Dual<S>;
  using Trial = typename Term::template Trial<N, D>;
  using Test = typename Term::template Test<N, D>;
  constexpr int channels = Test::channel_count;
  const BatchBasis<S, D, P, Q, QL> basis(task.region, b);
  using Fields = BatchFields<S, S, D, P, Q, QL, typename Term::template Trial<S, D>>;
  const Fields fields(task, b, basis);
  const BatchGeometry<S, S, D, P, Q, Motion> geometry(task.region, b, basis.x, basis.y, task.motion);
  PointMatrices<S, D, channels, points> matrices;
  for (int u = 0; u < D + 2; ++u) {
    if (!reads<Trial, D>(u)) continue;
    for (int q = 0; q < points; ++q) {
      const auto plain = point_at<Term, Q, S>(geometry, task, b, q);
      using Point = FrozenPoint<N, D, std::remove_const_t<decltype(plain)>>;
      const Point point{plain};
      const S weight = task.factor * weight_at<S, D, Q>(task.region, b, q);
      for (int l = 0; l <= D; ++l) {
        using Seeded = SeededFields<Fields, N, Trial, D>;
        const Seeded seeded{fields, u, l};
        for (int c = 0; c < channels; ++c)
          for (int k = 0; k <= D; ++k) matrices.at[l][c][k][q] = S(0.0);
        const Test test = task.term.residual(Trial::read(Reader<N, D, Seeded, Point>{seeded, point, q}));
        test.write(Writer<S, N, D, points, Point>{matrices.at[l], point, weight, q});
      }
    }
    for (int c = 0; c < channels; ++c) {
      if (!Stencil<D>::couples(Test::channel(c).unknown(D), u)) continue;
      const Blocks<1 + D> blocks = matrices.blocks(c);
      const auto in = [&](int k, int l, int, int q) { return matrices.at[l][c][k][q]; };
      S x[D][D][n2][wall_points / Q * QL], matrix[1][1][power(n2, D)][1];
      Blocks<D> of_x;
      Blocks<1> of_matrix;
      fold_axis<D - 1, 1, wall_points / Q * QL, P, Q>(basis.x, basis.x, blocks, in, x, of_x);
      const auto from_x = [&](int k, int l, int pair, int q) { return x[k][l][pair][q]; };
      if constexpr (D == 2) {
        fold_axis<0, n2, 1, P, QL>(basis.test, basis.last, of_x, from_x, matrix, of_matrix);
      } else {
        S y[2][2][n2 * n2][QL];
        Blocks<2> of_y;
        fold_axis<1, n2, QL, P, Q>(basis.y, basis.y, of_x, from_x, y, of_y);
        fold_axis<0, n2 * n2, 1, P, QL>(
            basis.test, basis.last, of_y, [&](int k, int l, int pair, int q) { return y[k][l][pair][q]; }, matrix,
            of_matrix);
      }
      if (!of_matrix.used[0][0]) continue;
      static_assert(sizeof(matrix) == power(P + 1, 2 * D) * sizeof(S));
      add_element_matrix<S, D, P>(stencil, values, Test::channel(c).unknown(D), u, first_test(task.region, b), b.count,
                                  &matrix[0][0][0][0]);
    }
  }
}

template <int D, int P, int Q, class Term, class Motion>
struct JacobianBatch {
  Task<D, Term, Motion, float> task;
  Stencil<D> stencil;
  StencilValues values;

  KOKKOS_FUNCTION void operator()(const Batch<D>& b) const {
    jacobian_batch<BatchNumber<float>, D, P, Q, Term, Motion>(task, b, stencil, values.data());
  }
};

/// Points per axis in the quadrature of matrices, whatever the scene has. In 3D it is reduced: Schwarz takes no more iterations
/// for that. In 2D LU would.
template <int D, int P>
inline constexpr int matrix_points = D == 3 ? P : P + 1;

/// Adds the term's Jacobian with frozen geometry (task.motion without tangent) to a stencil. The region has matrix_points.
template <int P, int D, class Term, class Motion>
void assemble_jacobian(const Task<D, Term, Motion, float>& task, const Stencil<D>& stencil,
                       const StencilValues& values) {
  constexpr int Q = matrix_points<D, P>;
  if (task.region.axis[0].points != Q)
    throw std::logic_error("a matrix needs a region with the quadrature of matrices");
  if constexpr (host_algorithms) {
    for_colours("softwet::jacobian", task.region, P + 1, JacobianBatch<D, P, Q, Term, Motion>{task, stencil, values});
  } else {
    TeamJacobian<D, P, Q, Term, Motion>::launch(task, stencil, values);
  }
}

}  // namespace softwet
