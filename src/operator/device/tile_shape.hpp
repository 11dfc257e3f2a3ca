// Tiles: how many elements a team of threads of a device takes at once.
#pragma once

#include "operator/device/team_bounds.hpp"
#include "spline/region.hpp"

namespace softwet {

/// Threads for so many points, when `lanes` of each 16 have one.
constexpr int slots_of(int points, int lanes) { return points / lanes * 16 + points % lanes; }

/// NX x NY elements across the wall, M times L layers of them. The team computes L layers in a pass, with one thread
/// for each quadrature point. Along each axis a tile has as many control points as elements, and `degree` more. An
/// element has QL points along the last axis: one on a wall. With `Shared` all layers, which are passed one by one,
/// have the same test functions along the last axis. With `own_slopes` slopes are swept from control values; else they
/// follow from the values at the points of an element, which needs degree + 1 of them along an axis.
template <int D_, int P_, int NX_, int NY_, int L_, int M_, int Q_ = P_ + 1, int QL_ = Q_, bool Shared_ = false,
          bool own_slopes_ = false, bool dense_ = false>
struct TileShape {
  static constexpr int D = D_, P = P_, n = P + 1, Q = Q_, QL = QL_;
  static constexpr bool Shared = Shared_, own_slopes = own_slopes_, dense = dense_;
  static constexpr int NX = NX_, NY = D == 3 ? NY_ : 1, L = L_, M = M_, NZ = L * M;
  static constexpr int qx = Q * NX, qy = D == 3 ? Q * NY : 1, qz = QL * L;         ///< points of a pass along the axes
  static constexpr int base = qx * qy, points = base * qz, lines = qy * qz;        ///< lines of points along x
  static constexpr int cx = NX + P, cy = D == 3 ? NY + P : 1, cz = L + P;          ///< control points of a pass
  static constexpr int planes = Shared ? n : NZ + P, controls = cx * cy * planes;  ///< of the tile
  /// So many of 16 consecutive threads have a point (share_points). In 3D no line of points of an element then lies in
  /// two such groups, and the numbers that they read of their neighbours lie in different banks of the memory. With
  /// `dense` all threads have a point, since Kokkos keeps some memory for each thread.
  static constexpr int lanes = D == 3 && !own_slopes && !dense ? 16 / Q * Q : 16;
  static constexpr int threads = lanes == 16 ? points : (slots_of(points, lanes) + 31) / 32 * 32;
  static_assert(QL == Q || NZ == 1, "a wall has one layer of elements");
  static_assert(!Shared || L == 1, "layers with the same test functions are passed one by one");
  static_assert(own_slopes ? L == 1 : Q == n, "slopes need values at degree + 1 points, or sweeps of one layer");

  static constexpr int width(int d) { return d == 0 ? NX : d == D - 1 ? NZ : NY; }
  static constexpr int team(int) { return threads; }  ///< threads of a team with so many bytes of scratch
};

/// The tile of a residual or, with Tangent, of a product, in a volume; `teams` of them should fit on a multiprocessor.
/// The scratch of a team stays below 48 kB, which every device gives. Where a multiprocessor has no room for so many,
/// fewer share it (team_bounds.hpp).
template <int D, int P, bool Tangent, class Real>
struct ChosenTile;
template <bool Tangent, class Real>
struct ChosenTile<2, 2, Tangent, Real> : TileShape<2, 2, 7, 1, 4, 4> {
  static constexpr int teams = Tangent && std::is_same_v<Real, double> ? 2 : 3;
};
template <bool Tangent, class Real>
struct ChosenTile<2, 3, Tangent, Real> : TileShape<2, 3, 4, 1, 4, 2> {
  static constexpr int teams = 2;
};
/// Whether all numbers of a product are in double precision.
template <bool Tangent, class Real>
inline constexpr bool double_product = Tangent ? std::is_same_v<Real, double> : false;
template <bool Tangent, class Real>
struct ChosenTile<3, 2, Tangent, Real>
    : TileShape<3, 2, 3, 2, 1, 4, 3, 3, false, false, double_product<Tangent, Real>> {
  static constexpr int teams = double_product<Tangent, Real> ? 2 : 4;
};
template <bool Tangent, class Real>
struct ChosenTile<3, 3, Tangent, Real> : TileShape<3, 3, 2, 1, 1, 4> {
  static constexpr int teams = 2;
};

/// Elements of a tile whose slopes are swept, with Q points along an axis. Two points, as in reduced quadrature at
/// degree 2, fill whole warps.
template <int D, int Q>
inline constexpr int slope_tile_width = D == 2 ? 128 / (Q * Q) : 6 - Q;
template <int Q>
inline constexpr int slope_tile_depth = Q == 2 ? 2 : 1;

/// Such a tile. With two points along an axis the residuals of explicit steps have registers enough for so many teams
/// of a thread for each point; with more a multiprocessor should have 512 threads, or 128 registers for each. Where the
/// scratch leaves room for many teams of two points, half as many threads have two points each, which share what they
/// read, and what leads to a tile is done by fewer warps; in 3D that is one warp, which waits for no other.
template <int D, int P, int Q>
struct SlopeTileShape : TileShape<D, P, slope_tile_width<D, Q>, slope_tile_depth<Q>, 1, 4, Q, Q, false, true> {
  using Base = TileShape<D, P, slope_tile_width<D, Q>, slope_tile_depth<Q>, 1, 4, Q, Q, false, true>;
  static constexpr int whole_warps = (Base::points + 31) / 32 * 32, many = D == 2 ? 10 : 12;
  static constexpr int team(int bytes) {
    constexpr int half = Base::points / 2;
    return Q == 2 && half % multiprocessor.warp == 0 && teams_that_fit(half, bytes) >= many ? half : Base::points;
  }
  static constexpr int teams = Q > 2 ? 512 / whole_warps : D == 2 ? 5 : 8;
  static_assert(Q != 2 || whole_warps == Base::points, "no thread of a warp is idle");
};

// Tiles of other terms, for teams of the same size, so that one launch computes them all.
/// One layer of elements, for terms next to the wall.
template <class T>
using LayerOf = TileShape<T::D, T::P, T::NX * T::L, T::NY, 1, 1, T::Q, T::Q, false, T::own_slopes, T::dense>;
/// Elements on the wall; most threads of a team have no point there.
template <class T>
using WallOf = TileShape<T::D, T::P, T::NX * T::L, T::NY, 1, 1, T::Q, 1, false, T::own_slopes, T::dense>;
/// Layers above each other with the same test functions.
template <class T>
using SharedOf = TileShape<T::D, T::P, T::NX * T::L, T::NY, 1, T::NZ, T::Q, T::Q, true, T::own_slopes, T::dense>;

/// The elements of a region in tiles: where these begin, how many elements they have, and how many tiles there are
/// along each axis. Along the first axis tiles begin at multiples of their width of the whole axis, wherever it is cut
/// among processes, so that all sums have the same order. The first `lead` elements of the first tile are then none of
/// the region.
template <int D>
struct TileGrid {
  int first[D], elements[D], tiles[D], lead;

  template <class Shape, class Real>
  static TileGrid of(const Region<D, Real>& region, const ElementRun& run) {
    TileGrid g;
    g.lead = (run.begin + run.shift) % Shape::width(0);
    for (int d = 0; d < D; ++d) {
      g.first[d] = d == 0 ? run.begin - g.lead : 0;
      g.elements[d] = d == 0 ? run.end - g.first[d] : region.axis[d].elements;
      g.tiles[d] = (g.elements[d] + Shape::width(d) - 1) / Shape::width(d);
    }
    return g;
  }
  int count() const {
    int n = 1;
    for (int d = 0; d < D; ++d) n *= tiles[d];
    return n;
  }
  /// First element of a tile along each axis, from the begin of the grid.
  template <class Shape>
  KOKKOS_FORCEINLINE_FUNCTION void corner(int tile, int (&element)[D]) const {
    unsigned above = static_cast<unsigned>(tile);
    for (int d = 0; d + 1 < D; ++d) {
      const unsigned along = static_cast<unsigned>(tiles[d]);
      element[d] = static_cast<int>(above % along) * Shape::width(d);
      above /= along;
    }
    element[D - 1] = static_cast<int>(above) * Shape::width(D - 1);
  }
};

}  // namespace softwet
