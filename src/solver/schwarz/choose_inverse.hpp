// The kernel that compares the matrices of boxes with inverses of other boxes.
#pragma once

#include "memory/start_teams.hpp"
#include "solver/direct/device/gauss_jordan.hpp"
#include "solver/schwarz/box_inverses.hpp"

namespace softwet {

/// For each box the closest inverse of its candidates, see SharedInverses. A team takes a box and its candidates one
/// after another; a row of its matrix is the work of one thread's lanes, which are as many for any number of threads.
struct ChooseInverse {
  static constexpr int most_candidates = 8, probes = 2;
  template <class Number>
  using Rows = Kokkos::View<Number**, Kokkos::LayoutRight, Exec>;

  DenseBlocks matrices;
  BoxInverses inverses;
  BlockSizes size;                  ///< [kind] unknowns of a box
  Rows<const int> field;            ///< [kind][unknown of the box]
  Rows<const float> probe;          ///< [probe][unknown] random signs
  Rows<const int> question;         ///< [block] the kind, and the candidates; -1 behind them
  Kokkos::View<int*, Exec> answer;  ///< [block] number of the candidate; -1: none
  float limit;
  int fields;

  using Policy = Teams<Kokkos::Schedule<Kokkos::Dynamic>, Kokkos::LaunchBounds<256, 4>>;
  using Team = Policy::member_type;
  using Scratch = Kokkos::View<float*, Exec::scratch_memory_space, Kokkos::MemoryTraits<Kokkos::Unmanaged>>;

  /// One vector for each probe.
  struct Vectors {
    Scratch all;
    int rows;
    KOKKOS_FUNCTION Vectors(const Team& team, int rows_) : all(team.team_scratch(0), probes * rows_), rows(rows_) {}
    KOKKOS_FUNCTION float* of(int p) const { return all.data() + p * rows; }
  };
  /// What the threads of a team share.
  struct Room {
    Scratch size_of_row;
    Vectors r, x, y;
    Scratch distance;
    KOKKOS_FUNCTION Room(const Team& team, int rows, int fields)
        : size_of_row(team.team_scratch(0), rows),
          r(team, rows),
          x(team, rows),
          y(team, rows),
          distance(team.team_scratch(0), fields) {}
    static std::size_t bytes(int rows, int fields) {
      return Scratch::shmem_size(rows) + 3 * Scratch::shmem_size(probes * rows) + Scratch::shmem_size(fields);
    }
  };

  /// @param threads  of a team; 0: as many as suit the machine
  void run(int count, int threads) const {
    if (threads == 0) threads = team_size(8);
    const std::size_t bytes = Room::bytes(static_cast<int>(probe.extent(1)), fields);
    start_teams("softwet::share",
                Policy(count, threads, team_size(32)).set_chunk_size(1).set_scratch_size(0, Kokkos::PerTeam(bytes)),
                *this);
  }

  KOKKOS_FUNCTION void operator()(const Team& team) const {
    const int block = team.league_rank(), n = size(question(block, 0));
    const Room room(team, static_cast<int>(probe.extent(1)), fields);
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, n), [&](int i) {
      float largest = 0;
      Kokkos::parallel_reduce(
          Kokkos::ThreadVectorRange(team, n),
          [&](int j, float& most) { most = Kokkos::max(most, Kokkos::abs(matrices(block, i, j))); },
          Kokkos::Max<float>(largest));
      Kokkos::single(Kokkos::PerThread(team), [&] { room.size_of_row(i) = largest; });
    });
    team.team_barrier();
    float least = limit;
    int found = -1;
    for (int k = 0; k < most_candidates && question(block, 1 + k) >= 0; ++k) {
      const float d = distance(team, room, n, question(block, 1 + k));
      if (!(d < least)) continue;
      least = d;
      found = k;
    }
    Kokkos::single(Kokkos::PerTeam(team), [&] { answer(block) = found; });
  }
  /// Largest |A_c^-1 A_b x - x|_f / |x|_f of the probes; not a number where the inverse has entries that are none. Each
  /// entry of a matrix that is read serves all probes.
  KOKKOS_FUNCTION float distance(const Team& team, const Room& room, int n, int candidate) const {
    const int block = team.league_rank();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, n), [&](int i) {
      for (int p = 0; p < probes; ++p) room.r.of(p)[i] = probe(p, i) * room.size_of_row(i);
    });
    multiply_inverse(team, candidate, n, room.r, room.x);
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, n), [&](int i) {
      for (int p = 0; p < probes; ++p) {
        const float* const x = room.x.of(p);
        float product = 0;
        Kokkos::parallel_reduce(
            Kokkos::ThreadVectorRange(team, n), [&](int j, float& sum) { sum += matrices(block, i, j) * x[j]; },
            product);
        Kokkos::single(Kokkos::PerThread(team), [&] { room.r.of(p)[i] = product; });
      }
    });
    multiply_inverse(team, candidate, n, room.r, room.y);
    float largest = 0;
    for (int p = 0; p < probes; ++p) {
      compare_fields(team, room, p, n);
      for (int f = 0; f < fields; ++f) {
        if (Kokkos::isnan(room.distance(f))) return room.distance(f);
        largest = Kokkos::max(largest, room.distance(f));
      }
      team.team_barrier();  // all have read them
    }
    return largest;
  }
  /// to = inverse times x. All threads have written x, and may read the result.
  KOKKOS_FUNCTION void multiply_inverse(const Team& team, int box, int n, const Vectors& x, const Vectors& to) const {
    team.team_barrier();
    Kokkos::parallel_for(Kokkos::TeamVectorRange(team, chunks_in(n, rows_at_once)), [&](int piece) {
      const int first = piece * rows_at_once;
      const float* from[probes];
      for (int p = 0; p < probes; ++p) from[p] = x.of(p);
      float sum[probes][rows_at_once];
      inverses.multiply<probes>(box, n, first, from, sum);
      for (int p = 0; p < probes; ++p)
        for (int i = 0; i < rows_at_once && first + i < n; ++i) to.of(p)[first + i] = sum[p][i];
    });
    team.team_barrier();
  }
  /// |y - x|_f / |x|_f
  KOKKOS_FUNCTION void compare_fields(const Team& team, const Room& room, int p, int n) const {
    const int kind = question(team.league_rank(), 0);
    const float *const x = room.x.of(p), *const y = room.y.of(p);
    Kokkos::parallel_for(Kokkos::TeamThreadRange(team, fields), [&](int f) {
      float difference = 0, length = 0;
      Kokkos::parallel_reduce(
          Kokkos::ThreadVectorRange(team, n),
          [&](int i, float& sum) {
            if (field(kind, i) == f) sum += (y[i] - x[i]) * (y[i] - x[i]);
          },
          difference);
      Kokkos::parallel_reduce(
          Kokkos::ThreadVectorRange(team, n),
          [&](int i, float& sum) {
            if (field(kind, i) == f) sum += x[i] * x[i];
          },
          length);
      Kokkos::single(Kokkos::PerThread(team),
                     [&] { room.distance(f) = difference == 0 ? 0.0f : Kokkos::sqrt(difference / length); });
    });
    team.team_barrier();
  }
};

}  // namespace softwet
