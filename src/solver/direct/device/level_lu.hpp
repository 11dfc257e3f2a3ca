// Lagged LU factors of the Jacobian with frozen geometry by nested dissection, wholly on the device.
#pragma once

#include "solver/preconditioner.hpp"

namespace softwet {

/// The factorisation of make_block_lu for a device, in single precision: a multifrontal one (Duff and Reid 1983) along
/// a nested dissection (George 1973). All fronts of a depth are made, eliminated and applied together. A build starts
/// three kernels for a level of many or small fronts; for others three for each 16 pivots of the largest front, and
/// five more. An application starts one for each level on the way to the root, and one for each level but the root's on
/// the way back. For prescribed values z = r.
/// Nothing is computed or waited for on the host. Stored are A^-1, C A^-1 and A^-1 B of each front ((A, B), (C, S)), so
/// that an application is nothing but products. Every number is the result of the same operations in the same order,
/// whichever threads there are. A singular matrix gives values that are not finite.
/// @param threads  of a team that multiplies or eliminates; 0: as many as suit the machine
/// Tested: tests/unit/solver/direct/device/test_level_lu.cpp
template <int D>
std::unique_ptr<StencilSolver<D>> make_level_lu(const Layout<D>& layout, const ConstArray& mask, int threads = 0);

}  // namespace softwet
