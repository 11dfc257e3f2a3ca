// What a term needs in a tile, counted when the program is compiled, and where a team keeps it.
#pragma once

#include "operator/device/tile_shape.hpp"
#include "operator/device/wall_below.hpp"
#include "operator/task.hpp"

namespace softwet {

/// A term in a tile. Values of fields with gradients are stored for the whole team; other values stay with their point.
template <class Shape_, class Term_, class Motion_, bool Tangent_, class Real_>
struct TilePlan : TrialFields<typename Term_::template Trial<double, Shape_::D>, Shape_::D, Tangent_>,
                  WallFields<Shape_::D, Motion_, Tangent_> {
  using Shape = Shape_;
  using Term = Term_;
  using Motion = Motion_;
  using Real = Real_;
  static constexpr bool Tangent = Tangent_;
  static constexpr int D = Shape::D;
  using Fields = TrialFields<typename Term::template Trial<double, D>, D, Tangent>;
  using Fields::fields;
  using S = OneNumber<Real>;
  using N = std::conditional_t<Tangent, Dual<S>, S>;
  using Trial = typename Term::template Trial<N, D>;
  using Test = typename Term::template Test<N, D>;
  static constexpr bool on_wall = Shape::QL == 1;
  /// Axes along which slopes follow from the values at the points of an element: not across a wall.
  static constexpr int collocated = on_wall ? D - 1 : D;
  static constexpr int channels = Test::channel_count;
  /// A product in double precision in 3D has no room for more than it needs.
  static constexpr bool tight = D == 3 && Tangent && sizeof(Real) == 8;

  /// Number of fields with gradients before one.
  static constexpr int stored_before(int field) { return unpacked(places_stored, field); }

 private:
  static constexpr Packed places_stored = packed<fields + 1>([](int field) {
    int count = 0;
    for (int f = 0; f < field; ++f) count += Fields::has_gradient(f) ? 1 : 0;
    return count;
  });

 public:
  static constexpr int stored = unpacked(places_stored, fields);
};

/// Tables of the bases [point][function], of weights and of positions, and of shares [element], from `begin` on; the
/// sums of a tile follow, or the sums of the planes that a pass leaves to the next one. Where sweeps make slopes, the
/// value and the slope of a function are adjacent; on other walls there are slopes across them. The place of a control
/// value is a sum of integers: one of the element (or, where sweeps make slopes, of the control point) along the first
/// axis, and one of the control point along each other axis. These integers lie in the tables, and so do the numbers of
/// a Blend at the heights of the points. Where slopes follow from values, the tables also have the rows for slopes
/// [point][point of the element, itself first], unless memory is tight.
template <class Plan, int begin>
struct TileTables {
  using Shape = typename Plan::Shape;
  static constexpr bool three = Shape::D == 3, own = Shape::own_slopes;
  static constexpr int zs = Shape::QL * Shape::NZ;                 ///< points of the tile along the last axis
  static constexpr int functions = own ? 2 * Shape::n : Shape::n;  ///< numbers of the functions at a point
  static constexpr int x_size = Shape::qx * functions, y_size = three ? Shape::qy * functions : 0,
                       z_size = zs * functions;

  static constexpr int x = begin, y = x + x_size, z = y + y_size, test = z + z_size, x_weight = test + z_size;
  static constexpr int y_weight = x_weight + Shape::qx, z_weight = y_weight + (three ? Shape::qy : 0);
  static constexpr int x_place = z_weight + zs, y_place = x_place + Shape::qx;
  static constexpr int z_place = y_place + (three ? Shape::qy : 0), z_slope = z_place + zs;
  static constexpr int x_share = z_slope + (Plan::on_wall && !own ? z_size : 0);
  static constexpr int y_share = x_share + (own ? 0 : Shape::NX), z_share = y_share + (three && !own ? Shape::NY : 0);
  static constexpr bool knows_blend = !Plan::tight && Plan::moves, knows_rows = !Plan::tight && !own;
  static constexpr int blend = z_share + (own ? 0 : Shape::NZ), blend_slope = blend + (knows_blend ? zs : 0);
  static constexpr int x_row = blend_slope + knows_blend, y_row = x_row + (knows_rows ? Shape::qx * Shape::Q : 0);
  static constexpr int z_row = y_row + (three && knows_rows ? Shape::qy * Shape::Q : 0);
  static constexpr int places = z_row + (knows_rows && !Plan::on_wall ? zs * Shape::Q : 0);
  static constexpr int y_places = own ? Shape::cx : Shape::NX;  ///< among the integers
  static constexpr int z_places = y_places + (three ? Shape::cy : 0);
  static constexpr int integers = z_places + Shape::NZ + Shape::P, in_one = sizeof(typename Plan::Real) / sizeof(int);
  static constexpr int sums = places + (integers + in_one - 1) / in_one;
  static constexpr int planes = !own ? Shape::planes : Shape::Shared ? Shape::n : Shape::P;
  static constexpr int channel_sums =
      planes * Shape::cx * Shape::cy + (own && three ? Shape::cx : 0);  ///< of a channel
  static constexpr int size = sums + Plan::channels * channel_sums;
};

/// Where a team keeps its numbers; offsets in Reals. In 2D two rooms are used alternately: the second holds the numbers
/// swept along x, the first values, the second fluxes, the first the points folded along x, and the second their folds
/// along z.
///
/// In 3D numbers at points come first: values, and later integrands. The numbers that a point keeps for itself follow:
/// the values of fields without gradients and slopes across a wall, and later its fluxes along y and z, and along x.
/// Numbers swept along x and numbers folded along z and y use the place of fluxes along x, which are read first; so the
/// next pass is swept along x while this one is folded. Where memory is tight they use the places of all fluxes, and
/// the next pass waits.
template <class Plan>
struct TileRooms {
  using Shape = typename Plan::Shape;
  static constexpr bool three = Shape::D == 3;
  static constexpr int max(int a, int b) { return a > b ? a : b; }
  static_assert(!three || Shape::L == 1, "in 3D a pass is one layer");
  static constexpr int x_swept = Shape::cz * Shape::cy * Shape::qx, z_folded = Shape::cz * Shape::base;
  /// The banks of the memory, and a count of at least `numbers` such that in 3D a line of points of the next field or
  /// channel begins in the bank behind the end of the previous line. Threads that go along x from line to line of
  /// different fields then have no bank in common.
  static constexpr int banks = 128 / sizeof(typename Plan::Real);
  static constexpr int apart(int numbers) {
    return three && !Plan::tight ? numbers + (banks + (Shape::qx - numbers) % banks) % banks : numbers;
  }
  static constexpr int field = apart(x_swept), point_field = apart(Shape::points);  ///< from one field to the next
  static constexpr int sweep_x = Plan::fields * field;
  static constexpr int values = Plan::stored * point_field, folded = Plan::channels * point_field;
  static constexpr int of_points = max(values, folded), of_flux = Plan::Test::has_flux ? folded : 0;  ///< along an axis
  static constexpr int wall_x = Plan::wall_fields * Shape::cy * Shape::qx;

  // In 3D:
  static constexpr int kept = values, across = Plan::fields - Plan::stored;  ///< fields that a point keeps
  static constexpr int kept_end = kept + (across + (Plan::on_wall ? Plan::fields : 0)) * point_field;
  static constexpr int flux = of_points, flux_x = flux + (Plan::collocated - 1) * of_flux;
  static constexpr int swept = Plan::tight ? kept_end : max(kept_end, flux_x), folded_zy = max(swept + sweep_x, flux_x);
  static constexpr int in_3d = max(max(folded_zy + Plan::channels * field, flux_x + of_flux), wall_x);

  // In 2D:
  static constexpr int all_fluxes = Shape::D * of_flux, z_folded_all = Plan::channels * z_folded;
  static constexpr int in_2d = max(max(sweep_x, all_fluxes), z_folded_all);
  static constexpr int first = 0, second = of_points, wall = three ? in_3d : second + in_2d;
  static constexpr int tables = wall + Plan::wall_numbers * Shape::base;
};
template <class Plan>
struct TileScratch : TileRooms<Plan>, TileTables<Plan, TileRooms<Plan>::tables> {
  using TileTables<Plan, TileRooms<Plan>::tables>::three;
};

/// Derivatives at the points of an element of the Lagrange polynomials through them. They give the slopes of a spline
/// from its values, since it is a polynomial of degree Q - 1 there. The rows are rotated so that a point's own entry
/// comes first: forward[d][q][r] = l'_{q+r}(x_q), transposed[d][q][r] = l'_q(x_{q+r}), indices modulo Q. They hold for
/// the shortest element of an axis; for another element they are multiplied by its share, the shortest length over its
/// own.
template <int D, int Q, class Real>
struct Collocation {
  Real forward[D][Q][Q], transposed[D][Q][Q];

  static Collocation of(const double (&spacing)[D]) {
    const std::vector<double> x = Gauss(Q).point;
    Collocation c;
    for (int i = 0; i < Q; ++i)
      for (int j = 0; j < Q; ++j) {
        const double slope = lagrange_slope(x, j, i);
        for (int d = 0; d < D; ++d) {
          c.forward[d][i][(j - i + Q) % Q] = static_cast<Real>(slope / spacing[d]);
          c.transposed[d][j][(i - j + Q) % Q] = static_cast<Real>(slope / spacing[d]);
        }
      }
    return c;
  }
  /// l'_j(x_i)
  static double lagrange_slope(const std::vector<double>& x, int j, int i) {
    double sum = 0;
    for (int k = 0; k < Q; ++k) {
      if (k == j) continue;
      double term = 1 / (x[j] - x[k]);
      for (int l = 0; l < Q; ++l)
        if (l != j && l != k) term *= (x[i] - x[l]) / (x[j] - x[l]);
      sum += term;
    }
    return sum;
  }
};

}  // namespace softwet
