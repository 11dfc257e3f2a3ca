// Multilevel Schwarz in three dimensions and its parts, against their definitions in double precision.
#include "solver/direct/host/block_lu.hpp"
#include "solver/krylov/gmres.hpp"
#include "solver/schwarz/boxes.hpp"
#include "solver/schwarz/patches.hpp"
#include "solver/schwarz/schwarz.hpp"
#include "unit/solver/random_matrix.hpp"

namespace softwet::testing_tools {
namespace {

using RandomCase = RandomMatrix<3>;

TEST(Multilevel3d, ProductOfTheMatrix) {
  for (const Shape& shape : shapes_3d()) {
    RandomCase r(shape);
    const DenseVector x = r.direction();
    const Array y("y", r.layout.size());
    r.matrix.multiply(to_array(x), y);
    EXPECT_LT(relative(to_vector(y), sparse(r.matrix) * x), 1e-6);
  }
}

TEST(Multilevel3d, TransfersAndGalerkinProduct) {
  for (const Shape& shape : shapes_3d()) {
    RandomCase r(shape);
    CoarseSpace<3> space(r.layout, r.mask, 2);
    const Sparse p = prolongation(r.layout, r.mask, space, 2);
    StencilMatrix<3> coarse(space.layout(), space.mask());
    const Array up("up", r.layout.size()), down("down", space.layout().size());
    for (int build = 0; build < 2; ++build) {
      const DenseVector x = r.direction(), y = p.transpose() * r.direction();
      space.restrict_to(to_array(x), down);
      EXPECT_LT(relative(to_vector(down), p.transpose() * x), 1e-14);
      space.prolong(to_array(y), up);
      EXPECT_LT(relative(to_vector(up), p * y), 1e-14);
      coarse.fill([&](const StencilValues& values) { space.galerkin(r.matrix, values); });
      const Sparse expected = p.transpose() * sparse(r.matrix) * p;
      EXPECT_LT((sparse(coarse) - expected).norm(), 1e-6 * expected.norm());
      r.fill();  // a second build uses the first one's buffers
    }
  }
}

/// Sum over boxes of W A_b^-1 W r.
DenseVector boxes_by_definition(const Layout<3>& layout, const ConstArray& mask, const Sparse& a, int width, int stride,
                                const DenseVector& r) {
  const PatchTables t = make_patches(layout, UnknownTable<3>(layout, to_host(mask)), width, stride);
  DenseVector times = DenseVector::Zero(layout.size()), z = DenseVector::Zero(layout.size());
  for (int i = 0; i < layout.size(); ++i) times[i] = t.grouped[i + 1] - t.grouped[i];
  for (int box = 0; box < t.count; ++box) {
    const int n = t.size[box];
    const int* dof = &t.dof[static_cast<std::size_t>(box) * t.unknowns];
    std::vector<int> local(layout.size(), -1);
    DenseVector b(n);
    for (int i = 0; i < n; ++i) {
      local[dof[i]] = i;
      b[i] = r[dof[i]] / std::sqrt(times[dof[i]]);
    }
    Eigen::MatrixXd block = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i)
      for (Sparse::InnerIterator e(a, dof[i]); e; ++e)
        if (local[e.col()] >= 0) block(i, local[e.col()]) = e.value();
    const DenseVector x = block.partialPivLu().solve(b);
    for (int i = 0; i < n; ++i) z[dof[i]] += x[i] / std::sqrt(times[dof[i]]);
  }
  return z;
}

/// Inverses in 16 bits leave 2^-9 of each entry.
constexpr double of_sixteen_bits = 4e-3;

TEST(Multilevel3d, Boxes) {
  for (const Shape& shape : shapes_3d())
    for (const auto& [width, stride] : {std::pair{4, 3}, {3, 2}}) {
      RandomCase r(shape);
      Boxes<3> boxes(r.layout, r.mask, width, stride);
      for (int build = 0; build < 2; ++build) {
        const DenseVector x = r.direction(), start = r.direction();
        const Array z = to_array(start);
        boxes.build(r.matrix);
        boxes.add(to_array(x), z, 0.5f);
        const DenseVector expected =
            start + 0.5 * boxes_by_definition(r.layout, r.mask, sparse(r.matrix), width, stride, x);
        EXPECT_LT(relative(to_vector(z), expected), of_sixteen_bits);
        r.fill();
      }
    }
}

/// The definition in solver/schwarz/schwarz.hpp, level by level. The coarsest one is solved exactly.
DenseVector schwarz_by_definition(const Layout<3>& layout, const ConstArray& mask, const Sparse& a, int levels,
                                  bool finest, const DenseVector& r) {
  const CoarseSpace<3> space(layout, mask, 4);
  const Sparse p = prolongation(layout, mask, space, 4), below = p.transpose() * a * p;
  const DenseVector down = p.transpose() * r;
  DenseVector correction;
  if (levels > 2) {
    correction = schwarz_by_definition(space.layout(), space.mask(), below, levels - 1, false, down);
  } else {
    Eigen::MatrixXd full = below;
    for (int i = 0; i < full.rows(); ++i)
      if (full.row(i).isZero()) full(i, i) = 1;  // prescribed
    correction = full.partialPivLu().solve(down);
  }
  const DenseVector z = p * correction;
  if (finest) return z + boxes_by_definition(layout, mask, a, 4, 3, r);
  return z + 0.5 * boxes_by_definition(layout, mask, a, 4, 3, r - a * z);
}

TEST(Multilevel3d, SchwarzOfThreeLevels) {
  const SchwarzControl control{.width = 4, .stride = 3, .direct_up_to = 1400};
  for (const Shape& shape : {Shape{{16, 4, 4}, 0}, {{16, 4, 6}, 6}, {{16, 4, 4}, 0, 2, true}, {{16, 4, 4}, 2}}) {
    RandomCase r(shape);
    const auto schwarz = make_schwarz<3>(r.layout, r.mask, control);
    const Array z("z", r.layout.size());
    for (int build = 0; build < 2; ++build) {
      const DenseVector x = r.direction();
      schwarz->build(r.matrix);
      schwarz->apply(to_array(x), z);
      EXPECT_LT(relative(to_vector(z), schwarz_by_definition(r.layout, r.mask, sparse(r.matrix), 3, true, x)),
                of_sixteen_bits);
      r.fill();
    }
  }
}

TEST(Multilevel3d, GmresFindsTheAnswerOfBlockLu) {
  RandomCase r({{16, 8, 4}, 2});
  const Array b = to_array(r.direction()), x("x", r.layout.size()), expected("expected", r.layout.size());
  const auto lu = make_block_lu<3>(r.layout, r.mask, FactorPrecision::single);
  lu->build(r.matrix);
  lu->apply(b, expected);
  const auto schwarz = make_schwarz<3>(r.layout, r.mask, {.width = 4, .stride = 3, .direct_up_to = 2000});
  schwarz->build(r.matrix);
  const KrylovResult result =
      Gmres(r.layout.space(), r.layout.size(), 60)
          .solve([&](const Array& in, const Array& out) { r.matrix.multiply(in, out); },
                 [&](const Array& in, const Array& out) { schwarz->apply(in, out); }, b, x, 1e-5, 60);
  std::printf("  %d iterations\n", result.iterations);
  EXPECT_TRUE(result.converged);
  EXPECT_LT(relative(to_vector(x), to_vector(expected)), 1e-4);
}

}  // namespace
}  // namespace softwet::testing_tools
