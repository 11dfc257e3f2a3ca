// A scene in single precision against the same scene in double precision: products.
#include "field/vector.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

/// Each entry is the sum of at most 9 elements with 9 points, whose numbers come out of some tens of roundings of 6e-8
/// each, mostly of different signs. In these scenes no result is small against its parts.
constexpr double allowed = 1e-6;

Case in_single(Case c) {
  c.solver.precision = PrecisionChoice::mixed;
  return c;
}

std::vector<double> widened(const ArrayOf<float>& a) {
  const Array wide("wide", a.extent(0));
  convert(wide, a);
  return to_host(wide);
}

/// max |a - b| / max |b| of the worst field: velocity, density, potential.
double field_distance(const Layout<2>& l, const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0;
  const int border[] = {0, l.velocity_size(), l.velocity_size() + l.scalar_size(), l.size()};
  for (int f = 0; f < (l.has_fluid ? 3 : 1); ++f) {
    const auto cut = [&](const std::vector<double>& v) {
      return std::vector<double>(v.begin() + border[f], v.begin() + border[f + 1]);
    };
    worst = std::max(worst, distance(cut(a), cut(b)));
  }
  return worst;
}

void check_single(const char* name, const Case& c, double bound = allowed) {
  RandomScene s(in_single(c));
  const Layout<2>& l = s.layout();
  const StageOf<float> stage = single_stage(s.stage());
  const ArrayOf<float> z("z", l.size()), out("out", l.size());
  const Array direction = s.direction();
  convert(z, direction);
  s.scene.equations().product(stage, z, out, Geometry::exact);
  const double product = field_distance(l, widened(out), s.product(direction, Geometry::exact));
  std::printf("  %-28s product in single against double: %.1e\n", name, product);
  EXPECT_LT(product, bound) << name;
  EXPECT_GT(product, 1e-9) << name << ": this is double precision";
}

TEST(SinglePrecision, Coupled) { check_single("coupled", small_case(SceneKind::coupled)); }
TEST(SinglePrecision, Rigid) { check_single("rigid", small_case(SceneKind::rigid)); }
TEST(SinglePrecision, Solid) { check_single("solid", small_case(SceneKind::solid)); }
TEST(SinglePrecision, Periodic) { check_single("periodic", small_case(SceneKind::coupled, WallLaw::gradient, true)); }
TEST(SinglePrecision, BlendedTraction) {
  Case c = small_case(SceneKind::coupled);
  c.fluid->traction = Traction::blended;
  check_single("blended traction", c);
}

TEST(SinglePrecision, TheListOfTermsIsTheSame) {
  const Scene<2, 2> scene(in_single(small_case(SceneKind::coupled)));
  ASSERT_EQ(scene.terms().single_pieces().list.size(), scene.terms().pieces().list.size());
  for (std::size_t i = 0; i < scene.terms().pieces().list.size(); ++i)
    EXPECT_STREQ(scene.terms().single_pieces().list[i].piece->name(), scene.terms().pieces().list[i].piece->name());
}

}  // namespace
}  // namespace softwet::testing_tools
