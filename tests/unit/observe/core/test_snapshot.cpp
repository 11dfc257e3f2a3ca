// A snapshot of started copies equals the snapshot that waits for its own.
#include "observe/snapshot.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene/initial.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

State uneven_state(const RandomScene& s) {
  State state = empty_state(s.layout());
  Patch<2> draws = s.terms.patch;
  Kokkos::deep_copy(state.unknown, draws.draw(s.layout().size(), -1, 1));
  Kokkos::deep_copy(state.displacement, draws.draw(s.layout().solid_size(), -0.1, 0.1));
  return state;
}

const Snapshot<2>::Grid in_solid{{{0.1, 0.45, 0.8}, {0.05, 0.2, 0.26}}}, in_fluid{{{0.1, 0.45, 0.8}, {0.3, 0.7}}};

/// All fields that the scene has, at some points.
std::vector<double> sampled_fields(const Snapshot<2>& s, SnapshotOf parts) {
  std::vector<double> all;
  const auto add = [&](const std::vector<double>& values) { all.insert(all.end(), values.begin(), values.end()); };
  if (s.layout().has_fluid) add(s.density(in_fluid)), add(s.chemical_potential(in_fluid));
  for (int d = 0; d < 2; ++d) {
    if (s.layout().has_solid) add(s.displacement(in_solid, d, Medium::solid));
    if (parts == SnapshotOf::all_fields && s.layout().has_fluid) add(s.velocity(in_fluid, d, Medium::fluid));
  }
  return all;
}

TEST(Snapshot, OfCopiesIsThatOfTheState) {
  for (const SceneKind kind : {SceneKind::coupled, SceneKind::rigid, SceneKind::solid})
    for (const SnapshotOf parts : {SnapshotOf::all_fields, SnapshotOf::all_but_velocity}) {
      const RandomScene s(small_case(kind));
      const State state = uneven_state(s);
      SnapshotCopies<2> copies;
      copies.start(s.layout(), state, parts);
      Exec().fence();
      const Snapshot<2> found(s.layout(), copies), expected(s.layout(), state, parts);
      EXPECT_EQ(sampled_fields(found, parts), sampled_fields(expected, parts));
      EXPECT_FALSE(sampled_fields(found, parts).empty());
    }
}

// The memory serves the next start too, and nothing of the previous one is left.
TEST(Snapshot, OfCopiesThatAreStartedAgain) {
  const RandomScene s(small_case(SceneKind::coupled));
  SnapshotCopies<2> copies;
  copies.start(s.layout(), uneven_state(s), SnapshotOf::all_fields);
  Exec().fence();
  const Snapshot<2> first(s.layout(), copies);
  State later = uneven_state(s);
  Kokkos::deep_copy(later.unknown, 0.25);
  copies.start(s.layout(), later, SnapshotOf::all_but_velocity);
  Exec().fence();
  const Snapshot<2> second(s.layout(), copies);
  for (double value : second.density(in_fluid)) EXPECT_NEAR(value, 0.25, 1e-15);
  EXPECT_THROW(second.velocity(in_fluid, 0, Medium::fluid), std::logic_error);
  EXPECT_NO_THROW(first.velocity(in_fluid, 0, Medium::fluid));
}

}  // namespace
}  // namespace softwet::testing_tools
