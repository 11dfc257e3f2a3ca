// The dense inverse of a whole matrix, and Schwarz as a device computes it, against factors of the same matrix.
#include "solver/direct/device/dense_solver.hpp"

#include <Eigen/SparseLU>

#include "solver/schwarz/schwarz.hpp"
#include "unit/solver/random_matrix.hpp"

namespace softwet::testing_tools {
namespace {

/// A x = r for free unknowns; prescribed ones and ghosts are zero.
template <int D>
DenseVector solve_by_factors(const RandomMatrix<D>& random, const DenseVector& r) {
  Sparse a = sparse(random.matrix);
  const std::vector<double> free = to_host(random.mask);
  for (int i = 0; i < a.rows(); ++i)
    if (free[i] == 0) a.coeffRef(i, i) = 1;
  a.makeCompressed();
  const Eigen::SparseMatrix<double> columns = a;
  return Eigen::SparseLU<Eigen::SparseMatrix<double>>(columns).solve(r);
}

template <int D>
void check_dense(const Shape& shape) {
  RandomMatrix<D> random(shape);
  const auto solver = make_dense_solver<D>(random.layout, random.mask);
  const double counted = solver->bytes();
  const Array z("z", random.layout.size());
  for (int build = 0; build < 2; ++build) {
    solver->build(random.matrix);
    const DenseVector r = random.direction();
    Kokkos::deep_copy(z, 7.0);
    solver->apply(to_array(r), z);
    EXPECT_LT(relative(to_vector(z), solve_by_factors(random, r)), 2e-5) << "build " << build;
    random.fill();
  }
  EXPECT_EQ(solver->bytes(), counted) << "the memory is known before it is taken";
}

TEST(DenseSolver, InvertsTheMatrix) {
  for (const Shape& shape : {Shape{{6, 8}, 3}, Shape{{5, 6}, 0}, Shape{{7, 4}, 4}, Shape{{9, 6}, 2, 3, true}})
    check_dense<2>(shape);
  check_dense<3>({{4, 4, 5}, 2});
}

template <int D>
void check_schwarz(const Shape& shape, SchwarzControl control) {
  RandomMatrix<D> random(shape);
  const DenseVector r = random.direction();
  const auto answer = [&](bool dense) {
    control.dense_bottom = dense;
    const auto solver = make_schwarz<D>(random.layout, random.mask, control);
    solver->build(random.matrix);
    const Array z("z", random.layout.size());
    solver->apply(to_array(r), z);
    return to_vector(z);
  };
  EXPECT_LT(relative(answer(true), answer(false)), 2e-3) << "factors may be read in half precision";
}

TEST(DenseSolver, AsTheCoarsestLevelOfSchwarz) {
  check_schwarz<2>({{32, 16}, 4}, {.width = 6, .stride = 5, .direct_up_to = 600});
  check_schwarz<2>({{24, 16}, 0, 2, true}, {.width = 6, .stride = 5, .direct_up_to = 4000});
  check_schwarz<3>({{8, 8, 8}, 4}, {.width = 4, .stride = 3, .direct_up_to = 1500});
}

}  // namespace
}  // namespace softwet::testing_tools
