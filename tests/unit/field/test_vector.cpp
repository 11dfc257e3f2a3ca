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
    EXPECT_NEAR(dot(alone, to_device<Array>(x), to_device<Array>(y)), static_cast<double>(sum), 1e-12) << n;
  }
  const Array x = to_device<Array>(ramp(5000, 1.1));
  EXPECT_DOUBLE_EQ(norm(alone, x) * norm(alone, x), dot(alone, x, x));
  EXPECT_EQ(dot(alone, x, x), dot(alone, x, x)) << "same bits every time";
}

TEST(Vector, CombineAddMultiply) {
  const std::vector<double> x = ramp(100, 1.1), y = ramp(100, 0.7);
  const Array a = to_device<Array>(y);
  combine(a, 2, to_device<Array>(x), -3);
  std::vector<double> r = to_host(a);
  for (int i = 0; i < 100; ++i) EXPECT_NEAR(r[i], 2 * x[i] - 3 * y[i], 1e-15);

  std::vector<double> bad(100, std::nan(""));
  const Array fresh = to_device<Array>(bad);
  combine(fresh, 2, to_device<Array>(x), 0);  // factor zero: the old values do not matter
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

/// Vectors on lines of so many columns that one process has.
VectorSpace lines_of(int columns) { return VectorSpace(cut_columns(Axis(1.0, columns - 2, 2), 0, 1)); }

// Vectors of the columns of a mesh are whole lines of columns and are summed by strips; other vectors are summed as a
// whole.
TEST(Vector, NormsOfSeveralParts) {
  const Array x = to_device<Array>(ramp(24 * 150 + 7, 1.1));
  struct Part {
    int first, last;
  };
  const std::vector<Part> whole_lines{{0, 24 * 70}, {24 * 70, 24 * 150}},
      some{{0, 24 * 70 + 1}, {24 * 150, 24 * 150 + 7}};
  const auto check = [&x](const VectorSpace& space, const std::vector<Part>& parts) {
    const std::vector<double> found = norms(space, x, parts);
    for (int p = 0; p < 2; ++p) EXPECT_EQ(found[p], norm(space, part(x, parts[p].first, parts[p].last))) << p;
  };
  check(alone, whole_lines);
  check(alone, some);
  check(lines_of(24), whole_lines);
  EXPECT_THROW(check(lines_of(24), some), std::logic_error);
}

/// A vector of the whole patch, and what each of some processes stores of it: copies of its neighbours' columns hold
/// numbers that would spoil any sum.
struct Shared {
  std::vector<VectorSpace> space;
  std::vector<Array> part;
  std::vector<double> whole;

  Shared(const Axis& axis, int ranks, int lines) : whole(ramp(axis.functions() * lines, 1.1)) {
    for (int rank = 0; rank < ranks; ++rank) {
      const Columns c = cut_columns(axis, rank, ranks);
      std::vector<double> stored(c.stored() * lines, 1e9);
      for (int l = 0; l < lines; ++l)
        for (int i = c.begin; i < c.end; ++i) stored[l * c.stored() + i] = whole[l * axis.functions() + c.function[i]];
      space.emplace_back(c);
      part.push_back(to_device<Array>(stored));
    }
  }
  /// The sum over all parts of what `sum(space, part)` finds in each.
  template <class Sum>
  double over_parts(const Sum& sum) const {
    double all = 0;
    for (std::size_t r = 0; r < part.size(); ++r) all += sum(space[r], part[r]);
    return all;
  }
};

// Parts of two meshes, for three and for two processes. Each vector has the sums of its own mesh, although the length
// of a part of the second one is a multiple of the lines of the first one, too.
TEST(Vector, TwoMeshesAtOnceHaveTheirOwnSums) {
  const Shared first(Axis(1.0, 30, 2), 3, 130), second(Axis(1.0, 52, 2), 2, 70);
  ASSERT_EQ(second.part[0].extent(0) % first.space[0].stored, 0u);
  for (const Shared* mesh : {&first, &second, &first}) {
    long double sum = 0, square = 0;
    for (double x : mesh->whole) sum += x, square += static_cast<long double>(x) * x;
    const auto add = [](const VectorSpace& s, const Array& x) { return total(s, x); };
    const auto add_squares = [](const VectorSpace& s, const Array& x) { return dot(s, x, x); };
    EXPECT_NEAR(mesh->over_parts(add), static_cast<double>(sum), 1e-9);
    EXPECT_NEAR(mesh->over_parts(add_squares), static_cast<double>(square), 1e-9);
  }
}

TEST(Vector, WeightedNorm) {
  const int lines = 150, stored = 24, size = stored * lines;
  const std::vector<double> v = ramp(size, 1.1);
  for (const VectorSpace& space : {alone, lines_of(stored)})
    for (const int shift : {0, 5}) {  // whole lines of one weight, and lines of two
      RangeFactors weights;
      weights.add(stored * 10 + shift, stored * 77, 9);
      weights.add(stored * 77, stored * 140 - shift, 0.01);
      long double sum = 0;
      for (int i = 0; i < size; ++i) sum += weights.at(i) * v[i] * v[i];
      EXPECT_NEAR(weighted_norm<double>(space, to_device<Array>(v), weights), std::sqrt(static_cast<double>(sum)),
                  1e-11);
    }
}

// Vectors of single precision are summed in double precision, so that a sum of many small parts keeps them.
TEST(Vector, SumsOfSinglePrecisionAreDouble) {
  const int n = 1 << 20;
  const ArrayOf<float> x("x", n);
  Kokkos::deep_copy(x, 1e-4f);
  const double each = static_cast<double>(1e-4f);
  EXPECT_NEAR(dot(alone, x, x) / (n * each * each), 1, 1e-12);
  EXPECT_NEAR(norm(alone, x) / (std::sqrt(n) * each), 1, 1e-12);
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
