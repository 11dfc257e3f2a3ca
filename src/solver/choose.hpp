// From the name in a case to a preconditioner.
#pragma once

#include "app/error.hpp"
#include "solver/block_lu.hpp"
#include "solver/schwarz.hpp"
#include "solver/sparse_lu.hpp"

namespace softwet {

/// Those that this build has.
inline std::vector<std::string> preconditioner_names() {
#ifdef SOFTWET_HAVE_UMFPACK
  return {"lu", "umfpack", "schwarz"};
#else
  return {"lu", "schwarz"};
#endif
}

/// automatic: the fastest whole run as measured (README): block LU in 2D. umfpack: the same matrix factorised by the
/// library, in double precision.
template <int D>
std::unique_ptr<Preconditioner> choose_preconditioner(const std::string& name, const Layout<D>& layout,
                                                      const ConstArray& mask) {
  if (name == "none") return std::make_unique<NoPreconditioner>();
  if (name == "schwarz") return make_schwarz<D>(layout, mask, {});
  if (name == "umfpack") return make_sparse_lu<D>(layout, mask);
  return make_block_lu<D>(layout, mask);
}

}  // namespace softwet
