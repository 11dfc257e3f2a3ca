#include "solver/schwarz/dense_inverse.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <atomic>
#include <new>

namespace softwet {

namespace {

using RowMajor = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Host: with rows scaled to 1, A = D^-1 B; the transpose of A^-1 is D B^-T.
struct InvertOnHost {
  DenseBlocks blocks;
  BlockSizes size;
  std::atomic<bool>* out_of_memory;  ///< no exception may leave a parallel region

  void operator()(int b) const {
    try {
      invert(b);
    } catch (const std::bad_alloc&) {
      *out_of_memory = true;
    }
  }
  void invert(int b) const {
    const int n = size(b);
    if (n == 0) return;
    // The rows of A are the columns of this map, so that B^T is factorised in place.
    using Strided = Eigen::Map<Eigen::MatrixXf, 0, Eigen::OuterStride<>>;
    Strided a(&blocks(b, 0, 0), n, n, Eigen::OuterStride<>(blocks.extent(2)));
    const Eigen::VectorXf scale = a.colwise().lpNorm<Eigen::Infinity>().cwiseMax(1e-30f).cwiseInverse();
    a = a * scale.asDiagonal();
    const Eigen::PartialPivLU<Eigen::Ref<Eigen::MatrixXf, 0, Eigen::OuterStride<>>> lu(a);
    thread_local Eigen::MatrixXf x;  // kept, so that a second build allocates nothing
    x.setIdentity(n, n);
    constexpr int columns = 64;
    for (int j = 0; j < n; j += columns) {  // above its diagonal the inverse of L is zero
      auto part = x.block(j, j, n - j, std::min(columns, n - j));
      a.bottomRightCorner(n - j, n - j).triangularView<Eigen::UnitLower>().solveInPlace(part);
    }
    a.triangularView<Eigen::Upper>().solveInPlace(x);
    Eigen::Map<RowMajor, 0, Eigen::OuterStride<>>(a.data(), n, n, a.outerStride()) =
        scale.asDiagonal() * (x * lu.permutationP());
  }
};

}  // namespace

void invert_by_factors(const DenseBlocks& blocks, const BlockSizes& size) {
  using Host = Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace, Kokkos::Schedule<Kokkos::Dynamic>>;
  std::atomic<bool> out_of_memory = false;
  Kokkos::parallel_for("softwet::invert", Host(0, blocks.extent(0)).set_chunk_size(1),
                       InvertOnHost{blocks, size, &out_of_memory});
  if (out_of_memory) throw std::bad_alloc();
}

}  // namespace softwet
