// The matrices of a device, made by teams, compared with the matrices of the host.
#include "unit/operator/compiled.hpp"
#include "unit/operator/patch.hpp"
#include "unit/operator/thread_team.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace softwet::testing_tools {
namespace {

template <int D, int P>
struct MatrixCases {
  Patch<D> patch;
  Terms terms;
  StageOf<float> stage;

  explicit MatrixCases(const std::array<int, D>& elements) : patch(elements, 2, P) {
    patch.points = matrix_points<D, P>;
    stage = single_stage(patch.stage);
  }

  template <class Motion, class Term>
  void check(const char* name, const Term& term, const Region<D>& region) const {
    const Evaluation<D, float> at{patch.layout, stage, {}, stage.unknown, Geometry::frozen};
    const Stencil<D> stencil(patch.layout);
    const StencilValues batches("batches", stencil.size()), teams("teams", stencil.size());
    const Region<D, float> rounded_region = rounded<float>(region);
    const auto task = task_of<D, Term, Motion>(term, rounded_region, at, patch.blend);
    constexpr int Q = matrix_points<D, P>;
    for_colours("batches", task.region, P + 1, JacobianBatch<D, P, Q, Term, Motion>{task, stencil, batches});
    TeamJacobian<D, P, Q, Term, Motion>::launch(task, stencil, teams);
    const auto wide = [](const StencilValues& v) {
      const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), v);
      return std::vector<double>(host.data(), host.data() + host.extent(0));
    };
    ASSERT_GT(largest(wide(batches)), 1e-6) << name;
    EXPECT_LT(distance(wide(teams), wide(batches)), 3e-6) << name;
    if (!on_host) return;
    const Colouring<D> others(task.region, P + 1, 0, FirstAxis::in_rows);
    check_threads(TeamJacobian<D, P, Q, Term, Motion>{task, stencil, teams, others, {others.first_axis.run[0], 0}});
  }
  /// The rows of one colour by teams of three threads, twice, and by one thread. Teams of different sizes are compiled
  /// apart, and a compiler may contract their sums in different ways.
  template <class Kernel>
  void check_threads(Kernel kernel) const {
    const auto values_of = [&](const auto& run_all) {
      std::vector<float> scratch(Kernel::size, std::nanf(""));
      kernel.values = StencilValues("values", kernel.stencil.size());
      run_all(scratch.data());
      return std::vector<double>(kernel.values.data(), kernel.values.data() + kernel.values.extent(0));
    };
    const int items = kernel.items();
    const auto by_three = [&](float* scratch) {
      run_thread_teams(items, [&](const ThreadTeam& team) { kernel.run(team, scratch); });
    };
    const std::vector<double> three = values_of(by_three), again = values_of(by_three),
                              one = values_of([&](float*scratch) {
                                for (int item = 0; item < items; ++item) kernel.run(OneThread{item}, scratch);
                              });
    EXPECT_EQ(three, again);
    EXPECT_LT(distance(three, one), 3e-6);
  }
  void check_all() const {
    using Moving = WallMotion<D, float>;
    check<Moving>("navier_stokes_korteweg", terms.fluid, patch.fluid());
    check<NoMotion>("navier_stokes_korteweg, fixed", terms.fluid, patch.fluid());
    check<Moving>("density_moment", DensityMoment{}, patch.fluid());
    check<Moving>("gradient_wall", terms.gradient_wall, patch.face());
    check<Moving>("energy_wall", terms.energy_wall, patch.face());
    check<Moving>("capillary_traction", terms.traction, patch.layer());
    check<NoMotion>("neo_hookean", terms.neo_hookean, patch.solid());
  }
};

TEST(TeamJacobian, PlaneByThreadsOfATeam) { MatrixCases<2, 2>({19, 6}).check_all(); }
TEST(TeamJacobian, PlaneDegreeThree) {
  const MatrixCases<2, 3> c({13, 6});
  c.check<WallMotion<2, float>>("navier_stokes_korteweg", c.terms.fluid, c.patch.fluid());
}
TEST(TeamJacobian, SpaceByThreadsOfATeam) {
  if (!has_reduced_quadrature) GTEST_SKIP() << "this program has no kernels for reduced quadrature";
  MatrixCases<3, 2>({11, 3, 5}).check_all();
}

}  // namespace
}  // namespace softwet::testing_tools
