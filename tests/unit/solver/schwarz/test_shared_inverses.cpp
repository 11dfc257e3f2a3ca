// Boxes share an inverse where it is close to their own, and nowhere else.
#include "solver/schwarz/shared_inverses.hpp"

#include "solver/schwarz/boxes.hpp"
#include "unit/solver/random_matrix.hpp"

namespace softwet::testing_tools {
namespace {

constexpr int box_unknowns = 40, components = 2, row = 2, rows = 3, layers = 2, all = row * rows * layers;

/// Boxes of `box_unknowns` box_unknowns each, but one of the last row lacks an unknown of its own.
PatchTables tables() {
  PatchTables t;
  t.count = all;
  t.row = row;
  t.rows = rows;
  t.unknowns = t.sites = box_unknowns;
  for (int box = 0; box < all; ++box) {
    const bool other = box == all - 1;
    t.size.push_back(other ? box_unknowns - 1 : box_unknowns);
    for (int i = 0; i < box_unknowns; ++i) t.local.push_back(other ? i - 1 : i);
  }
  return t;
}

/// Matrices, inverses as Boxes stores them, and the choice, wave by wave.
struct Choice {
  PatchTables patches = tables();
  SharedInverses shared;
  std::vector<Eigen::MatrixXf> matrix, inverse{all};
  BoxInverses inverses;

  Choice(std::vector<Eigen::MatrixXf> matrices, float limit, int threads = 0)
      : shared(patches, components, limit), matrix(std::move(matrices)) {
    if (!host_algorithms) inverses.strip = box_unknowns;
    inverses.entry = Kokkos::View<std::uint16_t*, Exec>("entry", all * inverses.room(box_unknowns));
    inverses.begin = Kokkos::View<std::int64_t*, Exec>("begin", all);
    for (const std::vector<int>& wave : shared.waves()) {
      const int count = static_cast<int>(wave.size());
      const DenseBlocks blocks("blocks", count, box_unknowns, box_unknowns);
      const auto values = Kokkos::create_mirror_view(blocks);
      for (int b = 0; b < count; ++b)
        for (int i = 0; i < patches.size[wave[b]]; ++i)
          for (int j = 0; j < patches.size[wave[b]]; ++j) values(b, i, j) = matrix[wave[b]](i, j);
      Kokkos::deep_copy(blocks, values);
      shared.choose(wave.data(), count, blocks, inverses, threads);
      keep(wave);
    }
  }
  /// Stores the inverses of a wave.
  void keep(const std::vector<int>& wave) {
    const auto begin = Kokkos::create_mirror_view(inverses.begin);
    const auto entry = Kokkos::create_mirror_view(inverses.entry);
    Kokkos::deep_copy(begin, inverses.begin);
    Kokkos::deep_copy(entry, inverses.entry);
    for (const int box : wave) {
      const int n = patches.size[box];
      begin(box) = shared.owner(box) * inverses.room(box_unknowns);
      if (shared.owner(box) != box) continue;
      inverse[box] = matrix[box].topLeftCorner(n, n).inverse();
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) entry(begin(box) + inverses.place(n, i, j)) = narrow(inverse[box](i, j));
    }
    Kokkos::deep_copy(inverses.begin, begin);
    Kokkos::deep_copy(inverses.entry, entry);
  }
};

/// Random, and well conditioned.
Eigen::MatrixXf some_matrix() {
  return Eigen::MatrixXf::Random(box_unknowns, box_unknowns) / 8 +
         3 * Eigen::MatrixXf::Identity(box_unknowns, box_unknowns);
}

TEST(SharedBoxes, LikeBoxesShareUnlikeOnesDoNot) {
  const Eigen::MatrixXf one = some_matrix(), two = -one;
  std::vector<Eigen::MatrixXf> matrix;
  for (int box = 0; box < all; ++box) matrix.push_back(box / (row * rows) == 0 ? one : two);
  const Choice c(matrix, 0.1f);
  for (int box = 0; box < all; ++box) {
    const int own_column = box % row, layer = box / (row * rows);
    const bool odd = box == all - 1;
    EXPECT_EQ(c.shared.owner(box), odd ? box : layer * row * rows + own_column) << box;
  }
  EXPECT_EQ(c.shared.waves().size(), std::size_t(rows + layers - 1));
}

/// Matrices that differ more and more from the matrix of the first row.
TEST(SharedBoxes, TheLimitIsOnTheRelativeDistance) {
  const Eigen::MatrixXf first = some_matrix(), change = some_matrix() / 3;
  std::vector<Eigen::MatrixXf> matrix;
  for (int box = 0; box < all; ++box) matrix.push_back(first + (box / row == 1 ? 0.08f : 0.0f) * change);
  // With A_b = A_c + E the distance is the norm of A_c^-1 E, here about 0.08 |change| / 3.
  EXPECT_EQ(Choice(matrix, 0.15f).shared.owner(row), 0);
  EXPECT_EQ(Choice(matrix, 0.005f).shared.owner(row), row);
  EXPECT_EQ(Choice(matrix, 0).shared.owner(row), row);
}

TEST(SharedBoxes, NotANumberIsSharedByNone) {
  std::vector<Eigen::MatrixXf> matrix(all, some_matrix());
  matrix[0].setConstant(std::numeric_limits<float>::quiet_NaN());
  const Choice c(matrix, 0.5f);
  EXPECT_EQ(c.shared.owner(row), row);
  for (int box = 0; box < all; ++box) EXPECT_NE(c.shared.owner(box), box == 0 ? -1 : 0);
}

/// Matrices of which some are close to others, as far apart as the size of their change.
std::vector<Eigen::MatrixXf> some_alike() {
  std::srand(3);
  const Eigen::MatrixXf first = some_matrix();
  std::vector<Eigen::MatrixXf> matrix;
  for (int box = 0; box < all; ++box) matrix.push_back(first + 0.05f * (box % 5) * (some_matrix() / 3));
  return matrix;
}

/// The largest distance of a field, by its definition and in double precision.
double distance_by_definition(const Eigen::MatrixXf& a, const Eigen::MatrixXf& inverse, int n) {
  double largest = 0;
  for (int k = 0; k < 2; ++k) {
    std::mt19937 random(1 + k);
    DenseVector r(n);
    for (int i = 0; i < n; ++i) r[i] = (random() % 2 ? 1.0 : -1.0) * a.row(i).head(n).cwiseAbs().maxCoeff();
    const Eigen::MatrixXd m = a.topLeftCorner(n, n).cast<double>(),
                          stored = inverse.unaryExpr([](float x) { return widen(narrow(x)); }).cast<double>();
    const DenseVector x = stored * r, wrong = stored * (m * x) - x;
    DenseVector difference = DenseVector::Zero(components), size = DenseVector::Zero(components);
    for (int i = 0; i < n; ++i) {
      const int field = (n < box_unknowns ? i + 1 : i) % components;
      difference[field] += wrong[i] * wrong[i];
      size[field] += x[i] * x[i];
    }
    largest = std::max(largest, (difference.array() / size.array()).sqrt().maxCoeff());
  }
  return largest;
}

/// Owners by the definition. An owner as good up to round-off may be chosen as well, which these matrices avoid.
TEST(SharedBoxes, TakeTheClosestInverseNearby) {
  const float limit = 0.07f;
  const Choice c(some_alike(), limit);
  int shared = 0;
  for (int box = 0; box < all; ++box) {
    const int y = box / row % rows, z = box / row / rows, n = c.patches.size[box];
    int owner = box;
    double least = limit;
    for (int other = box % row; other < box; other += row) {  // all that come before, and use their own
      const int candidate = c.shared.owner(other);
      if (other / row % rows > y || other / row / rows > z || c.patches.size[other] != n || candidate == owner)
        continue;
      const double d = distance_by_definition(c.matrix[box], c.inverse[candidate], n);
      EXPECT_GT(std::abs(d - least), 1e-4) << "matrices that show nothing";
      if (d < least) {
        least = d;
        owner = candidate;
      }
    }
    EXPECT_EQ(c.shared.owner(box), owner) << box;
    shared += owner != box;
  }
  EXPECT_GT(shared, 1);
  EXPECT_LT(shared, all - row - 1);  // one more than the first row has its own
}

TEST(SharedBoxes, TheChoiceIsThatOfAnyNumberOfThreads) {
  const int several = on_host ? std::min(4, Exec().concurrency()) : 4;
  if (several < 2) GTEST_SKIP() << "one thread alone";
  for (const float limit : {0.02f, 0.05f, 0.07f, 0.1f}) {
    const Choice one(some_alike(), limit, 1), team(some_alike(), limit, several);
    for (int box = 0; box < all; ++box) EXPECT_EQ(team.shared.owner(box), one.shared.owner(box)) << box;
  }
}

/// A matrix that is the same around every control point.
template <int D>
void fill_alike(RandomMatrix<D>& r) {
  const Stencil<D>& s = r.matrix.stencil();
  const UnknownTable<D> table(r.layout, to_host(r.mask));
  std::uniform_real_distribution<float> number(-1, 1);
  std::vector<float> entry(s.components * s.components * s.offsets);
  for (float& x : entry) x = 0.03f * number(r.draw);
  for (int c = 0; c < s.components; ++c) entry[(c * s.components + c) * s.offsets + s.offsets / 2] = 3;
  r.matrix.fill([&](const StencilValues& values) {
    const auto host = Kokkos::create_mirror_view(values);
    Kokkos::deep_copy(host, 0.0f);
    for (int p = 0; p < s.points; ++p)
      for (int o = 0; o < s.offsets; ++o)
        for (int a = 0; a < s.components; ++a)
          for (int u = 0; u < s.components; ++u) {
            const int to = s.neighbour(p, o);
            if (s.couples(a, u) && to >= 0 && table.unknown(a, p) >= 0 && table.unknown(u, to) >= 0)
              host(s.index(a, u, o, p)) = entry[(a * s.components + u) * s.offsets + o];
          }
    Kokkos::deep_copy(values, host);
  });
}

template <int D>
void expect_same_answer(const Shape& shape, int width, int stride) {
  RandomMatrix<D> r(shape);
  fill_alike(r);
  Boxes<D> alone(r.layout, r.mask, width, stride), together(r.layout, r.mask, width, stride, 0.1f);
  const double before = together.bytes();
  for (int build = 0; build < 2; ++build) {
    alone.build(r.matrix);
    together.build(r.matrix);
    EXPECT_EQ(alone.inverses(), alone.count());
    EXPECT_LT(together.inverses(), 0.8 * together.count());
    EXPECT_LT(together.bytes(), before);  // which counted an inverse for each box
    const Array x = to_array(r.direction()), y("y", r.layout.size()), z("z", r.layout.size());
    alone.add(x, y, 1);
    together.add(x, z, 1);
    EXPECT_LT(relative(to_vector(z), to_vector(y)), 1e-6);
    EXPECT_GT(to_vector(y).norm(), 0);
  }
}

TEST(SharedBoxes, BoxesWithTheSameMatrixGiveTheSameAnswer) {
  expect_same_answer<2>({{16, 24}, 6}, 5, 3);
  expect_same_answer<2>({{16, 24}, 0, 2, true}, 5, 3);
  expect_same_answer<3>({{8, 10, 10}, 2}, 4, 3);
}

}  // namespace
}  // namespace softwet::testing_tools
