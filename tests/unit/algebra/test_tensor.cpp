// Tensor operations against definitions and hand-computed values.
#include "kernels/algebra/tensor.hpp"

#include <gtest/gtest.h>

#include <random>

namespace softwet {
namespace {

template <int D>
Matrix<double, D> random_matrix(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Matrix<double, D> a;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) a(i, j) = uniform(random);
  return a;
}

TEST(Tensor, CofactorAndDeterminantByHand) {
  const Matrix<double, 2> a{{{2, 3}, {5, 11}}};
  const auto c = cofactor(a);
  EXPECT_EQ(c(0, 0), 11);
  EXPECT_EQ(c(0, 1), -5);
  EXPECT_EQ(c(1, 0), -3);
  EXPECT_EQ(c(1, 1), 2);
  EXPECT_EQ(determinant(a, c), 7);
  const Matrix<double, 3> b{{{1, 2, 3}, {0, 4, 5}, {1, 0, 6}}};
  const double expected[3][3] = {{24, 5, -4}, {-12, 3, 2}, {-2, -5, 4}};
  const auto k = cofactor(b);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) EXPECT_EQ(k(i, j), expected[i][j]) << i << j;
  EXPECT_EQ(determinant(b, k), 22);
}

template <int D>
void cofactor_inverts(unsigned seed) {
  const Matrix<double, D> a = random_matrix<D>(seed);
  const auto c = cofactor(a);
  const double det = determinant(a, c);
  const auto p = product(transpose(c), a);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) EXPECT_NEAR(p(i, j), i == j ? det : 0.0, 1e-14);
}
TEST(Tensor, TransposedCofactorTimesMatrixIsTheDeterminant) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    cofactor_inverts<2>(seed);
    cofactor_inverts<3>(seed);
  }
}

TEST(Tensor, ProductsByHand) {
  const Matrix<double, 2> a{{{1, 2}, {3, 4}}}, b{{{5, 6}, {7, 9}}};
  const auto p = product(a, b);
  EXPECT_EQ(p(0, 0), 19);
  EXPECT_EQ(p(0, 1), 24);
  EXPECT_EQ(p(1, 0), 43);
  EXPECT_EQ(p(1, 1), 54);
  const Vector<double, 2> x{{10, 1}}, y{{-2, 7}};
  const auto ax = product(a, x);
  EXPECT_EQ(ax[0], 12);
  EXPECT_EQ(ax[1], 34);
  EXPECT_EQ(dot(x, y), -13);
  EXPECT_EQ(contract(a, b), 5 + 12 + 21 + 36);
  EXPECT_EQ(trace(b), 14);
  const auto o = outer(x, y);
  EXPECT_EQ(o(0, 1), 70);
  EXPECT_EQ(o(1, 0), -2);
  EXPECT_EQ(transpose(a)(0, 1), 3);
  const auto shifted = add_diagonal(a, 0.5);
  EXPECT_EQ(shifted(1, 1), 4.5);
  EXPECT_EQ(shifted(0, 1), 2);
  EXPECT_EQ((x + y)[1], 8);
  EXPECT_EQ((x - y)[0], 12);
  EXPECT_EQ((3.0 * x)[0], 30);
  EXPECT_EQ((a + b)(1, 0), 10);
  EXPECT_EQ((2.0 * a)(1, 1), 8);
}

TEST(Tensor, ContractionIsTheTraceOfTheTransposedProduct) {
  const auto a = random_matrix<3>(3), b = random_matrix<3>(4);
  EXPECT_NEAR(contract(a, b), trace(product(transpose(a), b)), 1e-15);
}

}  // namespace
}  // namespace softwet
