// The capillary force (w, rho grad mu) against its divergence form (grad w, Sigma), a term of this test alone: that one
// keeps the momentum to round-off, and both are the same force but for an error of the mesh.
#include "scene/initial.hpp"
#include "time/explicit/semi_discrete.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

/// A fluid between periodic sides.
Case periodic(int elements) {
  Case c = small_case(SceneKind::rigid, WallLaw::gradient, true);
  c.domain.size = {1, 1};
  c.domain.elements = {elements, elements};
  c.boundary.side[1] = {Side::periodic, Side::periodic};
  c.fluid->capillarity = 0.1;
  return c;
}

/// A wave of its density: smooth, with a force whose sum is 0 by symmetry.
Case wave(int elements) {
  Case c = periodic(elements);
  c.fluid->ambient = Phase::liquid;
  c.waves.push_back({WaveField::density, 0.1, {2, 2}});
  return c;
}

/// A droplet that is not at a point of the mesh.
Case droplet(int elements) {
  Case c = periodic(elements);
  c.droplets.push_back({{0.513, 0.477}, 0.25, {}, {}});
  return c;
}

struct Forces {
  double size = 0, difference = 0;              ///< norms: of the force, and of what the divergence form changes
  double momentum = 0, of_divergence_form = 0;  ///< sums over the functions: change of the momentum along x
};

/// Forces of the fluid at rest, with the chemical potential that belongs to its density.
Forces forces(const Case& c) {
  const Scene<2, 2> scene(c);
  const Layout<2>& l = scene.layout();
  SemiDiscrete<2, 2> system(scene, MassKind::consistent);
  State state = initial_state(c, scene);
  system.set_moments(state);
  const Array y("y", system.size()), rates("rates", system.size());
  Kokkos::deep_copy(system.moments_of(y), state.moment);
  EXPECT_TRUE(system.rates(0, y, rates).empty());

  const CapillaryTraction term{scene.coefficients().fluid().gas, scene.coefficients().fluid().capillarity};
  const Region<2> region = scene.regions().of(Where::fluid, scene.regions().points());
  const PieceOf<2, 2, CapillaryTraction, NoMotion> piece("capillary stress", region, region, term);
  const Array force("force", l.size()), change("change", l.size());
  scene.equations().residual(system.stage(), force);
  piece.residual({l, system.stage(), {}, change});
  move_ghosts(l, change, GhostAction::add);

  Forces f;
  const std::vector<double> a = to_host(force), b = to_host(change);
  for (int i = 0; i < l.velocity_size(); ++i) {
    f.size += a[i] * a[i];
    f.difference += b[i] * b[i];
    if (i >= l.velocity_size() / 2) continue;
    f.momentum += a[i];
    f.of_divergence_form += a[i] + b[i];
  }
  f.size = std::sqrt(f.size), f.difference = std::sqrt(f.difference);
  return f;
}

TEST(DivergenceForm, IsTheCapillaryForceButForTheMesh) {
  const Forces coarse = forces(wave(8)), fine = forces(wave(16));
  std::printf("  changes of the force: %.2e, %.2e\n", coarse.difference / coarse.size, fine.difference / fine.size);
  EXPECT_GT(fine.size, 0);
  EXPECT_LT(fine.difference / fine.size, 0.25 * coarse.difference / coarse.size);
  EXPECT_GT(fine.difference / fine.size, 1e-9) << "they are not the same";
}

TEST(DivergenceForm, KeepsTheMomentumToRoundOff) {
  const Forces f = forces(droplet(16));
  EXPECT_LT(std::abs(f.of_divergence_form), 1e-13 * f.size);
  EXPECT_GT(std::abs(f.momentum), 1e-10 * f.size) << "the force of the program does so to an error of the mesh";
}

}  // namespace
}  // namespace softwet::testing_tools
