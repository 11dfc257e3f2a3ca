// Fluid, wall and solid of a scene from the numbers of a case.
#include "scene/coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case/error.hpp"
#include "case/text.hpp"
#include "field/ranks.hpp"
#include "field/vector.hpp"
#include "scene/beside_joint.hpp"
#include "scene/equilibrium.hpp"
#include "scene/fluid_of.hpp"
#include "scene/greville_points.hpp"
#include "scene/line_friction.hpp"
#include "scene/prestretch.hpp"

namespace softwet {
namespace {

/// A wall whose tension is not positive folds.
void require_tension(const Fluid& fluid, double dry, double largest_cosine) {
  const double gain = (1 - fluid.wall_stretch_exponent) * surface_tension(fluid) * largest_cosine;
  if (dry > gain) return;
  throw Error(Exit::invalid_input, "fluid.wall_tension = \"acts\": below liquid the wall would have the tension " +
                                       short_text(dry - gain) + ", substrate.surface_tension = " + short_text(dry) +
                                       " less what it gains by being wetted; a tension that is not positive folds the "
                                       "wall: write a surface_tension above " +
                                       short_text(gain));
}

/// A wall whose energy below liquid grows less than its area has a negative modulus, and short waves along it grow.
void require_modulus(const Case& c, double least_cosine) {
  const double loss = c.wetted_modulus() * surface_tension(*c.fluid) * -least_cosine / c.cosine_factor();
  if (c.substrate->modulus_of_surface() >= loss) return;
  throw Error(Exit::invalid_input,
              "fluid.wall_stretch_exponent = " + short_text(c.fluid->wall_stretch_exponent) +
                  ": below liquid that the wall repels its energy grows less than its area, which takes the modulus " +
                  short_text(loss) +
                  " from a surface with lambda_s + 2 G_s = " + short_text(c.substrate->modulus_of_surface()) +
                  "; a modulus that is negative lets short waves along the wall grow: write a "
                  "substrate.surface_modulus with lambda_s + 2 G_s of " +
                  short_text(loss) + " or more, or fluid.wall_tension = \"none\"");
}

/// The field that has the same values on all rows that live on the wall.
template <int D>
GivenField<double> on_wall(const Layout<D>& layout, const std::vector<double>& of_row) {
  const int row = layout.has_solid ? layout.wall_row : 0;
  std::vector<double> values;
  for (int k = 0; k <= layout.axis[D - 1].degree(); ++k) values.insert(values.end(), of_row.begin(), of_row.end());
  return {to_device<Array>(values, "given"), row * layout.row_size};
}

template <int D>
WallCoefficients wall_of(const Case& c, const Layout<D>& layout, const NavierStokesKorteweg& fluid,
                         const Coexistence& state) {
  WallCoefficients wall;
  wall.feeds = layout.has_solid && c.fluid->wall_tension == WallTensionModel::none;
  const Profile angle = c.fluid->contact_angle;
  const auto cosine = [factor = c.cosine_factor()](double degrees) {
    return degrees == 90.0 ? 0.0 : factor * std::cos(degrees * M_PI / 180.0);
  };
  const double uniform = angle.varies() ? 1 : cosine(angle.number);
  wall.energy = WallEnergy::of({c.fluid->capillarity, uniform, 1e-5, fluid.gas, state});
  if (layout.rate_rows > 0) wall.friction = line_friction_of(*c.fluid, wall.law());
  std::vector<double> cosines = control_values(layout, angle, layout.has_solid ? layout.wall_row : 0, 1);
  for (double& x : cosines) x = cosine(x);
  if (angle.varies()) wall.cosines = on_wall(layout, cosines);
  wall.stretch_exponent = c.fluid->wall_stretch_exponent;
  if (wall.stretch_exponent > 0) {
    wall.cosines = on_wall(layout, cosines);
    wall.energy = wall.of_cosine_one();
  }
  if (!layout.has_solid) return wall;
  const double dry = c.substrate->surface_tension, wet = c.substrate->surface_tension_wet;
  if (c.fluid->wall_tension == WallTensionModel::acts) {
    require_tension(*c.fluid, dry, ranks::largest(*std::max_element(cosines.begin(), cosines.end())));
    require_modulus(c, -ranks::largest(-*std::min_element(cosines.begin(), cosines.end())));
    wall.tension = on_wall(layout, cosines);
  } else if (wet != dry) {
    std::fill(cosines.begin(), cosines.end(), (wet - dry) / wall.of_cosine_one().value(state.density_liquid));
    wall.tension = on_wall(layout, cosines);
  }
  return wall;
}

/// At a joint the parts below and above have their own values, each the limit from its side.
template <int D>
void grade(const Profile& young, const Layout<D>& layout, SolidCoefficients& solid) {
  const Axis& vertical = layout.axis[D - 1];
  const int parts = vertical.joint() > 0 ? 2 : 1;
  std::vector<double> values[2];
  solid.largest_young = 0;
  for (int part = 0; part < parts; ++part) {
    const auto in_part = [&](std::array<double, 3> x) {
      x[D - 1] = height_in_part(vertical, part, x[D - 1]);
      return young.at(x);
    };
    values[part] = control_values(layout, in_part, 0, layout.solid_rows());
    solid.largest_young = std::max(solid.largest_young, *std::max_element(values[part].begin(), values[part].end()));
  }
  solid.largest_young = ranks::largest(solid.largest_young);
  for (int part = 0; part < parts; ++part) {
    for (double& x : values[part]) x /= solid.largest_young;
    solid.graded[part] = {to_device<Array>(values[part], "given"), 0};
  }
}

Solid law_of_solid(const Substrate& s, const LameParameters& stiffness) {
  const double density = s.inertia == Inertia::none ? 0.0 : s.density;
  if (s.strain == Strain::small) return Elastodynamics<Hooke>{{stiffness}, density};
  if (s.material == MaterialModel::neo_hookean) return Elastodynamics<NeoHookean>{{stiffness}, density};
  return Elastodynamics<SaintVenantKirchhoff>{{stiffness}, density};
}

template <int D>
SolidCoefficients solid_of(const Case& c, const Layout<D>& layout) {
  SolidCoefficients solid;
  const Substrate& s = *c.substrate;
  solid.young = s.young;
  solid.largest_young = s.young.number;
  // One kernel serves stiffness that varies, prestretch and selective integration, so that there is no further kernel.
  if (s.young.varies() || !s.prestretch.empty() || s.volume_quadrature == VolumeQuadrature::selective)
    grade(s.young, layout, solid);
  solid.stiffness = LameParameters::from(s.density * solid.largest_young, s.poisson);
  solid.law = law_of_solid(s, solid.stiffness);
  solid.prestretch = prestretch_of(c, solid.stiffness);
  solid.fibres = fibres_of(s, D).after(solid.prestretch);
  solid.branches = branches_of(s);
  solid.rates = solid_rates(c);
  return solid;
}

}  // namespace

WallEnergy WallCoefficients::of_cosine_one() const {
  EnergyWall law = energy.law;
  law.cosine = 1;
  return WallEnergy::of(law);
}

Matrix<double, 3> SolidCoefficients::first_piola(const Matrix<double, 3>& grad_u,
                                                 const std::array<double, 3>& x) const {
  const Matrix<double, 3> whole = prestretch.whole(grad_u);
  Matrix<double, 3> p =
      std::visit([&](const auto& solid) { return prestretch.first_piola(solid.material.first_piola(whole)); }, law);
  if (young.varies()) p = (young.at(x) / largest_young) * p;
  if (fibres.stiffness > 0) p = p + fibres.residual(SolidStrain<double, 3>{grad_u}).momentum_flux;
  return p;
}

template <int D>
Coefficients<D>::Coefficients(const Regions<D>& regions, const Case& c) {
  const Layout<D>& layout = regions.layout();
  if (layout.has_solid) solid_ = solid_of(c, layout);
  if (!layout.has_fluid) return;
  coexistence_ = softwet::coexistence(c.fluid->temperature);
  fluid_ = fluid_of(*c.fluid, coexistence_, layout.shortest());
  wall_ = wall_of(c, layout, fluid_, coexistence_);
}

template class Coefficients<2>;
template class Coefficients<3>;

}  // namespace softwet
