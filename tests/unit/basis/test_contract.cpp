// Sum factorisation against naive sums, and its transpose property.
#include "kernels/basis/contract.hpp"

#include <gtest/gtest.h>

#include <random>

namespace softwet {
namespace {

constexpr int P = 2, Q = 3, n = P + 1;

struct Random {
  std::mt19937 engine{11};
  std::uniform_real_distribution<double> uniform{-1, 1};
  double operator()() { return uniform(engine); }
  template <int Points>
  AxisBasis<double, P, Points> basis() {
    AxisBasis<double, P, Points> b;
    for (int q = 0; q < Points; ++q)
      for (int a = 0; a < n; ++a) {
        b.value[q][a] = (*this)();
        b.slope[q][a] = (*this)();
      }
    return b;
  }
};

/// Basis function (i, j, k) at a point, differentiated along `axis` (-1: not).
template <int QX, int QY, int QZ>
double shape(const AxisBasis<double, P, QX>& x, const AxisBasis<double, P, QY>& y, const AxisBasis<double, P, QZ>& z,
             const int* local, const int* q, int axis) {
  return (axis == 0 ? x.slope : x.value)[q[0]][local[0]] * (axis == 1 ? y.slope : y.value)[q[1]][local[1]] *
         (axis == 2 ? z.slope : z.value)[q[2]][local[2]];
}

template <int QL>
void check_2d() {
  Random random;
  const auto x = random.basis<Q>();
  const auto y = random.basis<QL>();
  AxisBasis<double, P, 1> unit{{{1, 0, 0}}, {{0, 0, 0}}};
  double nodal[n * n], out[3][Q * QL], in[3][Q * QL], back[n * n], plain[n * n];
  for (double& v : nodal) v = random();
  for (auto& row : in)
    for (double& v : row) v = random();
  interpolate<true, true, double, P, Q, QL>(nodal, x, y, out);
  integrate<true, double, P, Q, QL>(in, x, y, back);
  integrate<false, double, P, Q, QL>(in, x, y, plain);
  double forward = 0, backward = 0, expected_back[n * n] = {}, expected_plain[n * n] = {};
  for (int q = 0; q < Q * QL; ++q)
    for (int c = 0; c < 3; ++c) {
      double sum = 0;
      for (int a = 0; a < n * n; ++a) {
        const int local[3] = {a % n, a / n, 0}, point[3] = {q % Q, q / Q, 0};
        const double b = shape(x, y, unit, local, point, c - 1);
        sum += b * nodal[a];
        expected_back[a] += b * in[c][q];
        if (c == 0) expected_plain[a] += b * in[c][q];
      }
      EXPECT_NEAR(out[c][q], sum, 1e-14);
      forward += out[c][q] * in[c][q];
    }
  for (int a = 0; a < n * n; ++a) {
    EXPECT_NEAR(back[a], expected_back[a], 1e-14);
    EXPECT_NEAR(plain[a], expected_plain[a], 1e-14);
    backward += back[a] * nodal[a];
  }
  EXPECT_NEAR(forward, backward, 1e-13);
}

template <int QL>
void check_3d() {
  Random random;
  const auto x = random.basis<Q>(), y = random.basis<Q>();
  const auto z = random.basis<QL>();
  constexpr int points = Q * Q * QL, controls = n * n * n;
  double nodal[controls], out[4][points], in[4][points], back[controls], plain[controls];
  for (double& v : nodal) v = random();
  for (auto& row : in)
    for (double& v : row) v = random();
  interpolate<true, true, double, P, Q, QL>(nodal, x, y, z, out);
  integrate<true, double, P, Q, QL>(in, x, y, z, back);
  integrate<false, double, P, Q, QL>(in, x, y, z, plain);
  double forward = 0, backward = 0, expected_back[controls] = {}, expected_plain[controls] = {};
  for (int q = 0; q < points; ++q)
    for (int c = 0; c < 4; ++c) {
      double sum = 0;
      for (int a = 0; a < controls; ++a) {
        const int local[3] = {a % n, a / n % n, a / n / n}, point[3] = {q % Q, q / Q % Q, q / Q / Q};
        const double b = shape(x, y, z, local, point, c - 1);
        sum += b * nodal[a];
        expected_back[a] += b * in[c][q];
        if (c == 0) expected_plain[a] += b * in[c][q];
      }
      EXPECT_NEAR(out[c][q], sum, 1e-14);
      forward += out[c][q] * in[c][q];
    }
  for (int a = 0; a < controls; ++a) {
    EXPECT_NEAR(back[a], expected_back[a], 3e-14);
    EXPECT_NEAR(plain[a], expected_plain[a], 3e-14);
    backward += back[a] * nodal[a];
  }
  EXPECT_NEAR(forward, backward, 1e-12);
}

TEST(Contract, VolumeIn2D) { check_2d<3>(); }
TEST(Contract, FaceIn2D) { check_2d<1>(); }
TEST(Contract, VolumeIn3D) { check_3d<3>(); }
TEST(Contract, FaceIn3D) { check_3d<1>(); }

TEST(Contract, Power) {
  EXPECT_EQ(power(3, 0), 1);
  EXPECT_EQ(power(3, 3), 27);
}

}  // namespace
}  // namespace softwet
