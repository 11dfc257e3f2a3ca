#include "model/initial.hpp"

#include <cmath>

#include "model/equilibrium.hpp"

namespace softwet {

namespace {

/// One droplet as a smooth indicator: 1 inside, 0 outside.
struct Profile {
  std::vector<double> centre;
  double radius, half_width, density_inside, density_outside, potential;

  double indicator(const double* x) const {
    double r2 = 0;
    for (std::size_t d = 0; d < centre.size(); ++d) r2 += (x[d] - centre[d]) * (x[d] - centre[d]);
    return 0.5 * (1 - std::tanh((std::sqrt(r2) - radius) / half_width));
  }
};

template <int D, int P>
std::vector<Profile> profiles(const Case& c, const Model<D, P>& model) {
  const Coexistence& s = model.state();
  const double jump = s.density_liquid - s.density_vapour, middle = 0.5 * (s.density_liquid + s.density_vapour);
  const double sigma = c.fluid->capillarity * surface_tension_over_capillarity(c.fluid->temperature);
  const VanDerWaals gas{c.fluid->temperature, 0};
  const double excess = gas.energy(middle) - s.potential * middle + s.pressure;
  const double half_width = 0.5 * jump * c.fluid->capillarity / std::sqrt(2 * excess);
  std::vector<Profile> result;
  for (const Droplet& droplet : c.droplets) {
    const double potential = s.potential + (D - 1) * sigma / (droplet.radius * jump);
    const PhaseDensities rho = densities_at(c.fluid->temperature, potential);
    Profile p{droplet.centre, droplet.radius, half_width, rho.liquid, rho.vapour, potential};
    if (std::abs(p.centre[D - 1] - model.wall_height()) < 1e-9)
      p.centre[D - 1] -= droplet.radius * std::cos(c.fluid->contact_angle * M_PI / 180);
    result.push_back(p);
  }
  return result;
}

}  // namespace

template <int D, int P>
State initial_state(const Case& c, const Model<D, P>& model) {
  const Layout<D>& l = model.layout();
  State state = empty_state(l);
  if (!l.has_fluid) return state;
  const std::vector<Profile> droplets = profiles(c, model);
  std::vector<double> x(l.size(), 0.0);
  double outside = model.state().density_vapour, potential = model.state().potential, largest = 0;
  for (const Profile& p : droplets)
    if (p.radius > largest) {
      largest = p.radius;
      outside = p.density_outside;
      potential = p.potential;
    }
  for (int i = 0; i < l.scalar_size(); ++i) {
    // Control value = profile at the Greville point: a positive approximation, so the vapour cannot undershoot.
    double point[D];
    int rest = i;
    for (int d = 0; d < D; ++d) {
      const int n = d < D - 1 ? l.axis[d].functions() : l.fluid_rows();
      point[d] = l.axis[d].greville(rest % n + (d == D - 1 ? l.wall_row : 0));
      rest /= n;
    }
    double rho = outside, cover = 0;
    for (const Profile& p : droplets) {
      const double phi = std::min(p.indicator(point), 1 - cover);
      rho += (p.density_inside - outside) * phi;
      cover += phi;
    }
    x[l.density_offset() + i] = rho;
    x[l.potential_offset() + i] = potential;
  }
  state.unknown = to_device<Array>(x, "state.unknown");
  return state;
}

template State initial_state(const Case&, const Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>&);

}  // namespace softwet
