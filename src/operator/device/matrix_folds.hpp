// The axes of an element's matrix, folded one after another by a team of threads.
#pragma once

#include "operator/device/team_element.hpp"
#include "operator/matrix_point.hpp"

namespace softwet {

/// As fold_axis, for a team. In 3D three folds follow each other, in 2D two.
template <class Shape>
struct MatrixFolds {
  using Tables = RowTables<Shape>;
  static constexpr int D = Shape::D, P = Shape::P, Q = Shape::Q, QL = Shape::QL;
  static constexpr int n2 = (P + 1) * (P + 1), wall_points = power(Q, D - 1);
  static constexpr int after_x = D * D * n2 * (wall_points / Q * QL), after_y = D == 3 ? 4 * n2 * n2 * QL : 0;
  static constexpr int size = after_x + after_y;

  /// in(k, l, q): derivative k of the test and l of the trial function at point q, where used(k, l); add(entry, value) is called
  /// for each entry of the matrix, numbered by the pairs of functions with that of the first axis slowest.
  template <class Team, class Used, class In, class Add>
  static KOKKOS_FORCEINLINE_FUNCTION void run(const Team& team, const Tables& table, float* room, const Used& used,
                                              const In& in, const Add& add) {
    float* const y = room + after_x;
    constexpr int rest_x = wall_points / Q * QL;
    team.barrier();  // what was folded before has been read
    share(team, after_x, [&](int i) {
      const int pair = i / rest_x % n2, kl = i / rest_x / n2;
      room[i] = fold<Q>(table, 0, 0, kl / D, kl % D, pair, used,
                        [&](int k, int l, int q) { return in(k, l, i % rest_x * Q + q); });
    });
    team.barrier();
    const auto all = [](int, int) { return true; };
    if constexpr (D == 2) {
      share(team, n2 * n2, [&](int i) {
        add(i, fold<QL>(table, 2, 1, 0, 0, i % n2, all,
                        [&](int k, int l, int q) { return room[((k * 2 + l) * n2 + i / n2) * rest_x + q]; }));
      });
    } else {
      share(team, after_y, [&](int i) {
        const int pair = i / QL % n2, before = i / QL / n2 % n2, kl = i / QL / n2 / n2;
        y[i] = fold<Q>(table, 1, 1, kl / 2, kl % 2, pair, all, [&](int k, int l, int q) {
          return room[((k * 3 + l) * n2 + before) * rest_x + i % QL * Q + q];
        });
      });
      team.barrier();
      share(team, n2 * n2 * n2, [&](int i) {
        add(i, fold<QL>(table, 3, 2, 0, 0, i % n2, all,
                        [&](int k, int l, int q) { return y[((k * 2 + l) * n2 * n2 + i / n2) * QL + q]; }));
      });
    }
  }

 private:
  /// One sum: derivatives (k, l) along later axes, a pair of functions of this one. Where k = 0 the test function has no
  /// derivative, or one along this axis.
  template <int Points, class Used, class In>
  static KOKKOS_FORCEINLINE_FUNCTION float fold(const Tables& table, int row, int column, int k, int l, int pair,
                                                const Used& used, const In& in) {
    const int i = pair / (P + 1), j = pair % (P + 1);
    float sum = 0;
    for (int a = k > 0 ? k + 1 : 0; a <= (k > 0 ? k + 1 : 1); ++a)
      for (int b = l > 0 ? l + 1 : 0; b <= (l > 0 ? l + 1 : 1); ++b) {
        if (!used(a, b)) continue;
        for (int q = 0; q < Points; ++q)
          sum += table.basis(row, a == 1, q, i) * table.basis(column, b == 1, q, j) * in(a, b, q);
      }
    return sum;
  }
};

}  // namespace softwet
