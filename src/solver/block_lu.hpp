// Lagged LU factors of the Jacobian with frozen geometry by nested dissection, in single precision, on the host.
#pragma once

#include "solver/dissection.hpp"
#include "solver/preconditioner.hpp"

namespace softwet {

/// A multifrontal factorisation (Duff and Reid 1983) that knows the tensor structure: dense fronts from a geometric
/// dissection, single precision with rows and columns scaled to one, pivoting inside each front, fronts of one level in
/// parallel. The arithmetic does not depend on the number of threads. A preconditioner, not a solver: GMRES mends what
/// single precision leaves.
template <int D>
std::unique_ptr<StencilSolver<D>> make_block_lu(const Layout<D>& layout, const ConstArray& mask);

/// Numbers in the LU factors of a matrix that is eliminated along this tree.
double factor_entries(const Dissection&);

}  // namespace softwet
