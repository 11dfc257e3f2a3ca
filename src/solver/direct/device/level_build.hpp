// Kernels that make the fronts of a level, and keep what their elimination leaves.
#pragma once

#include "solver/direct/device/level_tree.hpp"
#include "solver/matrix/stencil_matrix.hpp"

namespace softwet {

using LevelTeam = Kokkos::TeamPolicy<Exec>::member_type;
using LevelNumbers = Kokkos::View<float*, Exec>;
using LevelInts = Kokkos::View<const int*, Exec>;
using LevelFronts = Kokkos::View<const LevelFront*, Exec>;

/// Where an unknown is: its control point and its component.
template <int D>
struct LevelPlace {
  int at[D], component;
};

/// Entries of the scaled matrix between unknowns, whatever the distance between them.
template <int D>
struct ScaledEntries {
  Stencil<D> stencil;
  StencilValues values;
  Kokkos::View<const LevelPlace<D>*, Exec> place;  ///< [unknown]
  LevelNumbers row_scale, column_scale;            ///< [unknown]

  KOKKOS_FUNCTION float operator()(int row, int column) const {
    const LevelPlace<D> p = place(row), q = place(column);
    if (!stencil.couples(p.component, q.component)) return 0;
    int point = 0;
    for (int d = D - 1; d >= 0; --d) point = point * stencil.extent[d] + p.at[d];
    const std::int64_t first = stencil.index(p.component, q.component, 0, point);
    return sum<0>(p, q, first, stencil.points) * row_scale(row) * column_scale(column);
  }

 private:
  /// Around a short periodic axis several offsets lead to the same control point: the entry is the sum of their values.
  /// @param from  place of the value with the smallest offset along this axis and those behind it
  template <int Axis>
  KOKKOS_FUNCTION float sum(const LevelPlace<D>& p, const LevelPlace<D>& q, std::int64_t from,
                            std::int64_t stride) const {
    if constexpr (Axis == D) {
      return values(from);
    } else {
      const int width = 2 * stencil.degree + 1, period = stencil.period[Axis];
      int shift = q.at[Axis] - p.at[Axis] + stencil.degree;  // from the smallest offset
      if (period > 0) shift = (shift + period) % period;
      float result = 0;
      for (; shift >= 0 && shift<width; shift += period> 0 ? period : width)
        result += sum<Axis + 1>(p, q, from + shift * stride, stride * width);
      return result;
    }
  }
};

/// Fills the fronts of a level: entries of the matrix that no front below has taken, and the complements of the
/// children. A team is a column of a front; each entry is summed by one thread.
template <int D>
struct AssembleFronts {
  ScaledEntries<D> entries;
  LevelFronts fronts;
  LevelInts unknown, inherited;
  LevelNumbers level, below;  ///< memory of this level's fronts, and of their children's
  int first, rows;            ///< the first front; the most rows that one has

  KOKKOS_FUNCTION void operator()(const LevelTeam& team) const {
    const LevelFront f = fronts(first + team.league_rank() / rows);
    const int j = team.league_rank() % rows;
    if (j >= f.size) return;
    const int column = unknown(f.first + j);
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, f.size), [&](int i) {
      float sum = i < f.own || j < f.own ? entries(unknown(f.first + i), column) : 0.0f;
      for (int c = 0; c < 2; ++c) {
        if (f.child[c] < 0) continue;
        const LevelFront& child = fronts(f.child[c]);
        const int map = 2 * f.first + c * f.size, row = inherited(map + i), from = inherited(map + j);
        if (row >= 0 && from >= 0)
          sum += below(child.matrix + std::int64_t(from - child.first) * child.stride() + row - child.first);
      }
      level(f.matrix + std::int64_t(j) * f.stride() + i) = sum;
    });
  }
};

/// Copies the factors out of the memory of a level; what pads their columns is zero. A team is a column of a front.
struct KeepFactors {
  LevelFronts fronts;
  LevelNumbers level, factors;
  int first, rows;

  KOKKOS_FUNCTION void operator()(const LevelTeam& team) const {
    const LevelFront f = fronts(first + team.league_rank() / rows);
    const int j = team.league_rank() % rows, kept = j < f.own ? f.size : f.own;
    if (j >= f.size) return;
    const std::int64_t to =
        j < f.own ? f.lower + std::int64_t(j) * f.stride() : f.upper + std::int64_t(j - f.own) * f.upper_stride();
    const std::int64_t from = f.matrix + std::int64_t(j) * f.stride();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, LevelFront::padded(kept)),
                         [&](int i) { factors(to + i) = i < kept ? level(from + i) : 0.0f; });
  }
};

}  // namespace softwet
