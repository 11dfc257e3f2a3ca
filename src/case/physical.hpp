// A droplet on a soft layer in SI units: what `softwet units` and the table [laboratory] of a case turn into numbers of a
// case. No Kokkos.
#pragma once

#include <cmath>
#include <string>

namespace softwet {

struct PhysicalScene {
  double radius = 0;           ///< m
  double length = 0;           ///< L0, m; 0: the radius becomes 0.15
  double surface_tension = 0;  ///< N/m
  double density = 0;          ///< of the liquid, kg/m^3
  double viscosity = 0;        ///< Pa s
  double young = 0;            ///< Pa; 0: no solid
  double poisson = 0.45;
  double solid_density = 0;    ///< kg/m^3; 0: that of the liquid
  double thickness = 0;        ///< m; 0: the radius
  double solid_tension = 0;    ///< of the dry solid, N/m; 0: none
  double wet_tension = -1;     ///< of the solid below liquid, N/m; negative: that of the dry one
  double solid_viscosity = 0;  ///< of the solid, Pa s
  double temperature = 0.39;   ///< of the model fluid, over its critical temperature
  double capillarity = 0;      ///< fluid.capillarity; 0: by the half width
  double half_width = 0;       ///< of the interface, m; 0: a tenth of the droplet's radius
  double contact_angle = 0;    ///< degrees; 0: by Young's law from the tensions of the solid
};

/// What 1 means in a case, in SI units.
struct Scales {
  double length;   ///< L0, m
  double density;  ///< b, kg/m^3:            rho_l = rho_hat_l(theta) b
  double a;        ///< Pa (m^3/kg)^2:        sigma = sigma_hat(theta, gamma) a b^2 L0

  double velocity() const { return std::sqrt(a * density); }          ///< sqrt(a b), m/s
  double time() const { return length / velocity(); }                 ///< s
  double stress() const { return a * density * density; }             ///< a b^2, Pa
  double viscosity() const { return length * density * velocity(); }  ///< L0 b sqrt(a b), Pa s
};

/// What the table [laboratory] of a case comes to.
struct Laboratory {
  Scales scales;
  std::string table;  ///< its lines that set the scales; the resolved case has the other keys as numbers
};

/// A case file that `softwet units` writes.
struct WrittenCase {
  std::string path;       ///< empty: none
  bool plane = false;     ///< in 2D; else with an axis of symmetry
  bool of_paper = false;  ///< the model of the paper: its wall law, a Saint Venant-Kirchhoff solid
};

}  // namespace softwet
