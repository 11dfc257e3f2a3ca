// A scene as data: what a case file says, resolved and validated. No physics, no Kokkos.
//
// Scales (Bueno et al. 2017, eqs. 8-13): length L0, time L0/sqrt(ab), velocity sqrt(ab), density b, stress a b^2.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "case/choices.hpp"
#include "case/control.hpp"
#include "case/fluid.hpp"
#include "case/output.hpp"
#include "case/profile.hpp"
#include "case/start.hpp"
#include "case/substrate.hpp"
#include "parts/list.hpp"

namespace softwet {

/// Where elements have the length size / elements, and how they grow beside that. Lengths in L0.
struct Grading {
  FineElements fine = FineElements::everywhere;
  std::vector<double> lower, upper;  ///< corners of the box; empty: elements are equal
  double coarsest = 4;               ///< longest element over the fine ones
  double ratio = 1.3;                ///< most by which an element is longer than its neighbour
};

struct Domain {
  std::vector<double> size;   ///< extents, 2 or 3 numbers; the last axis is vertical (solid below, fluid above)
  std::vector<int> elements;  ///< elements per axis
  Coordinates coordinates = Coordinates::plane;  ///< of a 2D scene
  int degree = 2;                                ///< B-spline degree, C^(degree-1) inside each material
  Quadrature quadrature = Quadrature::full;
  Grading grading = {};

  /// Gauss points of an element along each axis.
  int points() const { return quadrature == Quadrature::reduced ? degree : degree + 1; }
};

struct Load {
  std::vector<double> lower, upper;  ///< box in reference coordinates, inside the solid
  std::vector<double> force;         ///< f_hat, eq. (13), force per unit mass
  double start = 0;                  ///< in run time, which is 0 at the beginning of the computation
  double ramp = 0;                   ///< time over which the force grows linearly to its full value
  Profile factor = 1;                ///< of the force, at the time of the results; it multiplies the ramp
  std::vector<Profile> path = {};    ///< displacement of the box over that time, one for each axis; empty: it rests
};

/// Springs that hold a box of the solid at a place that moves.
struct Needle {
  std::vector<double> lower, upper;  ///< box in reference coordinates, inside the solid: what is held
  double stiffness = 0;              ///< k of the force k (U - u) for each volume, scale a b^2/L0^2
  std::vector<Profile> path = {};    ///< U over the time of the results, one for each axis; empty: it rests

  /// Where it is along an axis; before t = 0 where it is then.
  double place(std::size_t axis, double t) const {
    return path.empty() ? 0 : path[axis].at({0, 0, 0}, std::max(t, 0.0));
  }
};

/// Sides of the patch, [axis][0: low, 1: high]. Unused axes stay at slip.
struct Boundary {
  std::array<std::array<Side, 2>, 3> side{
      {{Side::slip, Side::slip}, {Side::slip, Side::slip}, {Side::slip, Side::slip}}};
};

struct Case {
  std::string name;
  Quality quality = Quality::standard;
  Domain domain;
  std::optional<Fluid> fluid;
  std::optional<Substrate> substrate;
  std::vector<Droplet> droplets;
  std::vector<Film> films;
  std::vector<Wave> waves;
  std::optional<Initial> initial;
  std::vector<Load> loads;
  std::vector<Needle> needles;
  std::vector<Probe> probes;
  Boundary boundary;
  Parts parts;
  TimeControl time;
  SolverControl solver;
  OutputControl output;
  double wall_clock = 0;  ///< hours that a run has on the clock on the wall (time.wall_clock); 0: no limit

  /// Largest extent of an element; where they are graded, of those in the fine box.
  double spacing() const {
    double largest = 0;
    for (std::size_t d = 0; d < domain.size.size(); ++d)
      largest = std::max(largest, domain.size[d] / domain.elements[d]);
    return largest;
  }
  /// Smallest extent of an element, in the same sense.
  double shortest() const {
    double least = domain.size[0] / domain.elements[0];
    for (std::size_t d = 1; d < domain.size.size(); ++d) least = std::min(least, domain.size[d] / domain.elements[d]);
    return least;
  }
  /// Height of the undeformed wall above the bottom.
  double wall_height() const { return substrate ? substrate->thickness : 0; }
  /// Rows of elements in the solid, were all as high as at the wall. Only with a solid.
  double rows_of_solid() const { return substrate->thickness * domain.elements.back() / domain.size.back(); }
  /// Whether nothing but loads and a wall that stretches can feed the energy. The wall law "gradient" can, except at 90
  /// degrees.
  bool has_energy_law() const {
    if (has_wet_tension_by_hand()) return false;
    return !fluid || fluid->wall_law == WallLaw::energy ||
           (!fluid->contact_angle.varies() && fluid->contact_angle.number == 90) ||
           boundary.side[domain.size.size() - 1][0] == Side::periodic;
  }
  /// Whether the tension of the wall below liquid is given by hand. No energy belongs to it.
  bool has_wet_tension_by_hand() const {
    return fluid && substrate && substrate->surface_tension_wet != substrate->surface_tension;
  }
  /// Whether steps keep the energy of the tables. For an elastic solid alone with lumped or corrected masses they do
  /// not: the energy of the tables has consistent masses, and swings by the difference where a wave trades kinetic for
  /// elastic energy.
  bool keeps_shown_energy() const { return fluid || time.implicit() || time.mass == MassKind::consistent; }
  /// Area of the wall where nothing is displaced over its area before the material was stretched, a_0.
  double area_of_prestretch() const {
    double ratio = 1;
    if (substrate)
      for (const double stretch : substrate->prestretch) ratio *= axisymmetric() ? stretch * stretch : stretch;
    return ratio;
  }
  /// The cosine of the effective contact angle where nothing is displaced over the cosine of fluid.contact_angle.
  double cosine_factor() const {
    return fluid->wall_stretch_exponent == 0 ? 1 : std::pow(area_of_prestretch(), -fluid->wall_stretch_exponent);
  }
  /// Modulus that the wall energy below liquid of the surface tension 1 gives the wall along itself where it acts on
  /// the wall, over the cosine of the contact angle: beta (1 - beta) a_0^(-beta).
  double wetted_modulus() const {
    const double beta = fluid->wall_stretch_exponent;
    return fluid->wall_tension == WallTensionModel::acts ? beta * (1 - beta) * cosine_factor() : 0;
  }
  bool gives_density() const { return initial && (initial->density || !initial->from.empty()); }
  int dimension() const { return static_cast<int>(domain.size.size()); }
  bool axisymmetric() const { return domain.coordinates == Coordinates::axisymmetric; }
  /// In how many directions a droplet is curved, and one more: 2 of a disc, 3 of a ball.
  int dimension_of_droplets() const { return axisymmetric() ? 3 : dimension(); }
  /// Unit vector of the track in the plane of the wall, (x, y); in 2D along x.
  std::array<double, 2> track() const {
    if (output.track.empty()) return {1, 0};
    const double norm = std::hypot(output.track[0], output.track[1]);
    return {output.track[0] / norm, output.track[1] / norm};
  }
  /// t = run time - clock_zero(): the start of the earliest load, 0 without loads.
  double clock_zero() const {
    double zero = loads.empty() ? 0.0 : loads.front().start;
    for (const Load& load : loads) zero = load.start < zero ? load.start : zero;
    return zero;
  }
  /// Run time of the first state: the time of the first load where the scene starts from its equilibrium.
  double run_start() const { return time.start == StartState::equilibrium ? clock_zero() : 0; }
};

}  // namespace softwet
