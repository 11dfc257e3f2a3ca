// Vector algebra on lengths that are no multiples of its blocks.
#include "field/vector.hpp"

#include <gtest/gtest.h>

namespace softwet {
namespace {

std::vector<double> ramp(int n, double a) {
  std::vector<double> v(n);
  for (int i = 0; i < n; ++i) v[i] = std::sin(a * i + 0.3);
  return v;
}

TEST(Vector, RoundTrip) {
  const std::vector<double> v = ramp(37, 1.1);
  EXPECT_EQ(to_host(to_device<Array>(v)), v);
}

TEST(Vector, Dot) {
  for (const int n : {0, 1, 7, 8, 1023, 1024, 1025, 5000}) {
    const std::vector<double> x = ramp(n, 1.1), y = ramp(n, 0.7);
    long double sum = 0;
    for (int i = 0; i < n; ++i) sum += static_cast<long double>(x[i]) * y[i];
    EXPECT_NEAR(dot(to_device<Array>(x), to_device<Array>(y)), static_cast<double>(sum), 1e-12) << n;
  }
  const Array x = to_device<Array>(ramp(5000, 1.1));
  EXPECT_DOUBLE_EQ(norm(x) * norm(x), dot(x, x));
  EXPECT_EQ(dot(x, x), dot(x, x)) << "same bits every time";
}

TEST(Vector, CombineAddMultiply) {
  const std::vector<double> x = ramp(100, 1.1), y = ramp(100, 0.7);
  const Array a = to_device<Array>(y);
  combine(a, 2, to_device<Array>(x), -3);
  std::vector<double> r = to_host(a);
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(r[i], 2 * x[i] - 3 * y[i], 1e-15);

  std::vector<double> bad(100, std::nan(""));
  const Array fresh = to_device<Array>(bad);
  combine(fresh, 2, to_device<Array>(x), 0);  // factor zero: what was there does not matter
  r = to_host(fresh);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(r[i], 2 * x[i]);

  const Array b = to_device<Array>(y);
  add_scaled(b, 90, 5, to_device<Array>(std::vector<double>(x.begin(), x.begin() + 10)));
  r = to_host(b);
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(r[i], y[i] + (i < 90 ? 0 : 5 * x[i - 90]), 1e-15);

  multiply(b, to_device<Array>(std::vector<double>(100, 0.5)));
  EXPECT_EQ(to_host(b)[95], 0.5 * r[95]);
  EXPECT_EQ(to_host(part(b, 95, 97)).size(), 2u);
  EXPECT_EQ(to_host(part(b, 95, 97))[0], 0.5 * r[95]);
}

// Sums of vectors of the scene go by strips of columns; other vectors are summed as a whole. Both at once here: the first
// two parts are whole lines of 24 columns, the third one is not.
TEST(Vector, NormsOfSeveralParts) {
  const Array x = to_device<Array>(ramp(24 * 150 + 7, 1.1));
  struct Part {
    int first, last;
  };
  const std::vector<Part> parts{{0, 24 * 70}, {24 * 70, 24 * 150}, {24 * 150, 24 * 150 + 7}};
  const SumColumns before = sum_columns();
  for (const SumColumns& columns : {SumColumns{}, SumColumns{24, 0, 20, 0, 3, 3, 0, 20}}) {
    sum_columns() = columns;
    const std::vector<double> found = norms(x, parts);
    for (int p = 0; p < 3; ++p) EXPECT_EQ(found[p], norm(part(x, parts[p].first, parts[p].last))) << p;
  }
  sum_columns() = before;
}

TEST(Vector, WeightedNorm) {
  const int lines = 150, stored = 24, size = stored * lines;
  const std::vector<double> v = ramp(size, 1.1);
  const SumColumns before = sum_columns();
  for (const SumColumns& columns : {SumColumns{}, SumColumns{stored, 0, stored, 0, 3, 3, 0, stored}})
    for (const int shift : {0, 5}) {  // whole lines of one weight, and lines of two
      sum_columns() = columns;
      RangeFactors weights;
      weights.add(stored * 10 + shift, stored * 77, 9);
      weights.add(stored * 77, stored * 140 - shift, 0.01);
      long double sum = 0;
      for (int i = 0; i < size; ++i) sum += weights.at(i) * v[i] * v[i];
      EXPECT_NEAR(weighted_norm<double>(to_device<Array>(v), weights), std::sqrt(static_cast<double>(sum)), 1e-11);
    }
  sum_columns() = before;
}

// Vectors of single precision: what is added up is double, so that a sum of many small parts keeps them.
TEST(Vector, SumsOfSinglePrecisionAreDouble) {
  const int n = 1 << 20;
  const ArrayOf<float> x("x", n);
  Kokkos::deep_copy(x, 1e-4f);
  const double each = static_cast<double>(1e-4f);
  EXPECT_NEAR(dot(x, x) / (n * each * each), 1, 1e-12);
  EXPECT_NEAR(norm(x) / (std::sqrt(n) * each), 1, 1e-12);
}

TEST(Vector, SinglePrecisionRoundsOnce) {
  const std::vector<double> x = ramp(100, 1.1), y = ramp(100, 0.7);
  const Array wide = to_device<Array>(x);
  const ArrayOf<float> a("a", 100), b("b", 100);
  convert(a, wide);
  convert(b, to_device<Array>(y));
  convert(wide, a);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(to_host(wide)[i], static_cast<double>(static_cast<float>(x[i])));
  combine(a, 2, b, -3);
  add_scaled(a, 0, 0.5, b);
  multiply(a, to_device<Array>(std::vector<double>(100, 0.25)));
  convert(wide, a);
  const std::vector<double> r = to_host(wide);
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(r[i], 0.25 * (2 * y[i] - 3 * x[i] + 0.5 * y[i]), 5e-7);
}

}  // namespace
}  // namespace softwet
