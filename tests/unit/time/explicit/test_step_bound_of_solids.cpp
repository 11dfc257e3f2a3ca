// The bound of the step of solids against the largest stable step of the linearised scheme.
#include "unit/scene/formulas.hpp"
#include "unit/time/explicit/step_room.hpp"

namespace softwet::testing_tools {
namespace {

TEST(StepBoundOfSolids, HoldsForASolidWithBranches) {
  for (const MassKind kind : {MassKind::corrected, MassKind::lumped, MassKind::consistent})
    for (const Strain strain : {Strain::small, Strain::finite})
      for (const double time : {1e-3, 10.0})
        for (const bool around : {false, true}) {
          Case c = moving_droplet(SceneKind::solid);
          c.substrate->strain = strain;
          c.substrate->branches = {{2.0, time}, {0.5, 0.1}};
          const double found = room(around ? around_axis(c) : c, TimeScheme::kick_drift, kind);
          EXPECT_GE(found, 1) << time << ", " << around << ", " << word_of(strain);
          EXPECT_LE(found, 2.2) << time << ", " << around << ", " << word_of(strain);
        }
}

// At strains of some tenths, where branches of finite strains are stiffer.
TEST(StepBoundOfSolids, HoldsForAStretchedSolidWithBranches) {
  for (const bool around : {false, true}) {
    Case c = moving_droplet(SceneKind::solid);
    c.substrate->material = MaterialModel::neo_hookean;
    c.substrate->branches = {{20.0, 10.0}};
    c.waves = {{WaveField::displacement_y, 0.2, {1, 0.5}}};
    EXPECT_GE(room(around ? around_axis(c) : c, TimeScheme::kick_drift), 1) << around;
  }
}

TEST(StepBoundOfSolids, HoldsForASolidWithTensionOrViscosity) {
  for (const MassKind kind : {MassKind::corrected, MassKind::lumped, MassKind::consistent})
    for (const double tension : {0.0, 0.5})
      for (const double viscosity : {0.0, 0.1}) {
        Case c = moving_droplet(SceneKind::solid);
        c.substrate->surface_tension = c.substrate->surface_tension_wet = tension;
        c.substrate->viscosity = viscosity;
        if (tension + viscosity == 0) continue;
        const double found = room(c, TimeScheme::kick_drift, kind);
        EXPECT_GE(found, 1) << tension << ", " << viscosity;
        EXPECT_LE(found, 2) << tension << ", " << viscosity;
      }
}

Case with_face(Case c, double tension, double modulus) {
  c.substrate->surface_tension = c.substrate->surface_tension_wet = tension;
  c.substrate->surface_modulus = {0.4 * modulus, 0.3 * modulus};
  return c;
}
TEST(StepBoundOfSolids, HoldsForASolidWithAnElasticSurface) {
  for (const MassKind kind : {MassKind::corrected, MassKind::lumped, MassKind::consistent}) {
    for (const auto& [tension, modulus] : {std::pair{0.0, 0.5}, {0.0, 20.0}, {20.0, 0.0}, {20.0, 20.0}}) {
      const double found =
          room(with_face(moving_droplet(SceneKind::solid), tension, modulus), TimeScheme::kick_drift, kind);
      EXPECT_GE(found, 1) << tension << ", " << modulus;
      EXPECT_LE(found, 1.8) << tension << ", " << modulus;
    }
    // A face that is bent is stretched everywhere; tension keeps it from buckling when it swings back.
    Case bent = with_face(moving_droplet(SceneKind::solid), 20, 20);
    bent.waves = {{WaveField::displacement_y, 0.05, {2, 0.5}}};
    EXPECT_GE(room(bent, TimeScheme::kick_drift, kind), 1) << "bent";
  }
}
TEST(StepBoundOfSolids, HoldsForFacesAroundAnAxis) {
  for (const MassKind kind : {MassKind::corrected, MassKind::lumped, MassKind::consistent})
    for (const auto& [tension, modulus] : {std::pair{20.0, 0.0}, {0.0, 20.0}}) {
      const double found = room(with_face(around_axis(moving_droplet(SceneKind::solid)), tension, modulus),
                                TimeScheme::kick_drift, kind);
      EXPECT_GE(found, 1) << tension << ", " << modulus;
      EXPECT_LE(found, 1.8) << tension << ", " << modulus;
    }
}

Case on_springs(Case c, double across, double along) {
  c.boundary.side[1][0] = Side::free;
  c.parts.foundation.springs = {across, along};
  return c;
}
TEST(StepBoundOfSolids, HoldsForASolidOnAFoundation) {
  for (const MassKind kind : {MassKind::corrected, MassKind::lumped, MassKind::consistent})
    for (const auto& [across, along] : {std::pair{5.0, 1.0}, {500.0, 0.0}, {0.0, 500.0}}) {
      for (const Case& c : {moving_droplet(SceneKind::solid), around_axis(moving_droplet(SceneKind::solid))}) {
        const double found = room(on_springs(c, across, along), TimeScheme::kick_drift, kind);
        EXPECT_GE(found, 1) << across << ", " << along;
        EXPECT_LE(found, 1.7) << across << ", " << along;
      }
    }
}

TEST(StepBoundOfSolids, HoldsForASolidOnDashpots) {
  for (const MassKind kind : {MassKind::corrected, MassKind::lumped, MassKind::consistent})
    for (const auto& [across, along] : {std::pair{0.5, 0.1}, {20.0, 0.0}, {0.0, 20.0}})
      for (const Case& plain : {moving_droplet(SceneKind::solid), around_axis(moving_droplet(SceneKind::solid))}) {
        Case c = on_springs(plain, 5, 1);
        c.parts.foundation.dashpots = {across, along};
        const double found = room(c, TimeScheme::kick_drift, kind);
        EXPECT_GE(found, 1) << across << ", " << along;
        EXPECT_LE(found, 2) << across << ", " << along;
      }
}

TEST(StepBoundOfSolids, HoldsForAStretchedSolid) {
  for (const double stretch : {0.7, 0.85, 1.15, 1.5})
    for (const MassKind kind : {MassKind::corrected, MassKind::lumped}) {
      Case c = moving_droplet(SceneKind::solid);
      c.loads.clear();
      c.substrate->material = MaterialModel::neo_hookean;
      c.substrate->prestretch = {stretch};
      for (const Case& one : {c, axisymmetric(c)}) {
        const double found = room(one, TimeScheme::kick_drift, kind);
        EXPECT_GE(found, 1) << stretch;
        EXPECT_LE(found, 1.4) << stretch;
      }
    }
}

TEST(StepBoundOfSolids, HoldsForASolidThatNeedlesHold) {
  for (const MassKind kind : {MassKind::corrected, MassKind::lumped, MassKind::consistent})
    for (const double stiffness : {2e3, 1e5}) {
      Case c = moving_droplet(SceneKind::solid);
      c.needles = {{{0.3, 0.2}, {0.75, 0.8}, stiffness, {0.01, 0}}};
      const double found = room(c, TimeScheme::kick_drift, kind);
      EXPECT_GE(found, 1) << stiffness;
      EXPECT_LE(found, 1.7) << stiffness;
    }
  Case coupled = moving_droplet(SceneKind::coupled);
  coupled.needles = {{{0.3, 0}, {0.75, 0.8 / 3}, 1e5, {0.01, 0}}};
  EXPECT_GE(room(coupled, TimeScheme::kick_drift), 1);
  Case round = around_axis(moving_droplet(SceneKind::solid));
  round.needles = {{{0.3, 0.2}, {0.75, 0.8}, 1e5, {0, 0.01}}};
  EXPECT_GE(room(round, TimeScheme::kick_drift), 1);
}

/// A solid of square elements that is held at its left end, or nowhere.
Case block(std::vector<int> elements, double poisson, bool held) {
  Case c = small_case(SceneKind::solid);
  c.domain.elements = elements;
  c.domain.size = {0.1 * elements[0], 0.1 * elements[1]};
  c.substrate->thickness = c.domain.size[1];
  c.substrate->poisson = poisson;
  c.loads.clear();
  c.boundary.side = {{{held ? Side::clamped : Side::free, Side::free}, {Side::free, Side::free}, {}}};
  return c;
}
TEST(StepBoundOfSolids, HoldsInSolidsWhoseFreeSidesMeet) {
  for (const MassKind kind : {MassKind::corrected, MassKind::lumped})
    for (const double poisson : {0.0, 0.4, 0.49}) {
      EXPECT_GE(room(block({12, 2}, poisson, true), TimeScheme::kick_drift, kind), 1) << "a beam, " << poisson;
      EXPECT_GE(room(block({12, 1}, poisson, true), TimeScheme::kick_drift, kind), 1) << "a thin beam, " << poisson;
      const double found = room(block({8, 8}, poisson, false), TimeScheme::kick_drift, kind);
      EXPECT_GE(found, 1) << "a block, " << poisson;
      EXPECT_LE(found, 1.2) << "a block, " << poisson;
    }
}

/// Two materials, the lower one `ratio` times as stiff, that are joined at the end of a row of twelve.
Case joined(SceneKind kind, int row, double ratio) {
  Case c = moving_droplet(kind);
  const double joint = c.domain.size[1] * row / c.domain.elements[1];
  c.substrate->joint = joint;
  c.substrate->young =
      varying([=](const std::array<double, 3>& x, double) { return x[1] < joint ? 2.0 * ratio : 2.0; });
  return c;
}
TEST(StepBoundOfSolids, HoldsWhereMaterialsAreJoined) {
  for (const MassKind kind : {MassKind::corrected, MassKind::lumped})
    for (const double ratio : {0.02, 50.0}) {
      for (const int row : {1, 11}) {
        const double found = room(joined(SceneKind::solid, row, ratio), TimeScheme::kick_drift, kind);
        EXPECT_GE(found, 1) << row << ", " << ratio;
        EXPECT_LE(found, 1.7) << row << ", " << ratio;
      }
      EXPECT_GE(room(joined(SceneKind::coupled, 2, ratio), TimeScheme::kick_drift, kind), 1) << ratio;
      EXPECT_GE(room(around_axis(joined(SceneKind::solid, 4, ratio)), TimeScheme::kick_drift, kind), 1) << ratio;
    }
}

}  // namespace
}  // namespace softwet::testing_tools
