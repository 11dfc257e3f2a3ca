// Strains at the points of a solid against the reference interpolation, in 2D, (r, z) and 3D.
#include "operator/at_points.hpp"

#include "term_cases.hpp"

namespace softwet::testing_tools {
namespace {

/// F of a point by its definition, 3 x 3; what `of` has along the third axis of a plane is 0, or over the radius.
template <int D>
Matrix<double, 3> whole_gradient(const NaivePoint<D>& p, const std::vector<Grid>& of, bool around) {
  Matrix<double, 3> g{};
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) g(i, j) = p.evaluate(of[i], j);
  if (around) g(2, 2) = p.evaluate(of[0], -1) / p.x[0];
  return g;
}

template <int D, class Function>
void check(const Patch<D>& patch, const Function& function, bool rate) {
  constexpr bool around = is_axisymmetric<Function>;
  constexpr int size = around ? 4 : D * (D + 1) / 2;
  const TermCases<D> cases(patch);
  const std::vector<Grid> u = cases.each(patch.stage.displacement, true), v = cases.each(patch.stage.unknown, false);
  const Region<D> solid = patch.solid();
  ReduceTask<D, Function, NoMotion> task{solid, function, {}, {}, {}};
  bind_fields(Evaluation<D>{patch.layout, patch.stage, {}, {}}, patch.blend, task);
  int points = 1;
  for (int d = 0; d < D; ++d) points *= patch.points;
  const int rows = D == 3 ? solid.axis[1].elements : 1;
  const Array out("out", std::size_t(patch.layout.solid_elements) * rows * size * points * solid.stride[1]);
  write_at_points<2>(task, out);
  const std::vector<double> found = to_host(out);
  patch.for_all_points(solid, [&](const std::array<int, D>& element, const std::array<int, D>& q) {
    std::array<double, D> x;
    std::size_t line = element[D - 1] * rows + (D == 3 ? element[1] : 0);
    int point = 0;
    for (int d = D - 1; d >= 0; --d) {
      x[d] = solid.axis[d].position(q[d], element[d]);
      point = point * patch.points + q[d];
    }
    const NaivePoint<D> p(patch.layout, element, x, nullptr);
    Matrix<double, 3> f = whole_gradient(p, u, around), e;
    for (int i = 0; i < 3; ++i) f(i, i) += 1;
    if (rate) {
      const Matrix<double, 3> g = product(transpose(f), whole_gradient(p, v, around));
      e = 0.5 * (g + transpose(g));
    } else {
      e = 0.5 * add_diagonal(product(transpose(f), f), -1.0);
    }
    int k = 0;
    const auto expect = [&](double wanted) {
      EXPECT_NEAR(found[((line * size + k++) * points + point) * solid.stride[1] + element[0]], wanted, 1e-12);
    };
    for (int i = 0; i < D; ++i)
      for (int j = i; j < D; ++j) expect(e(i, j));
    if (around) expect(e(2, 2));
  });
}

template <int D>
void check_all(const Patch<D>& patch) {
  check(patch, StrainEntries{}, false);
  check(patch, StrainRateEntries{}, true);
  if constexpr (D == 2) {
    check(patch, Axisymmetric<StrainEntries>{}, false);
    check(patch, Axisymmetric<StrainRateEntries>{}, true);
  }
}

TEST(AtPoints, StrainsOfEveryElementOnce) {
  check_all(Patch<2>({11, 7}, 3, 2, 0.6));
  check_all(Patch<3>({9, 4, 5}, 2, 2, 0.6));
}

TEST(AtPoints, ReducedQuadrature) {
  if (!has_reduced_quadrature) GTEST_SKIP() << "this program has no kernels for reduced quadrature";
  Patch<2> p({11, 7}, 3);
  p.points = 2;
  check_all(p);
}

}  // namespace
}  // namespace softwet::testing_tools
