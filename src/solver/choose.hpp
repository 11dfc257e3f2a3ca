// From the name in a case to a preconditioner.
#pragma once

#include "case/error.hpp"
#include "solver/block_lu.hpp"
#include "solver/replicated.hpp"
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

/// Number of unknowns up to which `automatic` takes the block LU in 3D (docs/performance.md).
constexpr int small_in_3d = 3000;

/// automatic: block LU in 2D and for the smallest scenes in 3D, otherwise multilevel Schwarz, as whole runs were measured to
/// be fastest. umfpack: the matrix is factorised by that library, in double precision.
template <int D>
std::unique_ptr<Preconditioner> choose_preconditioner(
    const std::string& name, const Layout<D>& layout, const ConstArray& mask,
    const SchwarzControl& control = SchwarzControl::for_dimension(D)) {
  if (name == "none") return std::make_unique<NoPreconditioner>();
  const Layout<D> all = layout.whole_patch();
  const bool schwarz = name == "schwarz" || (name == "automatic" && D == 3 && all.size() > small_in_3d);
  if (!layout.whole()) {  // the same on every process; of Schwarz's finest level what its own columns need
    const auto& first = layout.columns.first_function;
    SchwarzControl own = control;
    own.wanted = {first[layout.columns.rank], first[layout.columns.rank + 1]};
    own.part = layout.columns;
    const int beside = schwarz ? std::max(own.width - 1, layout.axis[0].degree()) : -1;
    return std::make_unique<Replicated<D>>(layout, choose_preconditioner<D>(name, all, of_patch(layout, mask), own),
                                           beside);
  }
  const auto assembled = [&](auto solver) { return std::make_unique<Assembled<D>>(layout, mask, std::move(solver)); };
  if (schwarz) return assembled(make_schwarz<D>(layout, mask, control));
  if (name == "umfpack") return assembled(make_sparse_lu<D>(layout, mask));
  return assembled(make_block_lu<D>(layout, mask));
}

}  // namespace softwet
