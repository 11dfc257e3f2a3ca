// What the equations of a scene have in them: the numbers of fluid, wall and solid, and those that are given at each
// point.
#pragma once

#include <array>
#include <variant>

#include "kernels/fluid/line_friction.hpp"
#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "kernels/fluid/wall_energy.hpp"
#include "kernels/solid/elastodynamics.hpp"
#include "kernels/solid/hooke.hpp"
#include "kernels/solid/neo_hookean.hpp"
#include "kernels/solid/prestretch.hpp"
#include "kernels/solid/saint_venant_kirchhoff.hpp"
#include "scene/given_field.hpp"
#include "scene/regions.hpp"
#include "scene/solid_rates.hpp"

namespace softwet {

/// Coefficients of the wall that the fluid wets.
struct WallCoefficients {
  WallEnergy energy;           ///< its law has capillarity and cosine of the gradient law too
  GivenField<double> cosines;  ///< of the contact angle; empty where it does not vary and the wall has no exponent
  GivenField<double>
      tension;  ///< that the fluid gives the wall, over the wall energy of the cosine 1; empty where it gives none
  double stretch_exponent = 0;  ///< of the energy in the stretch of the wall
  LineFriction friction;        ///< of contact lines; only where Layout::rate_rows > 0
  bool feeds = false;           ///< whether the motion of a soft wall feeds the energy

  /// Where the cosine varies it is 1.
  const EnergyWall& law() const { return energy.law; }
  WallEnergy of_cosine_one() const;
};

using Solid = std::variant<Elastodynamics<SaintVenantKirchhoff>, Elastodynamics<Hooke>, Elastodynamics<NeoHookean>>;

struct SolidCoefficients {
  Solid law;                 ///< where the stiffness varies in space, where it is largest
  LameParameters stiffness;  ///< stiffness of `law`
  GivenField<double> graded
      /// Stiffness over the stiffness of `law`, below and above a joint; empty where the law has a kernel of its own.
      [2];
  Prestretch prestretch;  ///< of the material; `fibres` include their own
  Fibres fibres;          ///< of stiffness 0 where there are none
  Branches branches;      ///< none, or those of a viscoelastic solid
  SolidRates rates;
  Profile young;
  double largest_young = 0;

  double density() const {
    return std::visit([](const auto& solid) { return solid.density; }, law);
  }
  /// First Piola-Kirchhoff stress of the material, as stiff as it is at the point x of the undeformed solid, and of its
  /// fibres, with the prestretch; without its viscosity and its branches. On the host. In 2D Grad u has the third axis
  /// too.
  Matrix<double, 3> first_piola(const Matrix<double, 3>& grad_u, const std::array<double, 3>& x) const;
};

template <int D>
class Coefficients {
 public:
  /// Errors: invalid_input where a wall would have no tension or a negative modulus, or a prestretch no free face.
  Coefficients(const Regions<D>&, const Case&);

  const Coexistence& coexistence() const { return coexistence_; }  ///< of liquid and vapour
  const NavierStokesKorteweg& fluid() const { return fluid_; }
  const WallCoefficients& wall() const { return wall_; }
  const SolidCoefficients& solid() const { return solid_; }

 private:
  SolidCoefficients solid_;
  Coexistence coexistence_;
  NavierStokesKorteweg fluid_;
  WallCoefficients wall_;
};

}  // namespace softwet
