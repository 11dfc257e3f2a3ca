// Fluid, wall and solid of a model from the numbers of a case.
#include <algorithm>
#include <cmath>

#include "case/error.hpp"
#include "case/text.hpp"
#include "field/ranks.hpp"
#include "field/vector.hpp"
#include "scene/beside_joint.hpp"
#include "scene/fluid_of.hpp"
#include "scene/greville_points.hpp"
#include "scene/line_friction.hpp"
#include "scene/model.hpp"
#include "scene/prestretch.hpp"
#include "scene/solid_rates.hpp"

namespace softwet {
namespace {

/// A wall whose tension is not positive folds.
void require_tension(const Fluid& fluid, double dry, double largest_cosine) {
  const double gain = (1 - fluid.wall_stretch_exponent) * surface_tension(fluid) * largest_cosine;
  if (dry > gain) return;
  throw Error(Exit::invalid_input,
              "fluid.wall_tension = \"acts\": below liquid the wall would have the tension " + short_text(dry - gain) +
                  ", substrate.surface_tension = " + short_text(dry) +
                  " less what it gains by being wetted; a tension that is not positive folds the wall: write a "
                  "surface_tension above " +
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

}  // namespace

template <int D, int P>
void Model<D, P>::build_fluid(const Case& c) {
  coexistence_ = coexistence(c.fluid->temperature);
  const double h = layout_.shortest();
  fluid_ = fluid_of(*c.fluid, coexistence_, h);
  for (const double force : fluid_.force) has_gravity_ = has_gravity_ || force != 0;
  has_wall_ = c.boundary.side[D - 1][0] != Side::periodic;
  build_wall(c);
}

template <int D, int P>
void Model<D, P>::build_wall(const Case& c) {
  wall_feeds_ = layout_.has_solid && c.fluid->wall_tension == WallTensionModel::none;
  const Profile angle = c.fluid->contact_angle;
  const auto cosine = [factor = c.cosine_factor()](double degrees) {
    return degrees == 90.0 ? 0.0 : factor * std::cos(degrees * M_PI / 180.0);
  };
  const double uniform = angle.varies() ? 1 : cosine(angle.number);
  wall_ = WallEnergy::of({c.fluid->capillarity, uniform, 1e-5, fluid_.gas, coexistence_});
  if (layout_.rate_rows > 0) line_friction_ = line_friction_of(*c.fluid, wall_.law);
  std::vector<double> cosines = control_values(layout_, angle, layout_.has_solid ? layout_.wall_row : 0, 1);
  for (double& x : cosines) x = cosine(x);
  if (angle.varies()) painted_ = on_wall(cosines);
  wall_stretch_exponent_ = c.fluid->wall_stretch_exponent;
  if (wall_stretch_exponent_ > 0) {
    painted_ = on_wall(cosines);
    wall_ = wall_of_one();
  }
  if (!layout_.has_solid) return;
  const double dry = c.substrate->surface_tension, wet = c.substrate->surface_tension_wet;
  if (c.fluid->wall_tension == WallTensionModel::acts) {
    require_tension(*c.fluid, dry, ranks::largest(*std::max_element(cosines.begin(), cosines.end())));
    require_modulus(c, -ranks::largest(-*std::min_element(cosines.begin(), cosines.end())));
    tension_ = on_wall(cosines);
  } else if (wet != dry) {
    std::fill(cosines.begin(), cosines.end(), (wet - dry) / wall_of_one().value(coexistence_.density_liquid));
    tension_ = on_wall(cosines);
  }
}

template <int D, int P>
WallEnergy Model<D, P>::wall_of_one() const {
  EnergyWall law = wall_.law;
  law.cosine = 1;
  return WallEnergy::of(law);
}

template <int D, int P>
GivenField<double> Model<D, P>::on_wall(const std::vector<double>& of_row) const {
  const int row = layout_.has_solid ? layout_.wall_row : 0;
  std::vector<double> values;
  for (int k = 0; k <= P; ++k) values.insert(values.end(), of_row.begin(), of_row.end());
  return {to_device<Array>(values, "given"), row * layout_.row_size};
}

/// At a joint the parts below and above have their own values, each the limit from its side.
template <int D, int P>
void Model<D, P>::grade_solid(const Profile& young) {
  const Axis& vertical = layout_.axis[D - 1];
  const int parts = vertical.joint() > 0 ? 2 : 1;
  std::vector<double> values[2];
  largest_young_ = 0;
  for (int part = 0; part < parts; ++part) {
    const auto in_part = [&](std::array<double, 3> x) {
      x[D - 1] = height_in_part(vertical, part, x[D - 1]);
      return young.at(x);
    };
    values[part] = control_values(layout_, in_part, 0, layout_.solid_rows());
    largest_young_ = std::max(largest_young_, *std::max_element(values[part].begin(), values[part].end()));
  }
  largest_young_ = ranks::largest(largest_young_);
  for (int part = 0; part < parts; ++part) {
    for (double& x : values[part]) x /= largest_young_;
    graded_[part] = {to_device<Array>(values[part], "given"), 0};
  }
}

template <int D, int P>
void Model<D, P>::build_solid(const Case& c) {
  const Substrate& s = *c.substrate;
  young_ = s.young;
  largest_young_ = s.young.number;
  // One kernel serves stiffness that varies, prestretch and selective integration, so that there is no kernel more.
  if (s.young.varies() || !s.prestretch.empty() || s.volume_quadrature == VolumeQuadrature::selective)
    grade_solid(s.young);
  stiffness_ = LameParameters::from(s.density * largest_young_, s.poisson);
  const double density = s.inertia == Inertia::none ? 0.0 : s.density;
  if (s.strain == Strain::small) {
    solid_ = Elastodynamics<Hooke>{{stiffness_}, density};
  } else if (s.material == MaterialModel::neo_hookean) {
    solid_ = Elastodynamics<NeoHookean>{{stiffness_}, density};
  } else {
    solid_ = Elastodynamics<SaintVenantKirchhoff>{{stiffness_}, density};
  }
  prestretch_ = prestretch_of(c, stiffness_);
  fibres_ = fibres_of(s, D).after(prestretch_);
  branches_ = branches_of(s);
  solid_rates_ = solid_rates(c);
  for (const Load& load : c.loads) loads_.emplace_back(layout_, load, s.density, c.clock_zero());
  needles_ = Needles<D>(layout_, c);
  if (!s.gravity.empty()) {
    std::vector<double> upper = c.domain.size;
    upper[D - 1] = s.thickness;
    const std::vector<double> w = weights_on_box(layout_, std::vector<double>(D, 0.0), upper, s.density);
    gravity_ = {to_device<Array>(w, "gravity"), s.gravity};
  }
}

template <int D, int P>
Matrix<double, 3> Model<D, P>::first_piola(const Matrix<double, 3>& grad_u, const std::array<double, 3>& x) const {
  const Matrix<double, 3> whole = prestretch_.whole(grad_u);
  Matrix<double, 3> p =
      std::visit([&](const auto& solid) { return prestretch_.first_piola(solid.material.first_piola(whole)); }, solid_);
  if (young_.varies()) p = (young_.at(x) / largest_young_) * p;
  if (fibres_.stiffness > 0) p = p + fibres_.residual(SolidStrain<double, 3>{grad_u}).momentum_flux;
  return p;
}

template void Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::build_fluid(const Case&);
template WallEnergy Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::wall_of_one() const;
template void Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::grade_solid(const Profile&);
template void Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::build_solid(const Case&);
template Matrix<double, 3> Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::first_piola(const Matrix<double, 3>&,
                                                                                 const std::array<double, 3>&) const;

}  // namespace softwet
