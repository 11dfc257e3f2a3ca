// A matrix inverted as a whole, where everything is to happen on the device.
#pragma once

#include "solver/preconditioner.hpp"

namespace softwet {

/// z = A^-1 r with the inverse of all free unknowns as one dense matrix in single precision: one kernel for an
/// application, 4 n^2 bytes. Meant for the coarsest level of multilevel Schwarz on a device, where a factorisation on
/// the host would cost two copies of the vector and its waiting. A singular matrix gives values that are not finite.
/// Tested: tests/unit/solver/direct/device/test_dense_solver.cpp
template <int D>
std::unique_ptr<StencilSolver<D>> make_dense_solver(const Layout<D>& layout, const ConstArray& mask);

}  // namespace softwet
