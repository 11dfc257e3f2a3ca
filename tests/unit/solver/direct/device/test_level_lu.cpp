// LU that lives on the device: its solutions against the matrix and against the LU of the host, and what it asks of the
// device.
#include "solver/direct/device/level_lu.hpp"

#include <cmath>
#include <cstring>

#include "allocations.hpp"
#include "solver/choose.hpp"
#include "solver/direct/device/level_scale.hpp"
#include "solver/direct/dissection.hpp"
#include "solver/krylov/gmres.hpp"
#include "solver/matrix/equilibration.hpp"
#include "unit/scene/scenes.hpp"
#include "unit/solver/random_matrix.hpp"

namespace softwet::testing_tools {
namespace {

std::vector<Shape> level_shapes() {
  return {{{6, 8}, 3},       // one leaf and its separator
          {{31, 18}, 7},     // coupled
          {{23, 12}, 0},     // rigid
          {{20, 9}, 9},      // a solid alone
          {{17, 12}, 4, 3},  // cubic
          {{23, 12}, 0, 2, true},
          {{19, 10}, 3, 3, true},
          {{3, 4}, 0, 2, true},  // so short that offsets coincide
          {{4, 7}, 2, 2, true},
          {{5, 4}, 0, 3, true}};
}

template <int D>
DenseVector level_answer(StencilSolver<D>& solver, const DenseVector& r) {
  const Array z("z", r.size());
  Kokkos::deep_copy(z, 7.0);
  solver.apply(to_array(r), z);
  return to_vector(z);
}

/// || A M^-1 r - r || / || r || for random matrices, which are well conditioned; prescribed values are copied.
template <int D>
void check_level_lu(const Shape& shape) {
  RandomMatrix<D> random(shape);
  const auto lu = make_level_lu<D>(random.layout, random.mask);
  const auto host = make_block_lu<D>(random.layout, random.mask, FactorPrecision::single);
  const DenseVector free = to_vector(random.mask);
  const double counted = lu->bytes();
  for (int build = 0; build < 2; ++build) {
    lu->build(random.matrix);
    host->build(random.matrix);
    DenseVector r = random.direction();
    for (int i = 0; i < r.size(); ++i)
      if (free[i] == 0) r[i] = 3 + i;
    const DenseVector z = level_answer(*lu, r), inside = free.cwiseProduct(r), solved = free.cwiseProduct(z);
    EXPECT_LT(relative(sparse(random.matrix) * solved, inside), 2e-5) << "build " << build;
    EXPECT_EQ((z - solved - r + inside).norm(), 0) << "prescribed values and ghosts";
    EXPECT_LT(relative(z, level_answer(*host, r)), 2e-5) << "build " << build;
    random.fill();
  }
  EXPECT_EQ(lu->bytes(), counted) << "the memory is known before it is taken";
}

TEST(LevelLu, SolvesInThePlane) {
  for (const Shape& shape : level_shapes()) check_level_lu<2>(shape);
}

/// The last one has a leaf with more unknowns than a team multiplies at once.
TEST(LevelLu, SolvesInSpace) {
  for (const Shape& shape : {Shape{{6, 5, 4}, 2}, Shape{{6, 4, 4}, 4}, Shape{{7, 5, 4}, 0, 2, true},
                             Shape{{6, 3, 5}, 2, 2, true}, Shape{{4, 4, 3}, 1, 3}})
    check_level_lu<3>(shape);
}

/// Rounding errors grow by the condition of the fronts; half of the digits of single precision remain (as for BlockLu).
TEST(LevelLu, SolvesScenesAsTheLuOfTheHostDoes) {
  for (const Case& c :
       {small_case(SceneKind::coupled), small_case(SceneKind::rigid), small_case(SceneKind::solid),
        small_case(SceneKind::rigid, WallLaw::energy, true), small_case(SceneKind::coupled, WallLaw::gradient, true)}) {
    RandomScene s(c);
    StencilMatrix<2> matrix(s.layout(), s.scene.mask());
    matrix.fill(s.jacobian());
    const Array direction = s.direction(), product("product", s.layout().size()), found("found", s.layout().size());
    matrix.multiply(direction, product);
    const auto lu = make_level_lu<2>(s.layout(), s.scene.mask());
    lu->build(matrix);
    lu->apply(product, found);
    EXPECT_LT(distance(to_host(found), to_host(direction)), 1e-3);
  }
}

TEST(LevelLu, GmresReachesFullPrecisionInFewIterations) {
  Case c = small_case(SceneKind::coupled);
  c.domain.elements = {31, 18};
  RandomScene s(c);
  const auto iterations = [&](std::unique_ptr<StencilSolver<2>> solver) {
    Assembled<2> p(s.layout(), s.scene.mask(), std::move(solver));
    p.build(s.jacobian());
    const Array b = to_device<Array>(s.product(s.direction(), Geometry::frozen)), x("x", s.layout().size());
    const KrylovResult result =
        Gmres(s.layout().space(), s.layout().size(), 30)
            .solve([&](const Array& z,
                       const Array& out) { s.scene.equations().product(s.stage(), z, out, Geometry::frozen); },
                   [&](const Array& r, const Array& z) { p.apply(r, z); }, b, x, 1e-12, 30);
    EXPECT_TRUE(result.converged);
    return result.iterations;
  };
  const int host = iterations(make_block_lu<2>(s.layout(), s.scene.mask(), FactorPrecision::single));
  EXPECT_LE(iterations(make_level_lu<2>(s.layout(), s.scene.mask())), host + 1);
}

TEST(LevelLu, TheThreadsOfATeamDoNotMatter) {
  const int threads = on_host ? std::min(3, Exec().concurrency()) : 4;
  if (threads < 2) GTEST_SKIP() << "one thread alone";
  RandomMatrix<2> random({{31, 18}, 7});
  const DenseVector r = random.direction();
  const auto answer = [&](int count) {
    const auto lu = make_level_lu<2>(random.layout, random.mask, count);
    lu->build(random.matrix);
    return level_answer(*lu, r);
  };
  EXPECT_EQ((answer(1) - answer(threads)).norm(), 0);
  EXPECT_EQ((answer(0) - answer(threads)).norm(), 0);
}

/// What tools of Kokkos see while this lives.
class LevelCounts {
 public:
  LevelCounts() {
    namespace tools = Kokkos::Tools::Experimental;
    arrays = kernels = waits = 0;
    tools::set_allocate_data_callback(
        [](Kokkos::Tools::SpaceHandle, const char*, const void*, std::uint64_t) { ++arrays; });
    tools::set_begin_parallel_for_callback([](const char*, std::uint32_t, std::uint64_t* id) {
      *id = 0;
      ++kernels;
    });
    tools::set_begin_fence_callback([](const char* name, std::uint32_t, std::uint64_t* id) {
      *id = 0;
      if (std::strncmp(name, "Kokkos::Tools", 13) != 0) ++waits;  // those are for the sake of who listens
    });
  }
  ~LevelCounts() { Kokkos::Tools::Experimental::set_callbacks(before_); }
  LevelCounts(const LevelCounts&) = delete;
  LevelCounts& operator=(const LevelCounts&) = delete;
  static inline long arrays, kernels, waits;  ///< a blocking copy waits too

 private:
  Kokkos::Tools::Experimental::EventSet before_ = Kokkos::Tools::Experimental::get_callbacks();
};

TEST(LevelLu, ASecondBuildAndAnApplicationAllocateNothingAndWaitForNothing) {
  RandomMatrix<2> random({{40, 24}, 7});
  const auto lu = make_level_lu<2>(random.layout, random.mask);
  const Array r = to_array(random.direction()), z("z", random.layout.size());
  lu->build(random.matrix);
  lu->apply(r, z);  // the memory that teams share grows with the first launch that needs so much
  const int levels =
      static_cast<int>(dissect(random.layout, UnknownTable<2>(random.layout, to_host(random.mask)), 64).levels.size());
  ASSERT_GT(levels, 3);
  const LevelCounts counts;
  large_allocations = 0;
  lu->build(random.matrix);
  EXPECT_EQ(large_allocations, 0);
  EXPECT_EQ(counts.arrays, 0);
  EXPECT_EQ(counts.waits, 0);
  counts.kernels = large_allocations = 0;
  lu->apply(r, z);
  EXPECT_EQ(large_allocations, 0);
  EXPECT_EQ(counts.arrays, 0);
  EXPECT_EQ(counts.waits, 0);
  EXPECT_EQ(counts.kernels, 2 * levels - 1) << "two for a level, but one for the root";
}

TEST(LevelLu, ASingularMatrixGivesNoNumbers) {
  RandomMatrix<2> random({{23, 12}, 4});
  const auto lu = make_level_lu<2>(random.layout, random.mask);
  const DenseVector r = random.direction();
  for (const float entry : {0.0f, std::nanf("")}) {
    random.matrix.fill([&](const StencilValues& values) { Kokkos::deep_copy(values, entry); });
    lu->build(random.matrix);
    EXPECT_FALSE(std::isfinite(level_answer(*lu, r).sum()));
  }
}

TEST(LevelLu, IsTheLuOfADevice) {
  RandomMatrix<2> plane({{20, 9}, 3});
  const auto chosen = choose_preconditioner<2>(PreconditionerKind::automatic, plane.layout, plane.mask);
  const auto lu =
      host_algorithms ? make_block_lu<2>(plane.layout, plane.mask) : make_level_lu<2>(plane.layout, plane.mask);
  EXPECT_EQ(chosen->name(), "lu");
  EXPECT_EQ(chosen->bytes(), plane.matrix.bytes() + lu->bytes());
  RandomMatrix<3> space({{8, 8, 8}, 3});
  EXPECT_EQ(choose_preconditioner<3>(PreconditionerKind::automatic, space.layout, space.mask)->name(), "schwarz");
  RandomMatrix<3> small({{5, 4, 4}, 2});
  EXPECT_EQ(choose_preconditioner<3>(PreconditionerKind::automatic, small.layout, small.mask)->name(), "lu");
}

template <int D>
void check_scale(const Shape& shape) {
  RandomMatrix<D> random(shape);
  const UnknownTable<D> table(random.layout, to_host(random.mask));
  Equilibration expected;
  Equilibrator<D>(random.layout, table)
      .compute(Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), random.matrix.values()), expected);
  const LevelScale<D> scale(random.layout, table);
  scale.compute(random.matrix.values());
  const auto row = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), scale.row());
  const auto column = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), scale.column());
  for (int i = 0; i < random.layout.size(); ++i) {
    ASSERT_EQ(row(i), expected.row[i]) << i;
    ASSERT_EQ(column(i), expected.column[i]) << i;
  }
}

TEST(LevelLu, ScalesAsTheHostDoes) {
  for (const Shape& shape : level_shapes()) check_scale<2>(shape);
  for (const Shape& shape : shapes_3d()) check_scale<3>(shape);
}

}  // namespace
}  // namespace softwet::testing_tools
