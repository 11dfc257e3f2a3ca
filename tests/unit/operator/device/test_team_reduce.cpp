// Integrals by teams of a device compared with integrals of the host, strip by strip.
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/functional/fluid_integrals.hpp"
#include "kernels/functional/solid_integrals.hpp"
#include "kernels/functional/wall_integrals.hpp"
#include "kernels/solid/branches.hpp"
#include "kernels/solid/surface_tension.hpp"
#include "operator/integrate.hpp"
#include "unit/operator/patch.hpp"
#include "unit/operator/thread_team.hpp"

namespace softwet::testing_tools {
namespace {

template <int D, int P>
struct IntegralCases {
  Patch<D> patch;
  Terms terms;

  explicit IntegralCases(const std::array<int, D>& elements)
      : patch(Patch<D>(elements, 2, P).with_point_memory(D * (D + 1) / 2)) {}

  template <class Motion, class Functional>
  auto task(const Functional& functional, const Region<D>& region) const {
    ReduceTask<D, Functional, Motion> t{region, functional, {}, {}, {}};
    bind_fields(Evaluation<D>{patch.layout, patch.stage, {}, {}}, patch.blend, t);
    if constexpr (!std::is_same_v<Motion, NoMotion>) {
      for (int d = 0; d < D; ++d) t.motion.tangent[d] = t.motion.velocity[d];
      t.motion.scale = 1;
    }
    return t;
  }

  /// Rows that a device adds up have the bits of those that the host adds up.
  template <int count>
  static void rows_add_up(const char* name, const IntegralItems<D>& in, const Array& items) {
    const Array strips("strips", in.strips * count);
    AddBlocks{items, in.rows.items(), strips}.start();
    const auto total = [&in](const std::vector<double>& partial, int numbers) {
      return in.template total<count>([&partial](int i) { return partial[i]; }, numbers);
    };
    EXPECT_EQ(total(to_host(strips), in.strips), total(to_host(items), in.items)) << name;
  }

  template <bool Rate, int Q, class Motion, class Functional>
  void compare(const char* name, const ReduceTask<D, Functional, Motion>& t) const {
    const Colouring<D> rows(t.region, 1, 0, FirstAxis::in_rows);
    const int items = rows.items() * rows.first_axis.strips, size = items * Functional::count;
    const Array host("host", size), team("team", size), three("three", size);
    const ReduceRow<D, P, Q, Rate, Functional, Motion> by_rows{t, rows, host};
    Kokkos::parallel_for("rows", Items(0, by_rows.items()), by_rows);
    TeamReduce<D, P, Q, Rate, Functional, Motion>::launch(t, rows, team, items);
    ASSERT_GT(largest(to_host(host)), 1e-6) << name;
    EXPECT_LT(distance(to_host(team), to_host(host)), 1e-13) << name;
    rows_add_up<Functional::count>(name, IntegralItems<D>(t.region), team);
    if (!on_host) return;
    // Teams of different sizes are compiled apart, and a compiler may contract their sums in different ways.
    const TeamReduce<D, P, Q, Rate, Functional, Motion> kernel{t, rows, three};
    const int few = std::min(items, 5);
    const auto by_three = [&] {
      std::vector<double> scratch(kernel.size, std::nan(""));
      run_thread_teams(few, [&](const ThreadTeam& threads) { kernel.run(threads, scratch.data()); });
      std::vector<double> found = to_host(three);
      found.resize(few * Functional::count);
      return found;
    };
    const std::vector<double> found = by_three();
    std::vector<double> expected = to_host(team);
    expected.resize(found.size());
    EXPECT_EQ(found, by_three()) << name;
    EXPECT_LT(distance(found, expected), 1e-13) << name;
  }

  void check_all() const {
    using Moving = WallMotion<D>;
    const FluidIntegrals fluid{terms.fluid};
    const WallIntegrals wall{WallEnergy::of(terms.energy_wall)};
    const EnergyOf<Elastodynamics<SaintVenantKirchhoff>> elastic{terms.solid};
    compare<false, P + 1>("fluid", task<Moving>(fluid, patch.fluid()));
    compare<false, P + 1>("contents", task<Moving>(FluidContents{}, patch.fluid()));
    compare<false, P + 1>("fluid, fixed", task<NoMotion>(fluid, patch.fluid()));
    compare<false, P + 1>("wall", task<Moving>(wall, patch.face()));
    compare<true, P + 1>("wall, its rate", task<Moving>(wall, patch.face()));
    compare<false, P + 1>("solid", task<NoMotion>(SolidMotion{1.3}, patch.solid()));
    compare<false, P + 1>("elastic", task<NoMotion>(elastic, patch.solid()));
    compare<false, P + 1>("branches", task<NoMotion>(FiniteShearSquare{}, patch.solid()));
    compare<false, P + 1>("surface", task<NoMotion>(EnergyOf<SurfaceTension>{{0.7}}, patch.top()));
  }
};

/// Strips have 4 elements and the last one has the rest: one or more, of which the last is longer or not.
TEST(TeamReduce, PlaneByThreadsOfATeam) {
  for (int elements : {7, 8, 9, 12, 14, 18}) IntegralCases<2, 2>({elements, 5}).check_all();
}
TEST(TeamReduce, PlaneDegreeThree) { IntegralCases<2, 3>({5, 6}).check_all(); }
TEST(TeamReduce, SpaceByThreadsOfATeam) { IntegralCases<3, 2>({6, 3, 5}).check_all(); }
TEST(TeamReduce, ReducedQuadrature) {
  if (!has_reduced_quadrature) GTEST_SKIP() << "this program has no kernels for reduced quadrature";
  IntegralCases<2, 2> c({9, 7});
  c.patch.points = 2;
  c.compare<false, 2>("fluid", c.task<WallMotion<2>>(FluidIntegrals{c.terms.fluid}, c.patch.fluid()));
}

}  // namespace
}  // namespace softwet::testing_tools
