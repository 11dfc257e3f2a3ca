// The weighted sum of the boxes' inverses where it is known: for diagonal matrices.
#include "solver/schwarz/boxes.hpp"

#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {
namespace {

/// Fills a matrix with a diagonal; the entry of unknown i is entry(i).
template <class Entry>
void fill_diagonal(StencilMatrix<2>& matrix, const Entry& entry) {
  const UnknownTable<2> table(matrix.layout(), to_host(matrix.mask()));
  matrix.fill([&](const StencilValues& values) {
    const auto host = Kokkos::create_mirror_view(values);
    Kokkos::deep_copy(host, 0.0f);
    const Stencil<2>& s = matrix.stencil();
    for (int i = 0; i < table.unknowns(); ++i) {
      const int c = table.component(i);
      if (c >= 0) host(s.index(c, c, s.offsets / 2, table.point(i))) = entry(i);
    }
    Kokkos::deep_copy(values, host);
  });
}

struct Answer {
  std::vector<double> r, z;
};

/// z = factor sum over boxes of W A^-1 W r for a random r.
Answer answer(RandomScene& s, const StencilMatrix<2>& matrix, int width, int stride, float factor) {
  Boxes<2> boxes(s.layout(), s.scene.mask(), width, stride);
  boxes.build(matrix);
  const Array r = s.direction(), z("z", s.layout().size());
  boxes.add(r, z, factor);
  return {to_host(r), to_host(z)};
}

TEST(Boxes, WeightsOfAnUnknownSumToOne) {
  for (const Case& c : {small_case(SceneKind::coupled), small_case(SceneKind::rigid, WallLaw::energy, true),
                        small_case(SceneKind::solid)})
    for (const auto& [width, stride] : {std::pair{3, 2}, {5, 3}, {8, 6}, {100, 100}}) {
      RandomScene s(c);
      StencilMatrix<2> matrix(s.layout(), s.scene.mask());
      fill_diagonal(matrix, [](int) { return 1.0f; });  // its inverse is exact in 16 bits
      const Answer a = answer(s, matrix, width, stride, 0.5f);
      for (std::size_t i = 0; i < a.r.size(); ++i) EXPECT_NEAR(a.z[i], 0.5 * a.r[i], 1e-6) << "width " << width;
    }
}

TEST(Boxes, InversesHaveEightSignificantBits) {
  RandomScene s(small_case(SceneKind::coupled));
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  const auto entry = [](int i) { return float(std::pow(10.0, 12 * std::sin(i))) * (i % 2 ? -1 : 1); };
  fill_diagonal(matrix, entry);
  const Answer a = answer(s, matrix, 5, 3, 1);
  double largest = 0;
  for (std::size_t i = 0; i < a.r.size(); ++i)
    if (a.r[i] != 0) largest = std::max(largest, std::abs(a.z[i] * entry(static_cast<int>(i)) / a.r[i] - 1));
  EXPECT_LT(largest, std::pow(2, -8));
  EXPECT_GT(largest, std::pow(2, -10));
}

/// A singular box must not pass for a good one.
TEST(Boxes, NonFiniteInversesStayNonFinite) {
  RandomScene s(small_case(SceneKind::rigid));
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  fill_diagonal(matrix, [](int) { return std::numeric_limits<float>::quiet_NaN(); });
  const Answer a = answer(s, matrix, 5, 3, 1);
  for (std::size_t i = 0; i < a.r.size(); ++i) EXPECT_TRUE(a.r[i] == 0 || !std::isfinite(a.z[i]));
}

}  // namespace
}  // namespace softwet::testing_tools
