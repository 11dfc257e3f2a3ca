// Answers of preconditioners in either precision, times factors, and the kernels that they take.
#include "cli/core/kernel_counts.hpp"
#include "field/vector.hpp"
#include "solver/direct/device/level_lu.hpp"
#include "solver/direct/host/block_lu.hpp"
#include "solver/schwarz/schwarz.hpp"
#include "unit/solver/random_matrix.hpp"

namespace softwet::testing_tools {
namespace {

constexpr SchwarzControl usual{.width = 5, .stride = 3, .share = 0.1f, .dense_bottom = true};

SchwarzControl changed(const std::function<void(SchwarzControl&)>& change) {
  SchwarzControl control = usual;
  change(control);
  return control;
}

RangeFactors some_factors(int size) {
  RangeFactors factors;
  factors.add(0, size / 5, 0.25);
  factors.add(size / 3, size / 2, 3);
  return factors;
}

/// Both precisions against `apply`, which is double and without factors.
template <int D>
void expect_answers(StencilSolver<D>& solver, RandomMatrix<D>& m) {
  const int n = m.layout.size();
  const RangeFactors factors = some_factors(n);
  solver.build(m.matrix);
  const ArrayOf<float> r("r", n), z("z", n);
  const Array wide("wide", n), plain("plain", n), found("found", n);
  convert(r, to_array(m.direction()));
  convert(wide, r);  // what both precisions have
  solver.apply(wide, plain);
  DenseVector expected = to_vector(plain);
  EXPECT_GT(expected.norm(), 0);
  for (int i = 0; i < n; ++i) expected[i] *= factors.at(i);
  solver.answer(wide, found, factors);
  EXPECT_LT(relative(to_vector(found), expected), 1e-14);
  solver.answer(r, z, factors);
  convert(found, z);
  EXPECT_LT(relative(to_vector(found), expected), 1e-6);
}

template <int D>
void expect_answers_of_all(const Shape& shape) {
  RandomMatrix<D> m(shape);
  const auto schwarz = [&](const SchwarzControl& control) {
    expect_answers<D>(*make_schwarz<D>(m.layout, m.mask, control), m);
  };
  schwarz(usual);
  schwarz(changed([](SchwarzControl& c) { c.coarse = false; }));
  schwarz(changed([](SchwarzControl& c) { c.multiplicative = true; }));
  schwarz(changed([](SchwarzControl& c) { c.direct_up_to = 100; }));
  expect_answers<D>(*make_block_lu<D>(m.layout, m.mask), m);
  expect_answers<D>(*make_level_lu<D>(m.layout, m.mask), m);
}

TEST(Answers, AreThoseOfApplyTimesFactors) {
  expect_answers_of_all<2>({{16, 12}, 4});
  expect_answers_of_all<2>({{16, 12}, 0, 2, true});
  expect_answers_of_all<3>({{8, 6, 6}, 2});
}

/// Without factors nothing is multiplied, and the bits are equal to the bits of `apply`.
TEST(Answers, WithoutFactorsTheyAreThoseOfApply) {
  RandomMatrix<2> m({{16, 12}, 4});
  const auto solver = make_schwarz<2>(m.layout, m.mask, usual);
  solver->build(m.matrix);
  const Array r = to_array(m.direction()), z("z", m.layout.size()), again("again", m.layout.size());
  solver->apply(r, z);
  solver->answer(r, again, {});
  EXPECT_EQ(to_host(z), to_host(again));
}

/// On a small scene a launch takes as long as the work of a kernel.
template <class Real>
long kernels_of_an_answer(const SchwarzControl& control) {
  RandomMatrix<2> m({{32, 24}, 8});
  const auto solver = make_schwarz<2>(m.layout, m.mask, control);
  solver->build(m.matrix);
  const ArrayOf<Real> r("r", m.layout.size()), z("z", m.layout.size());
  KernelCounter counter;
  solver->answer(r, z, some_factors(m.layout.size()));
  return counter.stop().kernels;
}

TEST(Answers, OfTwoLevelsTakeThreeKernelsOnADevice) {
  if (host_algorithms) GTEST_SKIP() << "on the host vectors go between levels axis by axis";
  EXPECT_EQ(kernels_of_an_answer<double>(usual), 3);
  EXPECT_EQ(kernels_of_an_answer<float>(usual), 3);
}

/// A level between the finest and the coarsest one restricts, takes what its matrix makes of the correction from the
/// residual, multiplies with the boxes' inverses, and adds up.
TEST(Answers, OfAFurtherLevelTakeFourKernelsMoreOnADevice) {
  if (host_algorithms) GTEST_SKIP() << "on the host vectors go between levels axis by axis";
  const SchwarzControl three_levels = changed([](SchwarzControl& c) { c.direct_up_to = 300; });
  EXPECT_EQ(kernels_of_an_answer<double>(three_levels), 3 + 4);
  EXPECT_EQ(kernels_of_an_answer<float>(three_levels), 3 + 4);
}

/// Boxes without a level below take two.
TEST(Answers, OfBoxesAloneTakeTwoKernels) {
  const SchwarzControl boxes = changed([](SchwarzControl& c) { c.coarse = false; });
  RandomMatrix<2> m({{16, 12}, 4});
  const auto solver = make_schwarz<2>(m.layout, m.mask, boxes);
  solver->build(m.matrix);
  const Array r("r", m.layout.size()), z("z", m.layout.size());
  KernelCounter counter;
  solver->apply(r, z);
  EXPECT_EQ(counter.stop().kernels, 2);
}

}  // namespace
}  // namespace softwet::testing_tools
