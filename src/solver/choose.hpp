// From the name in a case to a preconditioner.
#pragma once

#include "app/error.hpp"
#include "solver/schwarz.hpp"
#include "solver/sparse_lu.hpp"

namespace softwet {

/// automatic: the faster whole run as measured (docs in tools/README.md): sparse LU in 2D.
template <int D>
std::unique_ptr<Preconditioner> choose_preconditioner(const std::string& name, const Layout<D>& layout,
                                                      const ConstArray& mask) {
  if (name == "none") return std::make_unique<NoPreconditioner>();
  if (name == "schwarz") return make_schwarz<D>(layout, mask, {});
  return make_sparse_lu<D>(layout, mask);
}

}  // namespace softwet
