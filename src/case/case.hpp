// A scene as data: what a case file says, resolved and validated. No physics, no Kokkos.
//
// Scales (Bueno et al. 2017, eqs. 8-13): length L0, time L0/sqrt(ab), velocity sqrt(ab), density b, stress a b^2.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/choices.hpp"
#include "case/profile.hpp"

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

struct Fluid {
  double viscosity = 0;        ///< mu_hat, eq. (9)
  double capillarity = 0;      ///< gamma_hat, eq. (8)
  double temperature = 0;      ///< theta_hat, eq. (10)
  Profile contact_angle = 90;  ///< degrees, measured in the liquid, at the points of the wall
  WallLaw wall_law = WallLaw::gradient;
  WallTensionModel wall_tension = WallTensionModel::none;
  double wall_stretch_exponent =
      0;  ///< beta: the wall has the energy a^(1 - beta) f_w for each area before any stretch
  Traction traction = Traction::layer;
  std::vector<double> gravity;    ///< force per unit mass on the fluid, scale a b/L0; empty: none
  double stabilisation = 0.002;   ///< C of eps = C h^2 rho^2 / mu_hat; 0 switches the checkerboard control off
  double smoothing = 1e-4;        ///< d of sqrt(|grad rho|^2 + d^2) in the wall law "gradient"
  Phase ambient = Phase::vapour;  ///< what is around the droplets; liquid makes them bubbles
  std::vector<double> initial;    ///< densities of vapour and liquid at the start; empty: those of the equilibrium

  std::vector<double> contact_angle_range = {};  ///< receding and advancing angle, degrees; empty: no hysteresis
  double line_friction = 0;                      ///< mu_f, scale L0 b sqrt(ab)
  double creep_speed = 1e-4;                     ///< below which a line with hysteresis counts as at rest

  /// Half of cos(receding) - cos(advancing).
  double hysteresis() const {
    if (contact_angle_range.size() != 2) return 0;
    return 0.5 * (std::cos(contact_angle_range[0] * M_PI / 180) - std::cos(contact_angle_range[1] * M_PI / 180));
  }
  /// The angle whose cosine is the mean of those of the range, degrees.
  double middle_of_range() const {
    return std::acos(std::cos(contact_angle_range[0] * M_PI / 180) - hysteresis()) * 180 / M_PI;
  }
  /// Whether a contact line loses energy as it moves, beside what the viscosity takes.
  bool resists_lines() const { return line_friction > 0 || !contact_angle_range.empty(); }
};

/// Parallel fibres in the solid, straight in its undeformed state.
struct Fibre {
  double stiffness = 0;  ///< k of k/2 (I_4 - 1)^2, scale a b^2; 0: none
  double angle = 0;      ///< degrees, from the plane of the wall towards the vertical
  double azimuth = 0;    ///< degrees, in the plane of the wall from x; in 3D
};

/// A spring in series with a dashpot, beside the elasticity of the solid (Maxwell). It acts in shear alone.
struct Branch {
  double modulus = 0;  ///< G_i, scale a b^2
  double time = 0;     ///< tau_i in which its stress fades, scale L0/sqrt(ab)
};

/// A shear modulus G (1 + (i w time)^exponent) at the angular frequency w, with that of the solid at rest, G.
struct PowerLaw {
  double exponent = 0;                    ///< 0: none
  double time = 0;                        ///< scale L0/sqrt(ab)
  std::vector<double> decades = {-2, 2};  ///< of w time in which it holds

  bool acts() const { return exponent > 0; }
};

struct Substrate {
  double thickness = 0;  ///< Hs; a whole number of element rows
  double density = 1;    ///< rho_0^s / b
  Profile young = 0;     ///< E_hat, eq. (12): Young modulus / (rho_0^s a b)
  double joint = 0;      ///< height at which stiffness may jump; 0: none
  double poisson = 0;    ///< nu
  MaterialModel material = MaterialModel::saint_venant_kirchhoff;
  Strain strain = Strain::finite;
  Inertia inertia = Inertia::full;
  VolumeQuadrature volume_quadrature = VolumeQuadrature::full;
  std::vector<double> prestretch = {};  ///< along x, and y in 3D, before the scene begins; empty: none

  double viscosity = 0;                      ///< eta of Kelvin and Voigt, scale L0 b sqrt(ab)
  double bulk_viscosity = 0;                 ///< zeta
  double surface_tension = 0;                ///< of the dry top face, scale a b^2 L0
  double surface_tension_wet = 0;            ///< below liquid
  std::vector<double> surface_modulus = {};  ///< lambda_s and G_s of the top face, scale a b^2 L0; empty: none
  std::vector<double> gravity = {};          ///< force per unit mass on all of the solid, a b/L0; empty: none
  Fibre fibre = {};
  std::vector<Branch> branches =
      {};  ///< those that the case lists; all_branches (case/gel.hpp) has those of the power law too
  PowerLaw gel = {};

  bool has_branches() const { return !branches.empty() || gel.acts(); }
  /// lambda_s + 2 G_s, which resists stretch of the top face along one direction.
  double modulus_of_surface() const {
    return surface_modulus.empty() ? 0 : surface_modulus[0] + 2 * surface_modulus[1];
  }
  double young_modulus() const { return density * young.least(); }  ///< E, scale a b^2; the smallest where it varies
  double shear_modulus() const { return young_modulus() / (2 * (1 + poisson)); }  ///< G, the same
};

struct Droplet {
  std::vector<double> centre;  ///< of the circle or sphere; on the interface it becomes a cap cut at the contact angle
  double radius = 0;
  std::vector<double> stretch = {};   ///< semi-axes over the radius; empty: 1 along each axis
  std::vector<double> velocity = {};  ///< of its liquid at the start; empty: at rest
};

/// A box of liquid at the start.
struct Film {
  std::vector<double> lower, upper;
};

/// amplitude prod_d cos(mode_d pi x_d / L_d), added to a field at the start; sin along the field's own direction.
struct Wave {
  WaveField field = WaveField::density;
  double amplitude = 0;
  std::vector<double> mode;
};

struct EarlierState;  // scene/earlier_state.hpp

/// The state at the start where it is given at each point, in place of what droplets and films make.
struct Initial {
  std::string from;                             ///< output folder of an earlier run; empty: none
  std::vector<double> time;                     ///< of the field files of that run; empty: its last checkpoint
  std::shared_ptr<const EarlierState> earlier;  ///< that run, read where a run begins (run/earlier_run.hpp)
  std::optional<Profile> density;
  std::vector<Profile> velocity, displacement;  ///< one for each axis, or empty
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
  std::vector<double> foundation = {};  ///< springs kap_n and kap_t below the solid, scale a b^2/L0; empty: none
  std::vector<double> foundation_damping = {};  ///< dashpots c_n and c_t beside them, scale b sqrt(ab); empty: none
};

struct TimeControl {
  TimeScheme scheme = TimeScheme::generalized_alpha;
  bool automatic = false;               ///< generalized_alpha or kick_drift, whichever takes less time
  MassKind mass = MassKind::corrected;  ///< of explicit schemes
  double safety = 0.9;                  ///< of explicit schemes: step over the largest stable one
  StartState start = StartState::initial;
  double rho_inf = 0.5;
  double end = 0;  ///< in t, the time of all results, which is 0 at the start of the first load
  double dt_initial = 1e-2;
  double dt_min = 1e-8;
  double dt_max = 50;
  double tolerance = 2e-3;  ///< of the error indicator that sets the step (src/time/step_control.hpp)
  long max_steps = 1000000;

  bool implicit() const { return scheme == TimeScheme::generalized_alpha; }
};

struct SolverControl {
  double newton_rtol = 1e-3;
  double newton_atol = 1e-10;
  int newton_max = 10;
  double newton_undershoot = 0.05;  ///< by which a control value of the density may fall below 0
  double krylov_rtol = 1e-2;
  int krylov_restart = 30;
  int krylov_max = 200;
  JacobianKind jacobian = JacobianKind::exact;
  PreconditionerKind preconditioner = PreconditionerKind::automatic;
  Launch launch = Launch::kernels;
  PrecisionChoice precision = PrecisionChoice::automatic;
};

/// A number of each row of history.csv: of a quantity at a point, on a line, a face or in a box of the undeformed domain.
struct Probe {
  std::string name;           ///< of the column
  std::string quantity;       ///< one of probe_quantities() (observe/host/probe_quantity.hpp)
  std::vector<double> point;  ///< L0; empty: a box is given
  std::vector<double> lower,
      upper;  ///< corners, equal along an axis where the box has no extent; empty: a point is given
  ProbeOperation operation = ProbeOperation::value;

  const std::vector<double>& low() const { return point.empty() ? lower : point; }
  const std::vector<double>& high() const { return point.empty() ? upper : point; }
};

struct OutputControl {
  int history_every = 1;
  std::vector<double> track;  ///< 3D: horizontal direction along which droplets are followed; empty: x
  std::vector<double> field_times;
  double field_every = 0;                 ///< interval from t = 0 on; 0: none
  std::vector<std::string> field_select;  ///< names of fields (observe/host/field_table.hpp); empty: all
  double checkpoint_minutes = 10;
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
  /// Whether nothing but loads and a wall that stretches can feed the energy. The wall law "gradient" can, except at 90 degrees.
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
  /// Whether the energy of the tables is the one that steps keep. Of an elastic solid alone with lumped or corrected masses it is not: it
  /// has consistent masses, and swings by the difference where a wave trades kinetic for elastic energy.
  bool keeps_shown_energy() const { return fluid || time.implicit() || time.mass == MassKind::consistent; }
  /// Area of the wall where nothing is displaced over that of the material before its prestretch, a_0.
  double area_of_prestretch() const {
    double ratio = 1;
    if (substrate)
      for (const double stretch : substrate->prestretch) ratio *= axisymmetric() ? stretch * stretch : stretch;
    return ratio;
  }
  /// The cosine of the effective contact angle where nothing is displaced over that of fluid.contact_angle.
  double cosine_factor() const {
    return fluid->wall_stretch_exponent == 0 ? 1 : std::pow(area_of_prestretch(), -fluid->wall_stretch_exponent);
  }
  /// Modulus that the wall energy below liquid of the surface tension 1 gives the wall along itself where it acts on the wall, over
  /// the cosine of the contact angle: beta (1 - beta) a_0^(-beta).
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
  /// Run time of the first state: that of the first load where the scene starts from its equilibrium.
  double run_start() const { return time.start == StartState::equilibrium ? clock_zero() : 0; }
};

}  // namespace softwet
