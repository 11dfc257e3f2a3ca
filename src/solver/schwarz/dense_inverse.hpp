// Batched dense inverses in single precision: by factors on the host (Eigen), by Gauss-Jordan elimination on a device.
#pragma once

#include <optional>

#include "solver/direct/device/gauss_jordan.hpp"

namespace softwet {

/// Replaces the leading size(b) x size(b) part of each block by its inverse, transposed: block(b, column, row). For the
/// host. A singular block gives non-finite values; the solver then sees a non-finite residual and rejects the step.
void invert_by_factors(const DenseBlocks& blocks, const BlockSizes& size);

/// The inverses of batches of blocks, which stay in their place.
class BatchInverse {
 public:
  BatchInverse(int count, int rows) {
    if (!host_algorithms) device_.emplace(count, rows);
  }
  void invert(const DenseBlocks& blocks, const BlockSizes& size) const {
    device_ ? device_->invert(blocks, size) : invert_by_factors(blocks, size);
  }
  static double bytes(int count, int rows) { return host_algorithms ? 0 : GaussJordan::bytes(count, rows); }

 private:
  std::optional<GaussJordan> device_;
};

/// An entry of what BatchInverse::invert leaves.
KOKKOS_FORCEINLINE_FUNCTION float entry_of_inverse(const DenseBlocks& blocks, int block, int row, int column) {
  return host_algorithms ? blocks(block, column, row) : blocks(block, row, column);
}

}  // namespace softwet
