#include "scene/initial.hpp"

#include <cmath>

#include "case/cap.hpp"
#include "field/vector.hpp"
#include "kernels/fluid/interface_profile.hpp"
#include "scene/admissible.hpp"
#include "scene/equilibrium.hpp"
#include "scene/given_start.hpp"

namespace softwet {

namespace {

/// An ellipse or a box as a smooth indicator: 1 inside, 0 outside.
struct Shape {
  std::vector<double> centre, semi_axis;  ///< of an ellipse; empty for a box
  std::vector<double> lower, upper;       ///< of a box
  double density, potential;              ///< inside, and of both phases in equilibrium with it
  double density_around;
  std::vector<double> velocity;  ///< inside; empty: at rest

  double indicator(const Case& c, const double* x, const InterfaceProfile& profile) const {
    return centre.empty() ? in_box(c, x, profile) : in_ellipse(c, x, profile);
  }

 private:
  /// 1 inside, 0 outside: the profile of the interface, whose sides differ, seen from the phase that is inside.
  double step_down(double outwards, const InterfaceProfile& profile) const {
    return density < density_around ? profile.vapour(-outwards) : profile.liquid(outwards);
  }
  /// Distance from the ellipse r = 1 to first order, (r - 1) / |grad r|, r^2 = sum (x_d / s_d)^2; exact for a circle.
  double in_ellipse(const Case& c, const double* x, const InterfaceProfile& profile) const {
    double square = 0, slope = 0;
    for (std::size_t d = 0; d < centre.size(); ++d) {
      double distance = x[d] - centre[d];
      if (c.boundary.side[d][0] == Side::periodic) distance = std::remainder(distance, c.domain.size[d]);
      square += std::pow(distance / semi_axis[d], 2);
      slope += std::pow(distance / (semi_axis[d] * semi_axis[d]), 2);
    }
    if (square == 0) return 1;
    const double r = std::sqrt(square);
    return step_down((r - 1) * r / std::sqrt(slope), profile);
  }
  /// A face on a side of the fluid, or beyond it, is not an interface; around a periodic axis there is no side.
  double in_box(const Case& c, const double* x, const InterfaceProfile& profile) const {
    double inside = 1;
    for (std::size_t d = 0; d < lower.size(); ++d) {
      const double low = d + 1 == lower.size() ? c.wall_height() : 0, high = c.domain.size[d];
      const double middle = 0.5 * (lower[d] + upper[d]), half = 0.5 * (upper[d] - lower[d]);
      if (c.boundary.side[d][0] == Side::periodic) {
        if (2 * half < high - 1e-9) inside *= step_down(std::abs(std::remainder(x[d] - middle, high)) - half, profile);
        continue;
      }
      if (lower[d] > low + 1e-9) inside *= step_down(lower[d] - x[d], profile);
      if (upper[d] < high - 1e-9) inside *= step_down(x[d] - upper[d], profile);
    }
    return inside;
  }
};

/// Phases in equilibrium across a droplet's or bubble's curved interface (Kelvin, Laplace).
struct CurvedEquilibrium {
  double temperature, tension;
  Coexistence flat;
  int dimension;

  /// mu = mu_sat +- (D - 1) sigma / (R (rho_l - rho_v)), at most half way to the spinodal: below that radius there is
  /// no equilibrium and the droplet vanishes.
  double potential(double radius, double sign) const {
    const double excess = (dimension - 1) * tension / (radius * (flat.density_liquid - flat.density_vapour));
    const VanDerWaals gas{temperature, 0};
    const PhaseDensities limit = spinodal(temperature);
    const double end = sign > 0 ? gas.derivative(limit.vapour) : gas.derivative(limit.liquid);
    return flat.potential + sign * std::min(excess, 0.5 * std::abs(end - flat.potential));
  }
};

std::vector<Shape> shapes(const Case& c, const Coexistence& flat) {
  const CurvedEquilibrium curved{c.fluid->temperature, surface_tension(*c.fluid), flat, c.dimension_of_droplets()};
  const bool bubbles = c.fluid->ambient == Phase::liquid;
  std::vector<Shape> result;
  for (const Droplet& droplet : c.droplets) {
    const double potential = curved.potential(droplet.radius, bubbles ? -1 : 1);
    const PhaseDensities rho = densities_at(c.fluid->temperature, potential);
    Shape s{
        droplet.centre,  std::vector<double>(c.dimension(), droplet.radius), {}, {}, rho.liquid, potential, rho.vapour,
        droplet.velocity};
    if (bubbles) std::swap(s.density, s.density_around);
    for (std::size_t d = 0; d < droplet.stretch.size(); ++d) s.semi_axis[d] *= droplet.stretch[d];
    if (sits_on_wall(c, droplet)) s.centre.back() -= s.semi_axis.back() * cap_cosine(c, droplet);
    result.push_back(s);
  }
  for (const Film& film : c.films)
    result.push_back({{}, {}, film.lower, film.upper, flat.density_liquid, flat.potential, flat.density_vapour, {}});
  return result;
}

/// The medium around the shapes: in equilibrium with the largest droplet, else with a flat interface.
Shape surroundings(const Case& c, const Coexistence& flat, const std::vector<Shape>& all) {
  Shape around{};
  const bool liquid = c.fluid->ambient == Phase::liquid;
  around.density_around = liquid ? flat.density_liquid : flat.density_vapour;
  around.potential = flat.potential;
  double largest = 0;
  for (std::size_t k = 0; k < c.droplets.size(); ++k)
    if (c.droplets[k].radius > largest) {
      largest = c.droplets[k].radius;
      around = all[k];
    }
  if (!c.fluid->initial.empty()) around.density_around = c.fluid->initial[liquid ? 1 : 0];
  return around;
}

/// The part of each shape at a point, shape by shape as visit(shape, part). Together they are at most 1.
template <class Visit>
void at_parts(const Case& c, const std::vector<Shape>& all, const InterfaceProfile& profile, const double* x,
              const Visit& visit) {
  double cover = 0;
  for (const Shape& shape : all) {
    const double part = std::min(shape.indicator(c, x, profile), 1 - cover);
    visit(shape, part);
    cover += part;
  }
}

/// Moving droplets: the sum of velocity times part. The solid, which has the wall in common with the fluid, stays at
/// rest.
template <int D>
void fill_velocity(const Case& c, const Layout<D>& l, const std::vector<Shape>& all, const InterfaceProfile& profile,
                   std::vector<double>& unknown) {
  const int first = c.substrate ? l.wall_row + 1 : l.wall_row;
  at_samples(l, first, l.rows - first, [&](int i, const double* x, double weight) {
    at_parts(c, all, profile, x, [&](const Shape& shape, double part) {
      for (std::size_t d = 0; d < shape.velocity.size(); ++d)
        unknown[l.velocity_offset(d) + first * l.row_size + i] += weight * (part * shape.velocity[d]);
    });
  });
}

template <int D>
void fill_fluid(const Case& c, const Layout<D>& l, const Coexistence& flat, std::vector<double>& unknown) {
  const std::vector<Shape> all = shapes(c, flat);
  const Shape around = surroundings(c, flat, all);
  const InterfaceProfile profile(VanDerWaals{c.fluid->temperature, 0}, flat, c.fluid->capillarity);
  at_samples(l, l.wall_row, l.fluid_rows(), [&](int i, const double* x, double weight) {
    double rho = around.density_around;
    at_parts(c, all, profile, x, [&](const Shape& shape, double part) {
      const bool liquid = shape.density > shape.density_around;
      const double inside = c.fluid->initial.empty() ? shape.density : c.fluid->initial[liquid ? 1 : 0];
      rho += (inside - around.density_around) * part;
    });
    unknown[l.density_offset() + i] += weight * rho;
    unknown[l.potential_offset() + i] = around.potential;
  });
  fill_velocity(c, l, all, profile, unknown);
}

/// Adds the wave to a component; `own` is the direction of a vector's component, -1 for the density.
template <int D>
void add_wave(const Case& c, const Layout<D>& l, const Wave& wave, int own, int first, int rows, double* values) {
  at_samples(l, first, rows, [&](int i, const double* x, double weight) {
    double value = wave.amplitude;
    for (int d = 0; d < D; ++d) {
      const double phase = wave.mode[d] * M_PI * x[d] / c.domain.size[d];
      value *= d == own && wave.mode[d] != 0 ? std::sin(phase) : std::cos(phase);
    }
    values[i] += weight * value;
  });
}

template <int D>
void add_waves(const Case& c, const Layout<D>& l, std::vector<double>& unknown, std::vector<double>& displacement) {
  for (const Wave& wave : c.waves) {
    const int own = axis_of(wave.field);
    if (wave.field == WaveField::density) {
      add_wave(c, l, wave, own, l.wall_row, l.fluid_rows(), &unknown[l.density_offset()]);
    } else if (is_velocity(wave.field)) {
      add_wave(c, l, wave, own, 0, l.rows, &unknown[l.velocity_offset(own)]);
    } else {
      add_wave(c, l, wave, own, 0, l.solid_rows(), &displacement[l.displacement_offset(own)]);
    }
  }
}

template <int D>
std::vector<double> density_of(const Layout<D>& l, const std::vector<double>& unknown) {
  return {unknown.begin() + l.density_offset(), unknown.begin() + l.potential_offset()};
}

}  // namespace

template <int D, int P>
State initial_state(const Case& c, const Scene<D, P>& scene) {
  const Layout<D>& l = scene.layout();
  State state = empty_state(l);
  std::vector<double> unknown(l.size(), 0.0), displacement(l.solid_size(), 0.0);
  if (l.has_fluid) fill_fluid(c, l, scene.coefficients().coexistence(), unknown);
  if (c.initial && c.initial->earlier) give_earlier(*c.initial->earlier, l, unknown, displacement);
  if (c.initial && l.has_fluid) give_fluid(*c.initial, l, unknown);
  if (c.initial && l.has_solid) give_solid(c, l, displacement);
  const std::vector<double> without_waves = density_of(l, unknown);
  add_waves(c, l, unknown, displacement);
  if (l.has_fluid) require_density(c, l, without_waves, density_of(l, unknown));
  state.unknown = to_device<Array>(unknown, "state.unknown");
  state.displacement = to_device<Array>(displacement, "state.displacement");
  multiply(Kokkos::subview(state.unknown, Kokkos::make_pair(0, l.velocity_size())),
           part(scene.mask(), 0, l.velocity_size()));
  require_upright(c, l, scene.balance(), state);
  return state;
}

template State initial_state(const Case&, const Scene<SOFTWET_DIMENSION, SOFTWET_DEGREE>&);

}  // namespace softwet
