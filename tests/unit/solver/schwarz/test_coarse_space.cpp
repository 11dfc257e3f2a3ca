// The coarse space against evaluation of splines and against its own definition.
#include "field/vector.hpp"
#include "solver/schwarz/coarse_space.hpp"

#include <cmath>

#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

double spline(const Axis& axis, const std::vector<double>& c, double x) {
  const int e = axis.element_at(x);
  const std::vector<double> v = axis.values(e, x);
  double sum = 0;
  for (int k = 0; k <= axis.degree(); ++k) sum += v[k] * c[axis.span(e) + k];
  return sum;
}

/// Each coarse function equals its sum of fine ones at many points.
void check_refinement(const Axis& fine) {
  const Refinement r = refine_from_half(fine, 2);
  ASSERT_EQ(r.coarse.elements(), (fine.elements() + 1) / 2);
  for (int j = 0; j < r.coarse.owned(); ++j) {
    std::vector<double> coarse(r.coarse.functions(), 0.0), sum(fine.functions(), 0.0);
    for (int g = j; g < r.coarse.functions(); g += r.coarse.owned()) coarse[g] = 1;
    for (std::size_t k = 0; k < r.coefficient[j].size(); ++k) {
      const int n = fine.owned(), i = (r.first[j] + static_cast<int>(k) + n) % n;
      for (int g = i; g < fine.functions(); g += n) sum[g] += r.coefficient[j][k];
    }
    for (double x = 0.001; x < fine.length(); x += 0.0137)
      EXPECT_NEAR(spline(r.coarse, coarse, x), spline(fine, sum, x), 1e-13) << "function " << j << " at " << x;
  }
}

TEST(Refinement, SumsOfFineSplines) {
  for (int degree : {2, 3}) {
    check_refinement(Axis(1.0, 12, degree));
    check_refinement(Axis(1.0, 12, degree, AxisKind::bounded, 4));
    check_refinement(Axis(1.0, 12, degree, AxisKind::bounded, 6, 2));
    check_refinement(Axis(1.0, 12, degree, AxisKind::bounded, 6, 3));
    check_refinement(Axis(0.7, 14, degree, AxisKind::periodic));
  }
}

std::vector<double> uneven(int elements) {
  std::vector<double> breaks{0};
  for (int e = 0; e < elements; ++e) breaks.push_back(breaks.back() + 0.1 + 0.07 * std::sin(3.1 * e * e));
  return breaks;
}

TEST(Refinement, SumsOfGradedSplines) {
  for (int degree : {2, 3}) {
    check_refinement(Axis(uneven(12), degree));
    check_refinement(Axis(uneven(13), degree));
    check_refinement(Axis(uneven(14), degree, AxisKind::periodic));
  }
  for (int kink : {4, 5}) {
    const Axis fine(uneven(13), 2, AxisKind::bounded, kink);
    check_refinement(fine);
    const Axis coarse = refine_from_half(fine, 2).coarse;
    EXPECT_EQ(coarse.lower(coarse.kink()), fine.lower(kink)) << "the wall is an end of elements";
    for (int joint : {1, 2, 3}) check_refinement(Axis(uneven(13), 2, AxisKind::bounded, kink, joint));
  }
}

TEST(Refinement, OddAxesStay) {
  EXPECT_EQ(refine_from_half(Axis(1.0, 13, 2), 2).coarse.elements(), 13);
  EXPECT_EQ(refine_from_half(Axis(1.0, 12, 2, AxisKind::bounded, 3), 2).coarse.elements(), 12);
  EXPECT_EQ(refine_from_half(Axis(1.0, 6, 2), 4).coarse.elements(), 6);
}

/// A_c x = P^T A P x for random x, and <P x, y> = <x, P^T y>.
void check_galerkin(Case c, std::vector<int> elements) {
  c.domain.elements = elements;
  RandomScene s(c);
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  matrix.fill(s.jacobian());
  CoarseSpace<2> space(s.layout(), s.scene.mask(), 2);
  ASSERT_TRUE(space.exists());
  StencilMatrix<2> coarse(space.layout(), space.mask());
  coarse.fill([&](const StencilValues& values) { space.galerkin(matrix, values); });
  const int n = space.layout().size();
  std::vector<double> x(n);
  const std::vector<double> mask = to_host(space.mask());
  for (int i = 0; i < n; ++i) x[i] = mask[i] * std::sin(1.7 * i + 0.3);
  const Array coarse_x = to_device<Array>(x), fine("fine", s.layout().size()), image("image", s.layout().size());
  const Array expected("expected", n), found("found", n);
  space.prolong(coarse_x, fine);
  matrix.multiply(fine, image);
  space.restrict_to(image, expected);
  coarse.multiply(coarse_x, found);
  EXPECT_LT(distance(to_host(found), to_host(expected)), 1e-5);
  const Array y = s.direction();
  const CoarseSpace<2> at_once(s.layout(), s.scene.mask(), 2, TransferKernels::one),
      by_axis(s.layout(), s.scene.mask(), 2, TransferKernels::one_for_each_axis);
  const Array again("again", s.layout().size());
  by_axis.prolong(coarse_x, fine);
  at_once.prolong(coarse_x, again);
  EXPECT_LT(distance(to_host(again), to_host(fine)), 1e-14);
  by_axis.restrict_to(y, expected);
  at_once.restrict_to(y, found);
  EXPECT_LT(distance(to_host(found), to_host(expected)), 1e-14);
  EXPECT_NEAR(dot(alone, fine, y), dot(alone, coarse_x, found), 1e-11 * norm(alone, fine) * norm(alone, y));
}

TEST(CoarseSpace, GalerkinProduct) {
  check_galerkin(small_case(SceneKind::coupled), {16, 12});
  check_galerkin(small_case(SceneKind::coupled, WallLaw::gradient, true), {16, 6});
  check_galerkin(small_case(SceneKind::rigid), {12, 7});  // one axis alone is halved
  check_galerkin(small_case(SceneKind::rigid, WallLaw::energy, true), {10, 8});
  check_galerkin(small_case(SceneKind::solid), {8, 6});
}

}  // namespace
}  // namespace softwet::testing_tools
