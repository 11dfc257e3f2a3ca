// A droplet on a soft layer in SI units: what `softwet units` turns into the numbers of a case. No physics, no Kokkos.
#pragma once

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
  double capillarity = 0;      ///< fluid.capillarity; 0: a tenth of the droplet's radius
};

}  // namespace softwet
