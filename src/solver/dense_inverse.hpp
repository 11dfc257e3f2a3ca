// Batched dense inverses in single precision, on the host (Eigen) or by one team per block on a device.
#pragma once

#include "field/array.hpp"

namespace softwet {

/// [block][row][column]
using DenseBlocks = Kokkos::View<float***, Kokkos::LayoutRight, Exec>;

/// Rows 0 .. core(b) of the inverse of each block's leading size(b) x size(b) part, transposed:
/// inverse(b, column, row). `blocks` is overwritten.
/// A singular block gives non-finite rows; the solver then sees a non-finite residual and rejects the step.
void invert_core_rows(const DenseBlocks& blocks, const Kokkos::View<const int*, Exec>& size,
                      const Kokkos::View<const int*, Exec>& core, const DenseBlocks& inverse);

/// The same by one team per block, as on a device; runs on the host too, slowly.
void invert_core_rows_by_teams(const DenseBlocks& blocks, const Kokkos::View<const int*, Exec>& size,
                               const Kokkos::View<const int*, Exec>& core, const DenseBlocks& inverse);

}  // namespace softwet
