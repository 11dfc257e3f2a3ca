// The solid below the fluid.
#pragma once

#include <vector>

#include "case/choices.hpp"
#include "case/profile.hpp"

namespace softwet {

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

/// A shear modulus G (1 + (i w time)^exponent) at the angular frequency w, where G is the modulus of the solid at rest.
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
      {};  ///< branches that the case lists; all_branches (case/gel.hpp) also has the branches of the power law
  PowerLaw gel = {};

  bool has_branches() const { return !branches.empty() || gel.acts(); }
  /// lambda_s + 2 G_s, which resists stretch of the top face along one direction.
  double modulus_of_surface() const {
    return surface_modulus.empty() ? 0 : surface_modulus[0] + 2 * surface_modulus[1];
  }
  double young_modulus() const { return density * young.least(); }  ///< E, scale a b^2; the smallest where it varies
  double shear_modulus() const { return young_modulus() / (2 * (1 + poisson)); }  ///< G, the same
};

}  // namespace softwet
