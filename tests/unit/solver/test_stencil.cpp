// The assembled Jacobian against products, and its sparse factors.
#include "solver/stencil.hpp"

#include "app/error.hpp"
#include "solver/sparse_lu.hpp"
#include "unit/model/scenes.hpp"

namespace softwet::testing_tools {
namespace {

Product frozen_product(RandomScene& s) {
  return [&s](const Array& z, const Array& out) { s.model.product(s.stage(), z, out, Geometry::frozen); };
}

std::vector<double> multiply(const StencilMatrix<2>& m, const std::vector<double>& x) {
  std::vector<double> y(m.size(), 0.0);
  for (int j = 0; j < m.size(); ++j)
    for (int e = m.start()[j]; e < m.start()[j + 1]; ++e) y[m.row()[e]] += m.values()[e] * x[j];
  return y;
}

void check_matrix(const Case& c) {
  RandomScene s(c);
  StencilMatrix<2> matrix(s.layout(), s.model.mask());
  matrix.fill(frozen_product(s));
  ASSERT_EQ(matrix.size(), s.layout().size());
  for (int j = 0; j < matrix.size(); ++j)
    for (int e = matrix.start()[j] + 1; e < matrix.start()[j + 1]; ++e)
      ASSERT_LT(matrix.row()[e - 1], matrix.row()[e]) << "rows ascend";
  for (int n = 0; n < 3; ++n) {
    const Array z = s.direction();
    EXPECT_LT(distance(multiply(matrix, to_host(z)), s.product(z, Geometry::frozen)), 1e-13);
  }
  // Prescribed values and ghosts: identity.
  const std::vector<double> mask = to_host(s.model.mask());
  std::vector<double> held(mask.size());
  for (std::size_t i = 0; i < held.size(); ++i) held[i] = mask[i] == 0 ? 1.0 + i : 0.0;
  EXPECT_EQ(multiply(matrix, held), held);
}

TEST(StencilMatrix, Coupled) { check_matrix(scene(Scene::coupled)); }
TEST(StencilMatrix, CoupledPeriodic) { check_matrix(scene(Scene::coupled, WallLaw::gradient, true)); }
TEST(StencilMatrix, Rigid) { check_matrix(scene(Scene::rigid)); }
TEST(StencilMatrix, RigidPeriodic) { check_matrix(scene(Scene::rigid, WallLaw::energy, true)); }
TEST(StencilMatrix, SolidAlone) { check_matrix(scene(Scene::solid)); }

// Few elements around a periodic axis: every count of colours left over, and stencils that wrap onto themselves.
TEST(StencilMatrix, ShortPeriodicAxes) {
  for (int n = 3; n < 15; ++n) {
    Case c = scene(Scene::rigid, WallLaw::gradient, true);
    c.domain.elements = {n, 4};
    check_matrix(c);
  }
}

#ifdef SOFTWET_HAVE_UMFPACK
void check_factors(const Case& c) {
  RandomScene s(c);
  auto lu = make_sparse_lu<2>(s.layout(), s.model.mask());
  for (int build = 0; build < 2; ++build) {  // the second one reuses the analysis
    lu->build(frozen_product(s));
    const Array z = s.direction();
    Array found("found", s.layout().size());
    lu->apply(to_device<Array>(s.product(z, Geometry::frozen)), found);
    const double error = distance(to_host(found), to_host(z));
    std::printf("  sparse LU: %.1e\n", error);
    EXPECT_LT(error, 1e-10);
    s.stage().rate_scale *= 3;
  }
}
TEST(SparseLu, SolvesCoupled) { check_factors(scene(Scene::coupled)); }
TEST(SparseLu, SolvesPeriodic) { check_factors(scene(Scene::rigid, WallLaw::energy, true)); }
TEST(SparseLu, SolvesSolidAlone) { check_factors(scene(Scene::solid)); }

TEST(SparseLu, SingularJacobianIsAnError) {
  RandomScene s(scene(Scene::rigid));
  auto lu = make_sparse_lu<2>(s.layout(), s.model.mask());
  EXPECT_THROW(lu->build([](const Array&, const Array& out) { Kokkos::deep_copy(out, 0.0); }), Error);
}
#endif

}  // namespace
}  // namespace softwet::testing_tools
