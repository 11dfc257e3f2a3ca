// Dense products, inverses and stored blocks against sums in double precision.
#include "solver/direct/host/packed_block.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace softwet {
namespace {

/// Columns of a matrix with room to spare between them.
template <class Number>
struct Sample {
  int rows, columns, stride;
  std::vector<Number> values;

  Sample(int m, int n, std::mt19937& draw, double from = -1, double to = 1)
      : rows(m), columns(n), stride(m + 3), values(std::size_t(stride) * n) {
    std::uniform_real_distribution<double> number(from, to);
    for (Number& v : values) v = static_cast<Number>(number(draw));
  }
  Number& operator()(int i, int j) { return values[std::size_t(j) * stride + i]; }
  DenseMatrix<Number> view() { return {values.data(), rows, columns, stride}; }
};

/// Half a unit of the last bit.
template <class Number>
constexpr double half_unit = std::is_same_v<Number, double> ? 0x1p-53 : 0x1p-24;

template <class Number>
class DenseKernels : public ::testing::Test {};
using KernelPrecisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(DenseKernels, KernelPrecisions);

TYPED_TEST(DenseKernels, ProductsAgreeWithSums) {
  std::mt19937 draw(3);
  std::vector<TypeParam> scratch(product_scratch());
  for (const auto& [m, n, k] :
       {std::array{1, 1, 1}, {7, 5, 3}, {16, 6, 16}, {33, 13, 40}, {200, 31, 300}, {17, 1100, 5}}) {
    Sample<TypeParam> a(m, k, draw), b(k, n, draw), c(m, n, draw);
    for (const int sign : {1, -1}) {
      Sample found = c;
      add_product(sign, a.view(), b.view(), found.view(), scratch.data());
      for (int i = 0; i < m; ++i)
        for (int j = 0; j < n; ++j) {
          long double sum = c(i, j);
          for (int l = 0; l < k; ++l) sum += (long double)(sign)*a(i, l) * b(l, j);
          ASSERT_NEAR(found(i, j), sum, 2 * half_unit<TypeParam> * (k + 10)) << m << " " << n << " " << k;
        }
      for (int j = 0; j < n; ++j)  // what lies between the columns is left alone
        for (int i = m; i < c.stride; ++i) ASSERT_EQ(found(i, j), c(i, j));
    }
  }
}

TYPED_TEST(DenseKernels, AnInverseTimesTheMatrixIsOne) {
  std::mt19937 draw(5);
  for (int n : {1, 2, 15, 16, 17, 48, 131}) {
    std::vector<TypeParam> scratch(inversion_scratch(n));
    Sample<TypeParam> a(n, n, draw), inverse(n, n, draw);
    for (int i = 0; i < n && n > 1; ++i) a(i, i) = 0;  // pivoting is needed
    Sample copy = a;
    invert(copy.view(), inverse.view(), scratch.data());
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        double sum = 0;
        for (int k = 0; k < n; ++k) sum += double(inverse(i, k)) * a(k, j);
        ASSERT_NEAR(sum, i == j ? 1 : 0, 4000 * half_unit<TypeParam>) << n;
      }
  }
}

TYPED_TEST(DenseKernels, TheInverseOfASingularMatrixIsNotFinite) {
  std::mt19937 draw(5);
  std::vector<TypeParam> scratch(inversion_scratch(40));
  for (const float entry : {0.0f, std::nanf("")}) {
    Sample<TypeParam> a(40, 40, draw), inverse(40, 40, draw);
    for (int i = 0; i < 40; ++i) a(i, 21) = entry;
    invert(a.view(), inverse.view(), scratch.data());
    double sum = 0;
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < 40; ++j) sum += std::abs(inverse(i, j));
    EXPECT_FALSE(std::isfinite(sum));
  }
}

template <class Number>
class Stored : public ::testing::Test {
 public:
  using Work = typename PackedBlock<Number>::Work;
  void place(const Sample<Work>& a) {
    block = {a.rows, a.columns};
    memory.resize(block.bytes() + 64);
    const auto address = reinterpret_cast<std::uintptr_t>(memory.data());
    block.place(memory.data() + (64 - address % 64) % 64);
    scratch.resize(a.columns);
  }
  /// Relative error of one entry: half a unit of the last bit.
  static double precision() { return std::is_same_v<Number, Half> ? 0x1p-11 : half_unit<Work>; }

  PackedBlock<Number> block;
  std::vector<std::byte> memory;
  std::vector<Work> scratch;
};
#ifdef SOFTWET_HALF
using Numbers = ::testing::Types<float, double, Half>;
#else
using Numbers = ::testing::Types<float, double>;
#endif
TYPED_TEST_SUITE(Stored, Numbers);

/// Rows and columns spread over many magnitudes; entries of one row and column over the 2^14 for which half precision
/// has all its digits.
TYPED_TEST(Stored, ProductsAreWithinTheRoundingOfTheEntries) {
  using Work = typename TestFixture::Work;
  std::mt19937 draw(11);
  std::uniform_real_distribution<double> power(-12, 12), part(-14, 0), sign(-1, 1);
  for (const auto& [m, n] :
       {std::pair{1, 1}, {3, 9}, {8, 8}, {16, 5}, {24, 7}, {31, 40}, {64, 3}, {77, 130}, {150, 61}}) {
    Sample<Work> a(m, n, draw);
    std::vector<double> row(m), column(n);
    for (double& r : row) r = std::pow(10, power(draw));
    for (double& c : column) c = std::pow(10, power(draw));
    std::vector<Work> x(n), y(PackedBlock<TypeParam>::padded(m)), z(y.size(), 2);
    for (int j = 0; j < n; ++j) {
      x[j] = static_cast<Work>(sign(draw) / column[j]);
      for (int i = 0; i < m; ++i)
        a(i, j) = static_cast<Work>(row[i] * column[j] * std::copysign(std::exp2(part(draw)), sign(draw)));
    }
    this->place(a);
    this->block.store(a.view());
    this->block.multiply(x.data(), y.data(), this->scratch.data());
    this->block.subtract(x.data(), z.data(), this->scratch.data());
    for (int i = 0; i < m; ++i) {
      long double sum = 0;
      double size = 0;
      for (int j = 0; j < n; ++j)
        sum += (long double)(a(i, j)) * x[j], size += std::abs(double(a(i, j)) * double(x[j]));
      const double sums = (n + 4) * half_unit<Work>;
      ASSERT_NEAR(y[i], sum, (this->precision() + sums) * size) << m << " " << n;
      ASSERT_NEAR(z[i], 2 - sum, (this->precision() + 2 * sums) * (size + 2)) << m << " " << n;
    }
  }
}

TYPED_TEST(Stored, TinyHugeAndZeroRowsAreKept) {
  using Work = typename TestFixture::Work;
  std::mt19937 draw(13);
  Sample<Work> a(5, 20, draw, 0.5, 1);
  const double factor[] = {1e-30, 1e30, 0, 1e-36, 1};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 20; ++j) a(i, j) *= static_cast<Work>(j == 7 ? 0 : factor[i]);
  std::vector<Work> x(20, 1), y(PackedBlock<TypeParam>::padded(5));
  this->place(a);
  this->block.store(a.view());
  this->block.multiply(x.data(), y.data(), this->scratch.data());
  for (int i = 0; i < 5; ++i) {
    double sum = 0;
    for (int j = 0; j < 20; ++j) sum += a(i, j);
    EXPECT_NEAR(y[i], sum, (this->precision() + 1e-6) * sum) << i;
  }
}

TYPED_TEST(Stored, WhatIsNotFiniteStaysSo) {
  using Work = typename TestFixture::Work;
  for (const float bad : {std::nanf(""), HUGE_VALF}) {
    std::mt19937 draw(17);
    Sample<Work> a(9, 9, draw);
    a(4, 5) = bad;
    std::vector<Work> x(9, 1), y(PackedBlock<TypeParam>::padded(9));
    this->place(a);
    this->block.store(a.view());
    this->block.multiply(x.data(), y.data(), this->scratch.data());
    EXPECT_FALSE(std::isfinite(y[4]));
  }
}

#ifdef SOFTWET_HALF
/// Against rounding by the C library: 11 significant bits, to nearest, ties to even.
TEST(StoredHalf, RoundsToElevenBits) {
  std::mt19937 draw(19);
  std::uniform_real_distribution<float> number(-1e3, 1e3);
  std::vector<std::byte> memory(1024);
  const auto address = reinterpret_cast<std::uintptr_t>(memory.data());
  for (int n = 0; n < 1000; ++n) {
    // Every other number lies half way between two of half precision.
    const float value = n % 2 ? number(draw) : std::ldexp(2.0f * (n + 1024) + 1, -12);
    int exponent = 0;
    const float fraction = std::frexp(value, &exponent);
    const float rounded = std::ldexp(std::nearbyint(std::ldexp(fraction, 11)), exponent - 11);
    PackedBlock<Half> block(1, 1);
    block.place(memory.data() + (64 - address % 64) % 64);
    block.store({&value, 1, 1, 1});
    std::vector<float> y(PackedBlock<Half>::padded(1));
    float one = 1, scratch = 0;
    block.multiply(&one, y.data(), &scratch);
    EXPECT_EQ(y[0], rounded) << value;
  }
}
#endif

}  // namespace
}  // namespace softwet
