// The matrices of boxes, out of the matrix of a level.
#pragma once

#include "memory/start_teams.hpp"
#include "solver/direct/device/gauss_jordan.hpp"
#include "solver/schwarz/patches.hpp"

namespace softwet {

/// Rows of the boxes' matrices belong to one component on one line of control points of a box. A box that goes all
/// around a periodic axis closes on itself: two values may add up to one entry.
template <int D>
struct BoxRows {
  Stencil<D> stencil;
  StencilValues values;
  Kokkos::View<const int*, Exec> size, local, start, column_of;  ///< as in PatchTables
  Kokkos::View<const int*, Exec> box;                            ///< of each block
  DenseBlocks blocks;
  int sites, width;
  int round;  ///< control points once around the first axis; 0: it is not periodic

  KOKKOS_FUNCTION int lines() const { return sites / stencil.components / width; }
  KOKKOS_FUNCTION int unknown(int block, int point, int component) const {
    return local(box(block) * sites + point * stencil.components + component);
  }
  /// Sets where a line is in its box, along the axes after the first; returns its point of column 0.
  KOKKOS_FUNCTION int place_line(int block, int line, int (&at)[D]) const {
    int point = 0, stride = stencil.extent[0];
    at[0] = 0;
    for (int d = 1, rest = line; d < D; ++d) {
      at[d] = rest % width;
      rest /= width;
      point += stride * stencil.moved(start(box(block) * D + d), at[d], d);
      stride *= stencil.extent[d];
    }
    return point;
  }
};

/// An item fills the rows of all boxes that follow each other along the first axis, for their values lie side by side:
/// the way of a processor.
template <int D>
struct FillRows : BoxRows<D> {
  using Base = BoxRows<D>;
  using Base::stencil, Base::values, Base::size, Base::start, Base::column_of, Base::box, Base::blocks, Base::width,
      Base::round, Base::lines, Base::unknown;
  int together;  ///< boxes of an item

  int items(int count) const { return count / together * lines() * stencil.components; }

  KOKKOS_FUNCTION void operator()(int item) const {
    const int a = item % stencil.components, line = item / stencil.components % lines();
    const int begin = item / stencil.components / lines() * together;
    int at[D];
    const int point = this->place_line(begin, line, at);
    for (int block = begin; block < begin + together; ++block) clear(block, line, a);
    const int shifts = 2 * stencil.degree + 1;
    for (int across = 0; across < stencil.offsets; across += shifts) {
      const int to = neighbour_line(at, across);
      if (to < 0) continue;
      for (int u = 0; u < stencil.components; ++u)
        for (int o = 0; o < shifts && stencil.couples(a, u); ++o) {
          const float* entry = values.data() + stencil.index(a, u, across + o, point);
          for (int block = begin; block < begin + together; ++block)
            add(block, line * width, a, to * width, u, o - stencil.degree, entry);
        }
    }
  }
  KOKKOS_FUNCTION void clear(int block, int line, int a) const {
    const int n = size(box(block));
    for (int x = 0; x < width; ++x) {
      const int row = unknown(block, line * width + x, a);
      for (int j = 0; j < n && row >= 0; ++j) blocks(block, row, j) = 0;
    }
  }
  /// The line of a box at an offset from another.
  KOKKOS_FUNCTION int neighbour_line(const int* at, int offset) const {
    int to = 0, step = 1;
    for (int d = 1; d < D; ++d) {
      const int i = wrapped(at[d] + stencil.shift(offset, d), width, stencil.period[d]);
      if (i < 0) return -1;
      to += step * i;
      step *= width;
    }
    return to;
  }
  KOKKOS_FUNCTION void add(int block, int line, int a, int to, int u, int shift, const float* entry) const {
    const int begin = start(box(block) * D);
    for (int x = 0; x < width; ++x) {
      const int there = wrapped(x + shift, width, round);
      const int row = unknown(block, line + x, a), column = there < 0 ? -1 : unknown(block, to + there, u);
      if (row >= 0 && column >= 0) blocks(block, row, column) += entry[column_of(begin + x)];
    }
  }
};

/// A team fills the rows of one box: the way of a device. A thread finds one entry after another in the memory of the
/// team. Neighbouring threads read values that lie side by side, and afterwards write entries of a row.
template <int D>
struct FillRowsByTeams : BoxRows<D> {
  using Base = BoxRows<D>;
  using Base::stencil, Base::values, Base::size, Base::start, Base::column_of, Base::box, Base::blocks, Base::width,
      Base::round, Base::lines, Base::unknown, Base::sites;
  using Team = Teams<>::member_type;
  using Scratch = Kokkos::View<float*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;
  int items(int count) const { return count * lines() * stencil.components; }
  /// Numbers of a row in the memory of the team: odd, so that the rows begin in different banks.
  KOKKOS_FUNCTION int row_size() const { return static_cast<int>(blocks.extent(1)) | 1; }

  /// @param threads  of a team; 0: as many as suit the machine
  void run(int count, int threads = 0) const {
    const std::size_t bytes = Scratch::shmem_size(width * row_size());
    SmallTeams<128> policy(items(count), threads > 0 ? threads : team_size(128));
    start_teams("softwet::boxes", policy.set_scratch_size(0, Kokkos::PerTeam(bytes)), *this);
  }

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int a = team.league_rank() % stencil.components, line = team.league_rank() / stencil.components % lines();
    const int block = team.league_rank() / stencil.components / lines(), n = size(box(block));
    const int begin = start(box(block) * D);
    const Scratch entries(team.team_scratch(0), width * row_size());
    int at[D];
    const int point = this->place_line(block, line, at);
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, sites * width), [&](int i) {
      const int x = i % width,
                there = (x + i / width) % width;  // neighbours read along diagonals, which lie side by side
      const int u = i / width / width % stencil.components, to = i / width / width / stencil.components;
      const int column = unknown(block, to * width + there, u);
      if (column < 0 || unknown(block, line * width + x, a) < 0) return;
      int from[D];
      for (int d = 0; d < D; ++d) from[d] = at[d];
      from[0] = x;
      entries(x * row_size() + column) =
          stencil.couples(a, u) ? entry(a, u, from, there, to, point + column_of(begin + x)) : 0.0f;
    });
    team.team_barrier();
    for (int x = 0; x < width; ++x) {
      const int row = unknown(block, line * width + x, a);
      if (row < 0) continue;
      Kokkos::parallel_for(Kokkos::TeamThreadRange(team, n),
                           [&](int j) { blocks(block, row, j) = entries(x * row_size() + j); });
    }
  }

 private:
  /// Calls visit(shift) for the distances along axis d from place i of a box to place j.
  template <class Visit>
  KOKKOS_FUNCTION void for_shifts(int i, int j, int period, const Visit& visit) const {
    for (int turn = period > 0 ? -1 : 0; turn <= (period > 0 ? 1 : 0); ++turn) {
      const int shift = j - i + turn * period;
      if (shift >= -stencil.degree && shift <= stencil.degree) visit(shift + stencil.degree);
    }
  }
  /// The values of a row at a point that belong to a column, added up: `from` is the place of the row in the box;
  /// `there` and `to` are the place of the column on its line, and its line.
  KOKKOS_FUNCTION float entry(int a, int u, const int (&from)[D], int there, int to, int point) const {
    const int shifts = 2 * stencil.degree + 1;
    float sum = 0;
    for_shifts(from[D - 1], D == 3 ? to / width : to, stencil.period[D - 1], [&](int last) {
      if constexpr (D == 2) {
        for_shifts(from[0], there, round, [&](int x) { sum += values(stencil.index(a, u, last * shifts + x, point)); });
      } else {
        for_shifts(from[1], to % width, stencil.period[1], [&](int y) {
          for_shifts(from[0], there, round,
                     [&](int x) { sum += values(stencil.index(a, u, (last * shifts + y) * shifts + x, point)); });
        });
      }
    });
    return sum;
  }
};

}  // namespace softwet
