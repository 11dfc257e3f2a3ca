// What the stage of an explicit step holds decides which calls compile, and a refusal goes through all that follow.
#include "time/explicit/placed.hpp"

#include "scene/initial.hpp"
#include "time/explicit/semi_discrete.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

using System = SemiDiscrete<2, 2>;
using namespace placed;

template <unsigned parts>
concept finds_density = requires(System s, Placed<parts> at, Array a) {
  s.find_density(std::move(at), a);
};
template <unsigned parts>
concept finds_potential = requires(System s, Placed<parts> at) {
  s.find_potential(std::move(at));
};
template <unsigned parts>
concept finds_flux = requires(System s, Placed<parts> at) {
  s.find_flux(std::move(at));
};
template <unsigned parts>
concept moves_moments = requires(System s, Placed<parts> at, Array a) {
  s.move_moments(std::move(at), 1, a, a, a);
};
template <unsigned parts>
concept moves_to_end = requires(System s, Placed<parts> at, Array a) {
  s.move_to_end(std::move(at), 1, a, a, a);
};
template <unsigned parts>
concept weighs = requires(System s, Placed<parts> at, Array a) {
  s.weigh_velocities(std::move(at), a);
};
template <unsigned parts>
concept has_pressure = requires(System s, Placed<parts> at, Array a) {
  s.pressure(std::move(at), a);
};
template <unsigned parts>
concept takes_rates = requires(System s, Placed<parts> at, Array a) {
  s.take_rates(std::move(at), a);
};
template <unsigned parts>
concept has_convection = requires(System s, Placed<parts> at, Array a) {
  s.convection(std::move(at), Viscosity::among_all, a);
};
template <class At>
concept asks_without_moving = requires(System s, At at) {
  s.find_potential(at);
};

static_assert(finds_density<mesh> && !finds_density<velocity> && !finds_density<placed::all | flux>);
static_assert(finds_potential<mesh | density> && !finds_potential<mesh> && !finds_potential<density>);
static_assert(finds_flux<fields> && !finds_flux<mesh | velocity> && !finds_flux<fields | rates>);
static_assert(moves_moments<fields | flux> && !moves_moments<placed::all>, "a flux is found first");
static_assert(moves_to_end<fields | flux> && !moves_to_end<placed::all>);
static_assert(weighs<mesh | density> && !weighs<mesh | velocity>);
static_assert(has_pressure<placed::all> && !has_pressure<fields | weights> && !has_pressure<fields | potential>);
static_assert(!has_pressure<placed::all | flux>, "what terms have left is taken before others are evaluated");
static_assert(takes_rates<placed::all | rates> && !takes_rates<placed::all>);
static_assert(has_convection<fields | weights> && !has_convection<fields> && !has_convection<placed::all | rates>);
static_assert(!asks_without_moving<Placed<placed::all>>, "a stage that has changed is not used again");
static_assert(!std::is_copy_constructible_v<Placed<placed::all>>);

// Moments change the density: the potential and the masses of before do not fit.
template <class Stage>
struct PartsOf;
template <unsigned parts>
struct PartsOf<Placed<parts>> {
  static constexpr unsigned value = parts;
};
using AfterDensity = decltype(std::declval<System>().find_density(std::declval<Placed<placed::all>>(), Array()));
static_assert(PartsOf<AfterDensity>::value == fields);
using AfterMoments = decltype(std::declval<System>().move_moments(std::declval<Placed<placed::all | flux>>(), 1,
                                                                  Array(), Array(), Array()));
static_assert(PartsOf<AfterMoments>::value == fields);

TEST(Placed, ARefusalGoesThroughAndWhatFollowsDoesNothing) {
  const Case c = small_case(SceneKind::coupled);
  const Scene<2, 2> scene(c);
  System system(scene, MassKind::consistent);
  State state = initial_state<2, 2>(c, scene);
  system.set_moments(state);
  const Array acceleration("acceleration", system.velocities()), second("second", system.velocities());
  const Array broken = to_device<Array>(std::vector<double>(system.moments(), std::numeric_limits<double>::infinity()));
  auto fields = system.find_potential(system.find_density(system.evaluated(), broken));
  auto refused = system.pressure(system.weigh_velocities(std::move(fields), broken), acceleration);
  EXPECT_EQ(refused.refusal().cause, Refusal::acceleration);
  Kokkos::deep_copy(second, 7.0);
  const auto last = system.convection(system.take_rates(std::move(refused), broken), Viscosity::apart, second);
  EXPECT_EQ(last.refusal().cause, Refusal::acceleration);
  EXPECT_EQ(to_host(second), std::vector<double>(system.velocities(), 7.0)) << "nothing was evaluated";
  EXPECT_EQ(to_host(broken)[0], std::numeric_limits<double>::infinity()) << "no rates were taken";
}

}  // namespace
}  // namespace softwet::testing_tools
