// The driver: runs one term over one region, as residual (plain numbers) or Jacobian-vector product (dual numbers).
#pragma once

#include "operator/batch.hpp"
#include "operator/device/in_tiles.hpp"
#include "operator/host/column.hpp"
#include "operator/rows.hpp"

namespace softwet {

template <int D, int P, int Q, bool Tangent, class Term, class Motion, class Real>
struct AssembleBatch {
  Task<D, Term, Motion, Real> task;

  KOKKOS_FUNCTION void operator()(const Batch<D>& b) const {
    using S = BatchNumber<Real>;
    assemble_batch<S, std::conditional_t<Tangent, Dual<S>, S>, D, P, Q, Term, Motion>(task, b);
  }
};

/// Rows of columns on the host, cut along the last axis into blocks of the same height. Blocks of one colour share no
/// control value: they are two blocks apart, and degree + 1 elements along the middle axis of three.
template <int D, int P, int Q, bool Tangent, class Term, class Motion, class Real>
struct AssembleColumns {
  static constexpr int height = 8;  // at least the degree
  Task<D, Term, Motion, Real> task;
  int first_block, first_row, rows;  ///< of this colour; rows along the middle axis
  ElementColumns columns;

  void operator()(int item) const {
    using S = Pack<Real>;
    constexpr int lanes = Lanes<S>::count;
    Batch<D> b{};
    if constexpr (D == 3) b.element[1] = first_row + (P + 1) * (item % rows);
    const int bottom = (first_block + 2 * (item / rows)) * height;
    const int top = std::min(bottom + height, task.region.axis[D - 1].elements);
    for_batches<D, lanes>(columns, b, [&](const Batch<D>& batch) {
      assemble_column<S, std::conditional_t<Tangent, Dual<S>, S>, D, P, Q, Term, Motion>(task, batch, bottom, top);
    });
  }

  /// Runs one colour after another.
  static void run(const Task<D, Term, Motion, Real>& task) {
    const int all_rows = D == 3 ? task.region.axis[1].elements : 1, apart = D == 3 ? P + 1 : 1;
    const int blocks = (task.region.axis[D - 1].elements + height - 1) / height;
    const ElementColumns columns = task.region.first_axis();
    for (int colour = 0; colour < 2 * apart; ++colour) {
      const int row = colour % apart, block = colour / apart;
      const int rows = (all_rows - row + apart - 1) / apart, items = rows * ((blocks - block + 1) / 2);
      if (items > 0)
        Kokkos::parallel_for("softwet::assemble", Items(0, items), AssembleColumns{task, block, row, rows, columns});
    }
  }
};

/// On the host: adds the term's residual, or (Tangent) its Jacobian-vector product, to task.test[].
template <int P, bool Tangent, int D, class Term, class Motion, class Real>
void assemble_at_once(const Task<D, Term, Motion, Real>& task) {
  with_points<P>(task.region, [&]<int Q>(PointsPerAxis<Q>) {
    if constexpr (Term::where == Where::solid || Term::where == Where::means || Term::where == Where::fluid) {
      AssembleColumns<D, P, Q, Tangent, Term, Motion, Real>::run(task);
    } else {
      for_colours("softwet::assemble", task.region, P + 1, AssembleBatch<D, P, Q, Tangent, Term, Motion, Real>{task});
    }
  });
}

/// The residual of a term, or (Tangent) its Jacobian-vector product: on the host added to task.test[], on a device put among
/// the terms of an evaluation, which are launched together as far as they have the same List.
template <int P, bool Tangent, class List, int D, class Term, class Motion, class Real>
void assemble(const Task<D, Term, Motion, Real>& task, TileSums<D, Real>& sums) {
  if constexpr (host_algorithms) {
    assemble_at_once<P, Tangent>(task);
  } else {
    assemble_in_tiles<P, Tangent, List>(task, sums);
  }
}

}  // namespace softwet
