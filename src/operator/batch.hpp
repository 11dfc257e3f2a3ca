// One batch of elements from control values to control values.
#pragma once

#include "operator/task.hpp"

namespace softwet {

/// Slots of a batch at its points, with tangents where N is dual.
template <class S, class N, int D, int P, int Q, int QL, class Trial>
struct BatchFields {
  static constexpr int points = power(Q, D - 1) * QL;
  static constexpr int slots = Trial::slot_count;
  S value[slots][1 + D][points];
  S tangent[is_dual<N> ? D + 2 : 1][1 + D][points];
  RealOf<S> scale[slots];

  template <class TaskType>
  KOKKOS_FORCEINLINE_FUNCTION BatchFields(const TaskType& task, const Batch<D>& b,
                                          const BatchBasis<S, D, P, Q, QL>& basis) {
    for (int s = 0; s < slots; ++s) scale[s] = task.scale[s];
    const int first = first_control(task.region, b);
    fill_slots(task, b, basis, first, std::make_integer_sequence<int, slots>());
    if constexpr (is_dual<N>) fill_tangents(task, b, basis, first, std::make_integer_sequence<int, D + 2>());
  }

  template <class TaskType, int... s>
  KOKKOS_FORCEINLINE_FUNCTION void fill_slots(const TaskType& task, const Batch<D>& b,
                                              const BatchBasis<S, D, P, Q, QL>& basis, int first,
                                              std::integer_sequence<int, s...>) {
    (fill_slot<s>(task, b, basis, first), ...);
  }
  template <int s, class TaskType>
  KOKKOS_FORCEINLINE_FUNCTION void fill_slot(const TaskType& task, const Batch<D>& b,
                                             const BatchBasis<S, D, P, Q, QL>& basis, int first) {
    constexpr Slot kind = Trial::slot(s);
    S nodal[power(P + 1, D)];
    gather<S, D, P>(task.slot[s], task.region, first, b.count, nodal);
    basis.template forward<kind.value, kind.gradient>(nodal, value[s]);
  }
  template <class TaskType, int... u>
  KOKKOS_FORCEINLINE_FUNCTION void fill_tangents(const TaskType& task, const Batch<D>& b,
                                                 const BatchBasis<S, D, P, Q, QL>& basis, int first,
                                                 std::integer_sequence<int, u...>) {
    (fill_tangent<u>(task, b, basis, first), ...);
  }
  template <int u, class TaskType>
  KOKKOS_FORCEINLINE_FUNCTION void fill_tangent(const TaskType& task, const Batch<D>& b,
                                                const BatchBasis<S, D, P, Q, QL>& basis, int first) {
    constexpr bool values = reads<Trial, D>(u, &Slot::value), gradients = reads<Trial, D>(u, &Slot::gradient);
    if constexpr (values || gradients) {
      S nodal[power(P + 1, D)];
      gather<S, D, P>(task.tangent[u], task.region, first, b.count, nodal);
      basis.template forward<values, gradients>(nodal, tangent[u]);
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION N number(int s, int c, int q) const {
    if constexpr (is_dual<N>) {
      const int unknown = Trial::slot(s).from.unknown(D);
      return N(value[s][c][q], unknown < D + 2 ? S(scale[s] * tangent[unknown][c][q]) : S(0.0));
    } else {
      return value[s][c][q];
    }
  }
};

/// Residual (N = S) or Jacobian-vector product (N = Dual<S>) of one batch: add(channel, what its control values get).
template <class S, class N, int D, int P, int Q, class Term, class Motion, class Add>
KOKKOS_FORCEINLINE_FUNCTION void compute_batch(const Task<D, Term, Motion, RealOf<S>>& task, const Batch<D>& b,
                                               const Add& add) {
  constexpr int QL = points_across<Term, Q>, points = power(Q, D - 1) * QL;
  using Trial = typename Term::template Trial<N, D>;
  using Test = typename Term::template Test<N, D>;
  constexpr int channels = Test::channel_count;
  const BatchBasis<S, D, P, Q, QL> basis(task.region, b);
  const BatchFields<S, N, D, P, Q, QL, Trial> fields(task, b, basis);
  const BatchGeometry<S, N, D, P, Q, Motion> geometry(task.region, b, basis.x, basis.y, task.motion);
  S out[channels][1 + D][points];
  for (int q = 0; q < points; ++q) {
    const auto point = point_at<Term, Q, S>(geometry, task, b, q);
    using Point = std::remove_const_t<decltype(point)>;
    const Test test = task.term.residual(Trial::read(Reader<N, D, decltype(fields), Point>{fields, point, q}));
    const S weight = task.factor * weight_at<S, D, Q>(task.region, b, q);
    test.write(Writer<S, N, D, points, Point>{out, point, weight, q});
  }
  for (int c = 0; c < channels; ++c) {
    S nodal[power(P + 1, D)];
    basis.template backward<Test::has_flux>(out[c], nodal);
    add(c, nodal);
  }
}

/// Adds that to task.test[].
template <class S, class N, int D, int P, int Q, class Term, class Motion>
KOKKOS_FUNCTION void assemble_batch(const Task<D, Term, Motion, RealOf<S>>& task, const Batch<D>& b) {
  const int first = first_test(task.region, b);
  compute_batch<S, N, D, P, Q, Term, Motion>(task, b, [&](int c, const S(&nodal)[power(P + 1, D)]) {
    scatter<S, D, P>(task.test[c], task.region, first, b.count, nodal);
  });
}

}  // namespace softwet
