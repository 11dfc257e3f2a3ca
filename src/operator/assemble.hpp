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

/// Runs a body for the batches of a row of columns on the host, from element `bottom` to `top` along the last axis. It is called
/// through a pointer, so that one loop is compiled for all terms.
template <int D>
struct ColumnBody {
  const void* task;
  void (*run)(const void* task, const ElementColumns& columns, const Batch<D>& row, int bottom, int top);
};

/// Rows of columns on the host, cut along the last axis into blocks of the same height. Blocks of one colour share no
/// control value: they are two blocks apart, and degree + 1 elements along the middle axis of three.
template <int D>
struct BlocksOfRows {
  static constexpr int height = 8;  // at least the degree
  ColumnBody<D> body;
  int first_block, first_row, rows, stride, layers;  ///< of this colour; rows along the middle axis
  ElementColumns columns;

  void operator()(int item) const {
    Batch<D> row{};
    if constexpr (D == 3) row.element[1] = first_row + stride * (item % rows);
    const int bottom = (first_block + 2 * (item / rows)) * height;
    body.run(body.task, columns, row, bottom, std::min(bottom + height, layers));
  }

  /// Runs one colour after another.
  template <class Real>
  static void run(const Region<D, Real>& region, int stride, const ColumnBody<D>& body) {
    const int layers = region.axis[D - 1].elements;
    const int all_rows = D == 3 ? region.axis[1].elements : 1, apart = D == 3 ? stride : 1;
    const int blocks = (layers + height - 1) / height;
    const ElementColumns columns = region.first_axis();
    for (int colour = 0; colour < 2 * apart; ++colour) {
      const int row = colour % apart, block = colour / apart;
      const int rows = (all_rows - row + apart - 1) / apart, items = rows * ((blocks - block + 1) / 2);
      if (items > 0)
        for_items("softwet::assemble", items, BlocksOfRows{body, block, row, rows, apart, layers, columns});
    }
  }
};

/// Columns of a term: its residual, or (Tangent) its Jacobian-vector product.
template <int D, int P, int Q, bool Tangent, class Term, class Motion, class Real>
void assemble_columns(const Task<D, Term, Motion, Real>& task) {
  const auto run = [](const void* it, const ElementColumns& columns, const Batch<D>& row, int bottom, int top) {
    using S = Pack<Real>;
    const auto& task = *static_cast<const Task<D, Term, Motion, Real>*>(it);
    for_batches<D, Lanes<S>::count>(columns, row, [&](const Batch<D>& batch) {
      assemble_column<S, std::conditional_t<Tangent, Dual<S>, S>, D, P, Q, Term, Motion>(task, batch, bottom, top);
    });
  };
  BlocksOfRows<D>::run(task.region, P + 1, {&task, run});
}

/// On the host: adds the term's residual, or (Tangent) its Jacobian-vector product, to task.test[].
template <int P, bool Tangent, int D, class Term, class Motion, class Real>
void assemble_at_once(const Task<D, Term, Motion, Real>& task) {
  with_points<P>(task.region, [&]<int Q>(PointsPerAxis<Q>) {
    if constexpr (Term::where == Where::solid || Term::where == Where::means || Term::where == Where::fluid) {
      assemble_columns<D, P, Q, Tangent>(task);
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
