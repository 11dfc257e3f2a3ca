// Batched dense inverses in single precision, on the host (Eigen) or by one team per block on a device.
#pragma once

#include "field/array.hpp"

namespace softwet {

/// [block][row][column]
using DenseBlocks = Kokkos::View<float***, Kokkos::LayoutRight, Exec>;

/// Replaces the leading size(b) x size(b) part of each block by its inverse, transposed: block(b, column, row).
/// A singular block gives non-finite values; the solver then sees a non-finite residual and rejects the step.
void invert(const DenseBlocks& blocks, const Kokkos::View<const int*, Exec>& size);

/// The same by one team per block, as on a device; runs on the host too, slowly.
void invert_by_teams(const DenseBlocks& blocks, const Kokkos::View<const int*, Exec>& size,
                     int threads = on_host ? 1 : 8);

}  // namespace softwet
