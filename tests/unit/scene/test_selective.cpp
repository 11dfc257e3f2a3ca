// Nearly incompressible solids whose stiffness against changes of volume is integrated in parts.
#include "unit/scene/formulas.hpp"
#include "unit/scene/rates.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

Case nearly_incompressible(Case c, double poisson, VolumeQuadrature quadrature) {
  c.substrate->poisson = poisson;
  c.substrate->volume_quadrature = quadrature;
  return c;
}

/// Solids of each law, in 2D, (r, z), with a joint and with a prestretch.
std::vector<Case> solids() {
  std::vector<Case> all(6, small_case(SceneKind::solid));
  all[1].substrate->material = MaterialModel::neo_hookean;
  all[2].substrate->strain = Strain::small;
  all[3] = axisymmetric(all[3]);
  all[4].substrate->joint = 0.4;
  all[4].substrate->young = varying([](const std::array<double, 3>& x, double) { return 2 + x[0] - x[1]; });
  all[5].substrate->material = MaterialModel::neo_hookean;
  all[5].substrate->prestretch = {1.2};
  return all;
}

TEST(Selective, IsFullBelowItsPoissonRatio) {
  for (const Case& c : solids()) {
    RandomScene full(nearly_incompressible(c, 0.39, VolumeQuadrature::full));
    RandomScene parts(nearly_incompressible(c, 0.39, VolumeQuadrature::selective));
    EXPECT_LT(distance(full.residual(full.stage()), parts.residual(parts.stage())), 1e-13);
  }
}

// A strain that is the same everywhere is its own mean.
TEST(Selective, IsFullWhereTheStrainIsUniform) {
  for (const Case& c : solids()) {
    if (c.axisymmetric() || c.substrate->young.varies()) continue;
    RandomScene full(nearly_incompressible(c, 0.4999, VolumeQuadrature::full));
    RandomScene parts(nearly_incompressible(c, 0.4999, VolumeQuadrature::selective));
    const Layout<2>& l = full.layout();
    std::vector<double> u(l.solid_size());
    const int count = l.solid_rows() * l.row_size;
    for (int i = 0; i < count; ++i) {
      const double x = l.axis[0].greville(i % l.row_size), y = l.axis[1].greville(i / l.row_size);
      u[i] = 0.1 * x - 0.05 * y;
      u[count + i] = 0.02 * x + 0.04 * y;
    }
    full.stage().displacement = parts.stage().displacement = to_device<Array>(u);
    const std::vector<double> expected = full.residual(full.stage());
    double largest = 0;
    for (const double r : expected) largest = std::max(largest, std::abs(r));
    EXPECT_GT(largest, 1);
    EXPECT_LT(distance(expected, parts.residual(parts.stage())), 1e-12 * largest);
  }
}

TEST(Selective, DiffersWhereTheStrainVaries) {
  RandomScene full(nearly_incompressible(small_case(SceneKind::solid), 0.4999, VolumeQuadrature::full));
  RandomScene parts(nearly_incompressible(small_case(SceneKind::solid), 0.4999, VolumeQuadrature::selective));
  EXPECT_GT(distance(full.residual(full.stage()), parts.residual(parts.stage())), 0.1);
}

// Where nothing is displaced a prestretch has the same stress with either quadrature, however the stiffness varies.
TEST(Selective, IsFullInAStretchedLayerAtRest) {
  for (const bool around_axis : {false, true})
    for (Case c : solids()) {
      if (c.substrate->strain == Strain::small) continue;
      if (around_axis != c.axisymmetric()) c = axisymmetric(c);
      c.substrate->material = MaterialModel::neo_hookean;
      c.substrate->prestretch = {1.2};
      c.substrate->young = varying([](const std::array<double, 3>& x, double) { return 2 + x[0] - x[1]; });
      RandomScene full(nearly_incompressible(c, 0.4999, VolumeQuadrature::full));
      RandomScene parts(nearly_incompressible(c, 0.4999, VolumeQuadrature::selective));
      full.stage().displacement = parts.stage().displacement = Array("at rest", full.layout().solid_size());
      const std::vector<double> expected = full.residual(full.stage());
      double largest = 0;
      for (const double r : expected) largest = std::max(largest, std::abs(r));
      EXPECT_GT(largest, 1e-3);
      EXPECT_LT(distance(expected, parts.residual(parts.stage())), 1e-12 * largest);
    }
}

template <int D>
void expect_energy_and_product(const Case& c) {
  SCOPED_TRACE(word_of(c.substrate->material) + (c.axisymmetric() ? " axisymmetric" : "") + " " +
               word_of(c.substrate->strain));
  RandomSceneIn<D> s(nearly_incompressible(c, 0.49, VolumeQuadrature::selective));
  std::vector<double> u = to_host(s.stage().displacement);
  for (double& x : u) x *= 0.2;  // no element is turned inside out, which a logarithm does not bear
  s.stage().displacement = to_device<Array>(u);
  const std::vector<double> r = s.residual(s.stage()), x = to_host(s.stage().unknown);
  const double expected = s.rate_of_energy(2e-4) - s.scene.balance().measure(s.stage()).load_power;
  EXPECT_NEAR(s.scene.regions().turn() * contract(r, x, 0, s.layout().size()), expected, 1e-8 * std::abs(expected));
  const Array z = s.direction();
  const std::vector<double> exact = s.product(z, Geometry::exact), difference = s.difference(z, 1e-3);
  double largest = 0;
  for (const double p : exact) largest = std::max(largest, std::abs(p));
  EXPECT_LT(distance(exact, difference), 1e-8 * largest);
}

TEST(Selective, HasAnEnergyAndAnExactProduct) {
  for (const Case& c : solids()) expect_energy_and_product<2>(c);
}

}  // namespace
}  // namespace softwet::testing_tools
