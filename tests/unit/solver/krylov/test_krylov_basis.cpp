// Sums over several vectors at once, against one vector at a time in long arithmetic.
#include "solver/krylov/krylov_basis.hpp"

#include <gtest/gtest.h>

#include <random>

namespace softwet {
namespace {

template <class Real>
std::vector<double> random_vector(int size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> v(size);
  for (double& x : v) x = static_cast<Real>(uniform(random));
  return v;
}

template <class Real>
class KrylovBasisTest : public testing::Test {
 protected:
  /// More vectors than one kernel takes, and no whole number of blocks.
  static constexpr int size = 2085, count = 35;
  KrylovBasisTest() : basis("basis", alone, size, count), w("w", size) {
    for (int j = 0; j < count; ++j) host.push_back(random_vector<Real>(size, 100 + j));
    for (int j = 0; j < count; ++j) convert(basis[j], to_device<Array>(host[j]));
    wide = random_vector<Real>(size, 7);
    convert(w, to_device<Array>(wide));
  }
  std::vector<double> values(const ArrayOf<Real>& v) const {
    const Array copy("copy", size);
    convert(copy, v);
    return to_host(copy);
  }

  std::vector<std::vector<double>> host;
  std::vector<double> wide;
  KrylovBasis<Real> basis;
  ArrayOf<Real> w;
};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(KrylovBasisTest, Precisions);

TYPED_TEST(KrylovBasisTest, Dots) {
  for (const int used : {1, 9, 35}) {
    const auto [along, square] = this->basis.dots(used, this->w);
    ASSERT_EQ(along.size(), std::size_t(used));
    for (int j = 0; j <= used; ++j) {
      long double sum = 0;
      for (int i = 0; i < this->size; ++i) sum += (j < used ? this->host[j] : this->wide)[i] * this->wide[i];
      EXPECT_NEAR(j < used ? along[j] : square, static_cast<double>(sum), 1e-12) << j;
    }
  }
}

TYPED_TEST(KrylovBasisTest, Sum) {
  const double eps = std::is_same_v<TypeParam, double> ? 1e-14 : 1e-5;
  for (const double old : {0.0, 1.0, -0.5}) {
    const std::vector<double> a = random_vector<TypeParam>(this->count, 3);
    const ArrayOf<TypeParam> out("out", this->size);
    Kokkos::deep_copy(out, old == 0 ? std::numeric_limits<TypeParam>::quiet_NaN() : TypeParam(2));
    this->basis.sum(out, {old, a});
    const std::vector<double> found = this->values(out);
    for (int i = 0; i < this->size; i += 11) {
      double sum = 2 * old;
      for (int j = 0; j < this->count; ++j) sum += a[j] * this->host[j][i];
      ASSERT_NEAR(found[i], sum, eps) << i;
    }
  }
}

TYPED_TEST(KrylovBasisTest, DotsOfTwoVectorsAtOnce) {
  RangeFactors weights;
  weights.add(3, 700, 4);
  weights.add(701, 2000, 0.25);
  for (const int used : {1, 9, 35}) {
    const auto [of_w, of_last] = this->basis.dots_with_last(used, this->w, weights);
    const auto alone = this->basis.dots(used, this->w, weights);
    EXPECT_EQ(of_w.along, alone.along);
    EXPECT_EQ(of_w.square, alone.square);
    ASSERT_EQ(of_last.along.size(), used - 1u);
    for (int j = 0; j < used; ++j) {
      long double sum = 0;
      for (int i = 0; i < this->size; ++i) {
        const double weight = i >= 3 && i < 700 ? 4 : i >= 701 && i < 2000 ? 0.25 : 1;
        sum += weight * this->host[j][i] * this->host[used - 1][i];
      }
      EXPECT_NEAR(j + 1 < used ? of_last.along[j] : of_last.square, static_cast<double>(sum), 1e-12) << j;
    }
  }
}

TYPED_TEST(KrylovBasisTest, TwoSumsAtOnce) {
  const double eps = std::is_same_v<TypeParam, double> ? 1e-14 : 1e-5;
  const std::vector<double> a = random_vector<TypeParam>(34, 3), b = random_vector<TypeParam>(34, 4);
  this->basis.sum_two(this->basis[34], {0.5, a}, this->w, {-0.25, b}, 0.75);
  const std::vector<double> first = this->values(this->basis[34]), second = this->values(this->w);
  for (int i = 0; i < this->size; i += 11) {
    double u = 0.5 * this->host[34][i], v = -0.25 * this->wide[i];
    for (int j = 0; j < 34; ++j) {
      u += a[j] * this->host[j][i];
      v += b[j] * this->host[j][i];
    }
    ASSERT_NEAR(first[i], u, eps) << i;
    ASSERT_NEAR(second[i], v + 0.75 * u, eps) << i;
  }
}

TYPED_TEST(KrylovBasisTest, VectorsDoNotOverlap) {
  Kokkos::deep_copy(this->basis[3], TypeParam(5));
  EXPECT_EQ(this->values(this->basis[2]), this->host[2]);
  EXPECT_EQ(this->values(this->basis[4]), this->host[4]);
}

}  // namespace
}  // namespace softwet
