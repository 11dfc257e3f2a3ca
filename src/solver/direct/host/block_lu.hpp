// Lagged LU factors of the Jacobian with frozen geometry by nested dissection, in half, single or double precision, on the
// host.
#pragma once

#include "solver/direct/dissection.hpp"
#include "solver/preconditioner.hpp"

namespace softwet {

/// half: where the processor converts it, otherwise single. full: double. sufficient: half, until a build shows that it is
/// not enough, single from then on, and double for each matrix for which a build shows that single is not enough either.
enum class FactorPrecision { half, single, full, sufficient };

/// A multifrontal factorisation (Duff and Reid 1983) that knows the tensor structure: dense fronts from a geometric
/// dissection, rows and columns scaled to one, pivoting inside each front, subtrees in parallel. It stores the
/// factors in `precision`, because applying them takes as long as reading them. It computes in single precision, and in
/// double precision where it stores double. The arithmetic
/// does not depend on the number of threads. A preconditioner, not a solver: GMRES mends what rounding leaves.
template <int D>
std::unique_ptr<StencilSolver<D>> make_block_lu(const Layout<D>& layout, const ConstArray& mask,
                                                FactorPrecision precision = FactorPrecision::sufficient);

/// Numbers in the LU factors of a matrix that is eliminated along this tree.
double factor_entries(const Dissection&);

}  // namespace softwet
