// Preconditioners whose kernels are recorded. Without a device the recorded kernels start one by one: then these tests
// show what is recorded and when, and whether a recording may stand for an answer.
#include "cli/core/kernel_counts.hpp"
#include "field/vector.hpp"
#include "solver/choose.hpp"
#include "solver/recorded_answers.hpp"
#include "unit/solver/random_matrix.hpp"

namespace softwet::testing_tools {
namespace {

/// z = scale r, where a build takes a scale from outside.
class Multiple final : public Preconditioner {
 public:
  explicit Multiple(const double& next) : next_(next) {}
  void build(const Jacobian&) override { scale_ = next_; }
  void apply(const ConstArray& r, const Array& z) override { combine(z, scale_, r, 0); }
  std::string name() const override { return "multiple"; }
  double bytes() const override { return 7; }
  double build_cost() const override { return 11; }
  bool recordable() const override { return true; }

 private:
  const double& next_;
  double scale_ = 0;
};

struct Recorded : ::testing::Test {
  static constexpr int n = 6;
  double scale = 2;
  RecordedAnswers recorded{std::make_unique<Multiple>(scale)};
  Array r{"r", n}, z{"z", n}, other{"other", n};
  RangeFactors factors;

  void SetUp() override {
    Kokkos::deep_copy(r, 1.0);
    factors.add(0, 2, 3);
    recorded.build({});
  }
  std::vector<double> answer(const Array& to, const RangeFactors& f = {}) {
    Kokkos::deep_copy(to, -1.0);
    recorded.answer(r, to, f);
    return to_host(to);
  }
};

TEST_F(Recorded, TheSecondAnswerOfAPairOfVectorsIsRecorded) {
  EXPECT_EQ(answer(z), std::vector<double>(n, 2));
  EXPECT_EQ(recorded.recordings(), 0);
  EXPECT_EQ(answer(z), std::vector<double>(n, 2));
  EXPECT_EQ(recorded.recordings(), 1);
  answer(other);
  EXPECT_EQ(recorded.recordings(), 1);
  EXPECT_EQ(answer(other), std::vector<double>(n, 2));
  EXPECT_EQ(recorded.recordings(), 2);
  Kokkos::deep_copy(r, 4.0);  // the recorded vectors with other numbers
  EXPECT_EQ(answer(z), std::vector<double>(n, 8));
}

TEST_F(Recorded, FactorsAreThoseOfNow) {
  answer(z, factors);
  EXPECT_EQ(answer(z, factors), (std::vector<double>{6, 6, 2, 2, 2, 2}));
  EXPECT_EQ(answer(z), std::vector<double>(n, 2));
  factors.factor[0] = 5;
  EXPECT_EQ(answer(z, factors), (std::vector<double>{10, 10, 2, 2, 2, 2}));
  EXPECT_EQ(recorded.recordings(), 1);
}

/// A build may choose other inverses and other numbers of teams: arguments of kernels.
TEST_F(Recorded, ABuildForgetsAllRecordings) {
  answer(z);
  answer(z);
  scale = 5;
  recorded.build({});
  EXPECT_EQ(recorded.recordings(), 0);
  EXPECT_EQ(answer(z), std::vector<double>(n, 5));
  EXPECT_EQ(recorded.recordings(), 1);
}

TEST_F(Recorded, WhileAToolListensKernelsStartOneByOne) {
  answer(z);
  KernelCounter counter;
  recorded.answer(r, z, {});
  EXPECT_EQ(counter.stop().kernels, 1);
  EXPECT_EQ(recorded.recordings(), 0);
}

TEST_F(Recorded, ItIsOtherwiseThePreconditionerThatItRecords) {
  EXPECT_EQ(recorded.name(), "multiple");
  EXPECT_EQ(recorded.bytes(), 7);
  EXPECT_EQ(recorded.build_cost(), 11);
  recorded.apply(r, z);
  EXPECT_EQ(to_host(z), std::vector<double>(n, 2));
}

TEST(Recordings, BeyondTheMostAllAreForgotten) {
  Recordings<int> recordings(2);
  int started = 0;
  const auto start = [&](int key) {
    const bool ready = recordings.ready(key);
    if (ready) recordings.start(key, [&started, key] { started = key; });
    return ready;
  };
  EXPECT_FALSE(start(1));
  EXPECT_FALSE(start(2));
  EXPECT_TRUE(start(1));
  EXPECT_EQ(started, 1);
  EXPECT_EQ(recordings.count(), 1);
  EXPECT_FALSE(start(3));
  EXPECT_EQ(recordings.count(), 0);
  EXPECT_FALSE(start(1));
  EXPECT_TRUE(start(1));
}

TEST(RecordAnswers, LeavesOutWhatWorksOnTheHost) {
  RandomMatrix<2> m({{16, 12}, 4});
  const auto recorded = [&](PreconditionerKind name) {
    return dynamic_cast<RecordedAnswers*>(record_answers(choose_preconditioner<2>(name, m.layout, m.mask)).get()) !=
           nullptr;
  };
  EXPECT_FALSE(recorded(PreconditionerKind::none));
  EXPECT_EQ(recorded(PreconditionerKind::lu), !host_algorithms);
  EXPECT_EQ(recorded(PreconditionerKind::schwarz), !host_algorithms);
}

/// The second and third answer of the first build, and all of the second one, are recorded: on a device as graphs.
template <class Real>
void expect_same_bits(PreconditionerKind name, RandomMatrix<2>& m) {
  const Jacobian jacobian = [&](const StencilValues& values) {
    Kokkos::deep_copy(values, Kokkos::subview(m.matrix.values(), Kokkos::make_pair(std::size_t(0), values.extent(0))));
  };
  const int n = m.layout.size();
  const ArrayOf<Real> r("r", n), z("z", n), plain("plain", n);
  const Array wide("wide", n), expected("expected", n);
  const auto one_by_one = choose_preconditioner<2>(name, m.layout, m.mask);
  const auto recorded = record_answers(choose_preconditioner<2>(name, m.layout, m.mask));
  for (int builds = 0; builds < 2; ++builds) {
    one_by_one->build(jacobian);
    recorded->build(jacobian);
    for (int answers = 0; answers < 3; ++answers) {
      convert(r, to_array(m.direction()));
      one_by_one->answer(r, plain, {});
      recorded->answer(r, z, {});
      convert(expected, plain);
      convert(wide, z);
      EXPECT_EQ(to_host(wide), to_host(expected)) << word_of(name) << ", build " << builds << ", answer " << answers;
    }
  }
}

TEST(RecordAnswers, KeepTheirBits) {
  if (host_algorithms) GTEST_SKIP() << "on the host nothing is recorded";
  RandomMatrix<2> m({{32, 24}, 8});
  for (const PreconditionerKind name : {PreconditionerKind::lu, PreconditionerKind::schwarz}) {
    expect_same_bits<double>(name, m);
    expect_same_bits<float>(name, m);
  }
}

/// What a device cannot record is a wait, a copy between memories, and an allocation.
template <class Real>
void expect_recordable(StencilSolver<2>& solver, RandomMatrix<2>& m) {
  EXPECT_TRUE(solver.recordable());
  solver.build(m.matrix);
  const int n = m.layout.size();
  const ArrayOf<Real> r("r", n), z("z", n), again("again", n);
  convert(r, to_array(m.direction()));
  solver.answer(r, z, {});
  KernelCounter counter;
  solver.answer(r, again, {});
  const KernelCounts counts = counter.stop();
  EXPECT_GT(counts.kernels, 0);
  EXPECT_EQ(counts.copies, 0);
  EXPECT_EQ(counts.waits, 0);
  EXPECT_EQ(counts.allocations, 0);
}

TEST(RecordAnswers, LuOfADeviceOnlyStartsKernels) {
  RandomMatrix<2> m({{32, 24}, 8});
  const auto lu = make_level_lu<2>(m.layout, m.mask);
  expect_recordable<double>(*lu, m);
  expect_recordable<float>(*lu, m);
}

TEST(RecordAnswers, SchwarzOfADeviceOnlyStartsKernels) {
  if (host_algorithms) GTEST_SKIP() << "on the host vectors go between levels axis by axis";
  RandomMatrix<2> m({{32, 24}, 8});
  SchwarzControl control = SchwarzControl::for_dimension(2);
  for (const bool multiplicative : {false, true})
    for (const int direct : {300, 100000}) {
      control.multiplicative = multiplicative;
      control.direct_up_to = direct;
      const auto schwarz = make_schwarz<2>(m.layout, m.mask, control);
      expect_recordable<double>(*schwarz, m);
      expect_recordable<float>(*schwarz, m);
    }
}

}  // namespace
}  // namespace softwet::testing_tools
