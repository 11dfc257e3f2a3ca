// Where a team keeps the numbers of a tile with slopes of its own, and its bases.
#pragma once

#include "operator/device/tile_plan.hpp"

namespace softwet {

/// What channels have of integrands: one against values, and one against the slopes along each axis. Along the first
/// axis these two are folded to one number.
template <class Test, int D>
struct SlopeChannels {
  static constexpr int channels = Test::channel_count;
  static constexpr bool has_value(int c) { return channel_has_value<Test>(c); }
  static constexpr bool has_flux(int c) { return channel_has_flux<Test>(c); }

  /// Sums over the channels before channel c.
  static constexpr int values_before(int c) { return unpacked(values, c); }
  static constexpr int fluxes_before(int c) { return unpacked(fluxes, c); }
  static constexpr int numbers_before(int c) { return values_before(c) + D * fluxes_before(c); }
  static constexpr int folded_before(int c) { return c + (D - 1) * fluxes_before(c); }

 private:
  template <class Has>
  static constexpr Packed counted(const Has& has) {
    return packed<channels + 1>([&](int c) {
      int count = 0;
      for (int i = 0; i < c; ++i) count += has(i) ? 1 : 0;
      return count;
    });
  }
  static constexpr Packed values = counted(has_value), fluxes = counted(has_flux);

 public:
  static constexpr int all_values = unpacked(values, channels), all_fluxes = unpacked(fluxes, channels);
  static constexpr int numbers = all_values + D * all_fluxes, folded = channels + (D - 1) * all_fluxes;
  /// Channels that have both, and whether all of them have the same.
  static constexpr int with_both = all_values + all_fluxes - channels;
  static constexpr bool alike = with_both == channels || all_values == 0 || all_fluxes == 0;

  /// Folded number k: the first of its integrands, and whether these are against values, slopes, or values and then
  /// slopes.
  enum Kind { of_values, of_slopes, of_both };
  static constexpr bool few = folded < 16 && numbers < 16;  ///< so that they can be packed
  static constexpr int first_of(int k) { return unpacked(firsts, k); }
  static constexpr int kind_of(int k) { return unpacked(kinds, k); }

 private:
  static constexpr int channel_of(int k) {
    int c = 0;
    while (folded_before(c + 1) <= k) ++c;
    return c;
  }
  static constexpr int listed = few ? folded : 0;
  static constexpr Packed firsts = packed<listed>([](int k) {
    const int c = channel_of(k), d = k - folded_before(c);
    return numbers_before(c) + d + (d > 0 && has_value(c) ? 1 : 0);
  });
  static constexpr Packed kinds = packed<listed>([](int k) {
    const int c = channel_of(k), d = k - folded_before(c);
    return d > 0 || !has_flux(c) ? of_values : has_value(c) ? of_both : of_slopes;
  });
};

/// Where a team keeps its numbers; offsets in Reals. After the sweeps across, a field with slopes has its value and its
/// slopes along all axes but the first. In 3D integrands that were folded along x replace the swept values. Numbers are
/// spaced such that neighbouring threads, which go on to the next field or channel, find them in other banks of the
/// memory.
template <class Plan>
struct SlopeRooms {
  using Shape = typename Plan::Shape;
  using Channels = SlopeChannels<typename Plan::Test, Shape::D>;
  static constexpr int D = Shape::D;
  static constexpr bool three = D == 3;
  static constexpr int max(int a, int b) { return a > b ? a : b; }
  static constexpr int columns = Shape::cx * Shape::cy;
  static constexpr int line_points = Shape::lines * Shape::cx;  ///< of lines along x
  static constexpr int apart = line_points + (three ? Shape::NY * Shape::cx / D : 0);
  static constexpr int swept_all = (Plan::fields + (D - 1) * Plan::stored) * apart;
  static constexpr int folded_apart = three ? line_points + Shape::cx / D : 0;
  static constexpr int folded_all = Channels::folded * folded_apart;
  static constexpr int wall_y = three ? Plan::wall_fields * 2 * Shape::qy * Shape::cx : 0;

  /// Integrands are [number][point], where channels are folded number by number, and else have some room behind each
  /// channel.
  static constexpr bool by_number = Channels::few && (Channels::with_both == 0 || Plan::channels == 1);
  static constexpr int number = Shape::points + (three && by_number ? Shape::lines : 0);
  static constexpr int behind = three && !by_number ? Shape::lines : 0;
  static constexpr int integrand(int c) { return Channels::numbers_before(c) * number + c * behind; }
  static constexpr int at_points = Channels::numbers * number + Plan::channels * behind;
  /// In 3D, the place of the points of x among the points of a line, as in PointNumbers.
  static constexpr int place(int x) { return x % Shape::Q * Shape::NX + x / Shape::Q; }

  static constexpr int first_room = max(swept_all, folded_all);
  static constexpr int second_room = max(at_points, wall_y - first_room);
  static constexpr int swept = 0, folded = 0, integrands = first_room, wall = integrands + second_room;
  static constexpr int to_pairs =
      (wall + Plan::wall_numbers * Shape::base) % 2;  ///< pairs of numbers begin at even places
  static constexpr int tables = wall + Plan::wall_numbers * Shape::base + to_pairs;
};
template <class Plan>
struct SlopeScratch : SlopeRooms<Plan>, TileTables<Plan, SlopeRooms<Plan>::tables> {
  using TileTables<Plan, SlopeRooms<Plan>::tables>::three;
};

/// A function of an element at a point: its value, and behind it its slope.
template <class Real>
struct alignas(2 * sizeof(Real)) ValueAndSlope {
  Real value, slope;
};

/// Values and slopes of the functions of an element at one point.
template <int n, class Real>
struct PointBasis {
  Real value[n], slope[n];

  PointBasis() = default;
  /// Reads the basis of point i from a table.
  KOKKOS_FORCEINLINE_FUNCTION PointBasis(const Real* table, int i) {
    SOFTWET_UNROLL
    for (int a = 0; a < n; ++a) {
      const auto f = at(table, i, a);
      value[a] = f.value;
      slope[a] = f.slope;
    }
  }
  static KOKKOS_FORCEINLINE_FUNCTION ValueAndSlope<Real> at(const Real* table, int i, int a) {
    return reinterpret_cast<const ValueAndSlope<Real>*>(table)[i * n + a];
  }
  /// sum_a basis[a] from[a stride]
  static KOKKOS_FORCEINLINE_FUNCTION Real sum(const Real (&basis)[n], const Real* from, int stride) {
    Real total = basis[0] * from[0];
    SOFTWET_UNROLL
    for (int a = 1; a < n; ++a) total = total + basis[a] * from[a * stride];
    return total;
  }
};

}  // namespace softwet
