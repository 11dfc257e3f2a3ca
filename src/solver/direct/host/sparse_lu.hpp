// Lagged sparse LU factors of the Jacobian with frozen geometry (UMFPACK through Eigen), on the host.
#pragma once

#include "solver/preconditioner.hpp"

namespace softwet {

/// The strongest choice in two dimensions on a CPU. Errors: softwet was built without UMFPACK.
template <int D>
std::unique_ptr<StencilSolver<D>> make_sparse_lu(const Layout<D>& layout, const ConstArray& mask);

}  // namespace softwet
