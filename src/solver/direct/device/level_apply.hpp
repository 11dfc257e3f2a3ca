// Kernels that apply the factors of a level of fronts to a vector.
#pragma once

#include "field/range_factors.hpp"
#include "solver/direct/device/level_build.hpp"

namespace softwet {

/// The product of a strip of rows with a vector, in a team. Its columns are dealt out to `parts` sums of each row,
/// which are added in their order. So results do not depend on the threads of a team.
struct StripProduct {
  using Scratch = Kokkos::View<float*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
  static constexpr int columns_at_once = 1024;
  static constexpr int lanes = team_size(LevelStrip::rows), lane_rows = LevelStrip::rows / lanes;

  Scratch head, sum;  ///< some numbers of the vector; [part][row]
  int parts;

  KOKKOS_FUNCTION StripProduct(const LevelTeam& team, int part_count)
      : head(team.team_scratch(0), columns_at_once),
        sum(team.team_scratch(0), part_count * LevelStrip::rows),
        parts(part_count) {}
  static std::size_t scratch_bytes(int parts) {
    return Scratch::shmem_size(columns_at_once) + Scratch::shmem_size(parts * LevelStrip::rows);
  }

  /// @param matrix  the first of the strip's rows; vector(j) are the numbers that columns are multiplied with
  template <class Vector>
  KOKKOS_FUNCTION void multiply(const LevelTeam& team, const float* matrix, int stride, int columns,
                                const Vector& vector) const {
    int first = 0;
    do {
      const int count = columns - first < columns_at_once ? columns - first : columns_at_once;
      Kokkos::parallel_for(Kokkos::TeamVectorRange(team, count), [&](int j) { head(j) = vector(first + j); });
      team.team_barrier();
      Kokkos::parallel_for(Kokkos::TeamThreadRange(team, parts), [&](int part) {
        Kokkos::parallel_for(Kokkos::ThreadVectorRange(team, lanes), [&](int lane) {
          add(matrix + std::int64_t(first) * stride + lane * lane_rows, stride, count, part, lane,
              first == 0 ? SumStart::zero : SumStart::as_it_is);
        });
      });
      team.team_barrier();
      first += columns_at_once;
    } while (first < columns);
  }
  KOKKOS_FUNCTION float row(int i) const {
    float total = 0;
    for (int part = 0; part < parts; ++part) total += sum(part * LevelStrip::rows + i);
    return total;
  }

 private:
  enum class SumStart { zero, as_it_is };
  KOKKOS_FUNCTION void add(const float* matrix, int stride, int count, int part, int lane, SumStart start) const {
    constexpr int together = 8;  // columns that are fetched at once
    float total[lane_rows] = {};
    const auto add_column = [&](int j) {
      const float factor = head(j), *column = matrix + std::int64_t(j) * stride;
      for (int r = 0; r < lane_rows; ++r) total[r] += column[r] * factor;
    };
    int j = part;
    for (; j + (together - 1) * parts < count; j += together * parts)
      for (int k = 0; k < together; ++k) add_column(j + k * parts);
    for (; j < count; j += parts) add_column(j);
    float* to = &sum(part * LevelStrip::rows + lane * lane_rows);
    for (int r = 0; r < lane_rows; ++r) to[r] = start == SumStart::zero ? total[r] : to[r] + total[r];
  }
};

/// What both ways through the tree know. Vectors of GMRES are of the precision Real.
template <class Real>
struct LevelVectors {
  LevelFronts fronts;
  LevelInts unknown, inherited;
  LevelNumbers factors, row_scale, column_scale;
  LevelNumbers results;   ///< [first + i] A^-1 times the right side for own unknowns, and what is left for the border
  LevelNumbers solution;  ///< [unknown] of the scaled matrix
  ConstArrayOf<Real> r;
  ArrayOf<Real> z;
  RangeFactors factor;  ///< of the answer

  KOKKOS_FORCEINLINE_FUNCTION void solve(int i, float value) const {
    solution(i) = value;
    z(i) = static_cast<Real>(factor.at(i) * value * column_scale(i));
  }
};

/// Towards the root: the right side of a front has its own unknowns and the remainders of its children. Fronts without
/// a border are solved in this pass. A team is a strip of rows.
template <class Real>
struct ForwardStrips {
  LevelVectors<Real> v;
  Kokkos::View<const LevelStrip*, Exec> strips;
  int parts;

  KOKKOS_FUNCTION void operator()(const LevelTeam& team) const {
    const LevelStrip strip = strips(team.league_rank());
    const LevelFront f = v.fronts(strip.front);
    const StripProduct product(team, parts);
    product.multiply(team, v.factors.data() + f.lower + strip.row, f.stride(), f.own, [&](int j) {
      const int i = v.unknown(f.first + j);
      return static_cast<float>(v.r(i) * v.row_scale(i)) + from_below(f, j);
    });
    const int rows = f.size - strip.row < LevelStrip::rows ? f.size - strip.row : LevelStrip::rows;
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, rows), [&](int i) {
      const int row = strip.row + i;
      const float value = row < f.own ? product.row(i) : from_below(f, row) - product.row(i);
      v.results(f.first + row) = value;
      if (f.border() == 0) v.solve(v.unknown(f.first + row), value);
    });
  }
  KOKKOS_FUNCTION float from_below(const LevelFront& f, int row) const {
    float sum = 0;
    for (int c = 0; c < 2; ++c) {
      const int at = v.inherited(2 * f.first + c * f.size + row);
      if (at >= 0) sum += v.results(at);
    }
    return sum;
  }
};

/// Towards the leaves: own unknowns from the unknowns of the border. A team is a strip of own rows. The teams behind
/// the strips copy prescribed values and ghosts, one for each piece of their list.
template <class Real>
struct BackwardStrips {
  static constexpr int piece = 256;
  LevelVectors<Real> v;
  Kokkos::View<const LevelStrip*, Exec> strips;
  int parts;
  LevelInts held;  ///< on the last level

  int teams() const {
    return static_cast<int>(strips.extent(0)) + (static_cast<int>(held.extent(0)) + piece - 1) / piece;
  }

  KOKKOS_FUNCTION void operator()(const LevelTeam& team) const {
    const int behind = team.league_rank() - static_cast<int>(strips.extent(0));
    if (behind >= 0) return copy_held(team, behind * piece);
    const LevelStrip strip = strips(team.league_rank());
    const LevelFront f = v.fronts(strip.front);
    const StripProduct product(team, parts);
    product.multiply(team, v.factors.data() + f.upper + strip.row, f.upper_stride(), f.border(),
                     [&](int j) { return v.solution(v.unknown(f.first + f.own + j)); });
    const int rows = f.own - strip.row < LevelStrip::rows ? f.own - strip.row : LevelStrip::rows;
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, rows), [&](int i) {
      const int at = f.first + strip.row + i;
      v.solve(v.unknown(at), v.results(at) + product.row(i));
    });
  }
  KOKKOS_FUNCTION void copy_held(const LevelTeam& team, int first) const {
    const int left = static_cast<int>(held.extent(0)) - first, count = left < piece ? left : piece;
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, count), [&](int i) {
      const int at = held(first + i);
      v.z(at) = static_cast<Real>(v.factor.at(at) * v.r(at));
    });
  }
};

}  // namespace softwet
