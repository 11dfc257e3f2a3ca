// From the choice of a case to a preconditioner.
#pragma once

#include "case/choices.hpp"
#include "case/error.hpp"
#include "solver/direct/device/level_lu.hpp"
#include "solver/direct/host/block_lu.hpp"
#include "solver/schwarz/schwarz.hpp"

namespace softwet {

/// Number of unknowns up to which `automatic` takes LU in 3D (docs/development/solver_choices.md).
constexpr int small_in_3d = 3000;

/// lu: by fronts one after the other, or on a device by those of a level together.
template <int D>
std::unique_ptr<StencilSolver<D>> make_lu(const Layout<D>& layout, const ConstArray& mask) {
  return host_algorithms ? make_block_lu<D>(layout, mask) : make_level_lu<D>(layout, mask);
}

/// Each process would factorise the whole matrix, which takes as much memory on each and hardly less time.
inline void refuse_on_several_processes(PreconditionerKind kind, int processes) {
  throw Error(Exit::invalid_input,
              "solver.krylov.preconditioner = \"" + word_of(kind) + "\" takes lu here, which each of " +
                  std::to_string(processes) +
                  " processes would factorise whole; write \"schwarz\", or start one process for the scene, or one for "
                  "each of several scenes (softwet sweep --jobs)");
}

/// automatic: lu in 2D and for the smallest scenes in 3D, otherwise multilevel Schwarz, as whole runs were measured to be
/// fastest on a processor. Several processes have no lu.
template <int D>
std::unique_ptr<Preconditioner> choose_preconditioner(
    PreconditionerKind kind, const Layout<D>& layout, const ConstArray& mask,
    const SchwarzControl& control = SchwarzControl::for_dimension(D)) {
  if (kind == PreconditionerKind::none) return std::make_unique<NoPreconditioner>();
  const Layout<D> all = layout.whole_patch();
  const bool schwarz = kind == PreconditionerKind::schwarz ||
                       (kind == PreconditionerKind::automatic && D == 3 && all.size() > small_in_3d);
  const auto assembled = [&](const ConstArray& free, auto solver) {
    return std::make_unique<Assembled<D>>(layout, free, std::move(solver));
  };
  if (layout.whole()) return assembled(mask, schwarz ? make_schwarz<D>(layout, mask, control) : make_lu<D>(all, mask));
  if (!schwarz) refuse_on_several_processes(kind, layout.columns.ranks);
  const Array free("mask", mask.extent(0));  // a model's mask is zero in the columns of other processes
  Kokkos::deep_copy(free, mask);
  update_columns<double>(layout.columns, *layout.exchange, free);
  return assembled(free, make_schwarz<D>(layout, free, control));
}

}  // namespace softwet
