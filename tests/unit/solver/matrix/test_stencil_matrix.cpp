// The assembled Jacobian against products, and its sparse factors.
#include "solver/matrix/stencil_matrix.hpp"

#include "field/vector.hpp"
#include "solver/direct/host/sparse_lu.hpp"
#include "unit/scene/scenes.hpp"

#include <cmath>
#include <limits>

namespace softwet::testing_tools {
namespace {

/// The matrix, computed in single precision, against products with frozen geometry.
void check_matrix(const Case& c) {
  RandomScene s(c);
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  matrix.fill(s.jacobian());
  const Array y("y", s.layout().size());
  for (int n = 0; n < 3; ++n) {
    const Array z = s.direction();
    matrix.multiply(z, y);
    EXPECT_LT(distance(to_host(y), s.product(z, Geometry::frozen)), 1e-6);
  }
  // Prescribed values and ghosts count for nothing, and stay zero.
  const std::vector<double> mask = to_host(s.scene.mask());
  std::vector<double> held(mask.size());
  for (std::size_t i = 0; i < held.size(); ++i) held[i] = mask[i] == 0 ? 1.0 + i : 0.0;
  matrix.multiply(to_device<Array>(held), y);
  EXPECT_EQ(to_host(y), std::vector<double>(mask.size(), 0.0));
}

TEST(StencilMatrix, Coupled) { check_matrix(small_case(SceneKind::coupled)); }
TEST(StencilMatrix, CoupledPeriodic) { check_matrix(small_case(SceneKind::coupled, WallLaw::gradient, true)); }
TEST(StencilMatrix, Rigid) { check_matrix(small_case(SceneKind::rigid)); }
TEST(StencilMatrix, RigidPeriodic) { check_matrix(small_case(SceneKind::rigid, WallLaw::energy, true)); }
TEST(StencilMatrix, SolidAlone) { check_matrix(small_case(SceneKind::solid)); }

// Few elements around a periodic axis: stencils that wrap onto themselves.
TEST(StencilMatrix, ShortPeriodicAxes) {
  for (int n = 3; n < 15; ++n) {
    Case c = small_case(SceneKind::rigid, WallLaw::gradient, true);
    c.domain.elements = {n, 4};
    check_matrix(c);
  }
}

#ifdef SOFTWET_HAVE_UMFPACK
void check_factors(const Case& c) {
  RandomScene s(c);
  auto lu = make_sparse_lu<2>(s.layout(), s.scene.mask());
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  const Array found("found", s.layout().size()), back("back", s.layout().size());
  for (int build = 0; build < 2; ++build) {  // the second one reuses the analysis
    matrix.fill(s.jacobian());
    lu->build(matrix);
    const Array b = to_device<Array>(s.product(s.direction(), Geometry::frozen));
    lu->apply(b, found);
    matrix.multiply(found, back);  // in single precision
    EXPECT_LT(distance(to_host(back), to_host(b)), 1e-4);
    s.stage().rate_scale *= 3;
  }
}
TEST(SparseLu, EstimateOfTheFactorsIsNearWhatTheyTake) {
  Case c = small_case(SceneKind::coupled);
  c.domain.elements = {48, 32};
  RandomScene s(c);
  auto lu = make_sparse_lu<2>(s.layout(), s.scene.mask());
  const double estimate = lu->bytes();
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  matrix.fill(s.jacobian());
  lu->build(matrix);
  EXPECT_GT(estimate, 0.6 * lu->bytes());
  EXPECT_LT(estimate, 1.3 * lu->bytes());
}

TEST(SparseLu, SolvesCoupled) { check_factors(small_case(SceneKind::coupled)); }
TEST(SparseLu, SolvesPeriodic) { check_factors(small_case(SceneKind::rigid, WallLaw::energy, true)); }
TEST(SparseLu, SolvesSolidAlone) { check_factors(small_case(SceneKind::solid)); }

/// As block LU and Schwarz do: the linear solver then stalls, the step is rejected, and the next build may do better.
TEST(SparseLu, SingularJacobianGivesNoNumbers) {
  RandomScene s(small_case(SceneKind::rigid));
  auto lu = make_sparse_lu<2>(s.layout(), s.scene.mask());
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  const Array b("b", s.layout().size()), found("found", s.layout().size());
  for (const float entry : {0.0f, std::numeric_limits<float>::quiet_NaN()}) {
    matrix.fill([&](const StencilValues& values) { Kokkos::deep_copy(values, entry); });
    lu->build(matrix);
    Kokkos::deep_copy(b, 1.0);
    lu->apply(b, found);
    EXPECT_FALSE(std::isfinite(norm(alone, found)));
  }
  matrix.fill(s.jacobian());
  lu->build(matrix);
  Kokkos::deep_copy(b, to_device<Array>(s.product(s.direction(), Geometry::frozen)));
  lu->apply(b, found);
  const Array back("back", s.layout().size());
  matrix.multiply(found, back);
  EXPECT_LT(distance(to_host(back), to_host(b)), 1e-4);
}
#endif

}  // namespace
}  // namespace softwet::testing_tools
