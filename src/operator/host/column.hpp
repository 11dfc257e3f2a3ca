// A column of batches on the host: the elements above each other share the sweeps along the other axes.
//
// A plane holds a field on one layer of control values, swept along all axes but the last: its value and its slopes at
// the points of the plane. An element combines degree + 1 planes along the last axis, and the next element needs one
// new plane only. On the way back integrals are collected in planes, and a plane that no further element adds to is
// swept back to control values. So the numbers at work stay few, and each plane is swept once.
#pragma once

#include "operator/host/planes.hpp"

namespace softwet {

/// Fields of a column: the planes around the current element, and its values on one line of points.
template <class S, class N, int D, int P, int Q, class Trial>
struct ColumnFields {
  static constexpr int slots = Trial::slot_count, unknowns = is_dual<N> ? D + 2 : 1;
  PlaneRing<S, D, P, Q> slot_ring[slots], tangent_ring[unknowns];
  S value[slots][1 + D][Q], tangent[unknowns][1 + D][Q];
  RealOf<S> scale[slots];

  template <class TaskType>
  explicit ColumnFields(const TaskType& task) {
    for (int s = 0; s < slots; ++s) scale[s] = task.scale[s];
  }

  /// Sweeps layer k of all fields; `first` is the offset of the batch's first control value in it.
  template <class TaskType>
  KOKKOS_FORCEINLINE_FUNCTION void load(const TaskType& task, const PlaneBasis<S, D, P, Q>& basis, int layer, int first,
                                        int count) {
    for_each_slot([&]<int s>(std::integral_constant<int, s>) {
      load_field<Trial::slot(s).gradient>(task, task.slot[s], basis, layer, first, count, slot_ring[s]);
    });
    for_each_tangent([&]<int u>(std::integral_constant<int, u>) {
      load_field<reads<Trial, D>(u, &Slot::gradient)>(task, task.tangent[u], basis, layer, first, count,
                                                      tangent_ring[u]);
    });
  }
  template <bool Gradient, class TaskType>
  KOKKOS_FORCEINLINE_FUNCTION void load_field(const TaskType& task, const RealOf<S>* p,
                                              const PlaneBasis<S, D, P, Q>& basis, int layer, int first, int count,
                                              PlaneRing<S, D, P, Q>& ring) {
    S nodal[power(P + 1, D - 1)];
    gather_layer<S, D, P>(p + first, task.region, count, nodal);
    basis.template forward<Gradient>(nodal, ring.of(layer));
  }

  /// The points above point w of the plane.
  KOKKOS_FORCEINLINE_FUNCTION void interpolate(const ElementLayers<RealOf<S>, P, Q>& last, int w) {
    for_each_slot([&]<int s>(std::integral_constant<int, s>) {
      constexpr Slot kind = Trial::slot(s);
      slot_ring[s].template interpolate_line<kind.value, kind.gradient>(last, w, value[s]);
    });
    for_each_tangent([&]<int u>(std::integral_constant<int, u>) {
      tangent_ring[u].template interpolate_line<reads<Trial, D>(u, &Slot::value), reads<Trial, D>(u, &Slot::gradient)>(
          last, w, tangent[u]);
    });
  }

  KOKKOS_FORCEINLINE_FUNCTION N number(int s, int c, int q) const {
    if constexpr (is_dual<N>) {
      const int unknown = Trial::slot(s).from.unknown(D);
      return N(value[s][c][q], unknown < D + 2 ? S(scale[s] * tangent[unknown][c][q]) : S(0.0));
    } else {
      return value[s][c][q];
    }
  }

 private:
  template <class Body>
  static KOKKOS_FORCEINLINE_FUNCTION void for_each_slot(const Body& body) {
    [&]<int... s>(std::integer_sequence<int, s...>) { (body(std::integral_constant<int, s>()), ...); }
    (std::make_integer_sequence<int, slots>());
  }
  template <class Body>
  static KOKKOS_FORCEINLINE_FUNCTION void for_each_tangent(const Body& body) {
    if constexpr (is_dual<N>) [&]<int... u>(std::integer_sequence<int, u...>) {
        (([&] {
           if constexpr (reads<Trial, D>(u)) body(std::integral_constant<int, u>());
         }()),
         ...);
      }
    (std::make_integer_sequence<int, D + 2>());
  }
};

/// Integrals of a column by test channel, collected in planes.
template <class S, int D, int P, int Q, class Test>
struct ColumnIntegrals {
  static constexpr int channels = Test::channel_count;
  PlaneRing<S, D, P, Q> ring[channels];

  KOKKOS_FORCEINLINE_FUNCTION void clear(int layer) {
    for (int c = 0; c < channels; ++c)
      for (int d = 0; d < D; ++d)
        for (int w = 0; w < power(Q, D - 1); ++w) ring[c].of(layer)[d][w] = S(0.0);
  }
  KOKKOS_FORCEINLINE_FUNCTION void add(const ElementLayers<RealOf<S>, P, Q>& last, int w,
                                       const S (&in)[channels][1 + D][Q]) {
    for_each_channel([&]<int c>(std::integral_constant<int, c>) {
      ring[c].template integrate_line<channel_has_flux<Test>(c)>(last, w, in[c]);
    });
  }
  /// Sweeps a layer that is complete back to control values.
  template <class TaskType>
  KOKKOS_FORCEINLINE_FUNCTION void store(const TaskType& task, const PlaneBasis<S, D, P, Q>& basis, int layer,
                                         int first, int count) {
    S nodal[channels][power(P + 1, D - 1)];
    for_each_channel([&]<int c>(std::integral_constant<int, c>) {
      basis.template backward<channel_has_flux<Test>(c)>(ring[c].of(layer), nodal[c]);
    });
    scatter_layer<S, D, P, channels>(task.test, task.region, first, count, nodal);
  }

 private:
  template <class Body>
  static KOKKOS_FORCEINLINE_FUNCTION void for_each_channel(const Body& body) {
    [&]<int... c>(std::integer_sequence<int, c...>) { (body(std::integral_constant<int, c>()), ...); }
    (std::make_integer_sequence<int, channels>());
  }
};

/// Residual (N = S) or Jacobian-vector product (N = Dual<S>) of the elements [first, last) of a column. The control
/// layers of its elements follow each other one by one, and trial and test functions are equal.
template <class S, class N, int D, int P, int Q, class Term, class Motion>
void assemble_column(const Task<D, Term, Motion, RealOf<S>>& task, Batch<D> b, int first, int last) {
  using Real = RealOf<S>;
  using Trial = typename Term::template Trial<N, D>;
  using Test = typename Term::template Test<N, D>;
  constexpr int channels = Test::channel_count;
  const AxisRuleOf<Real>& rule = task.region.axis[D - 1];
  const PlaneBasis<S, D, P, Q> basis(task.region, b);
  const BatchGeometry<S, N, D, P, Q, Motion> geometry(task.region, b, basis.x, basis.y, task.motion);
  ColumnFields<S, N, D, P, Q, Trial> fields(task);
  ColumnIntegrals<S, D, P, Q, Test> integrals;
  const int stride = task.region.stride[D - 1], layers = rule.first(first);
  b.element[D - 1] = 0;
  const int base = first_control(task.region, b) - rule.first(0) * stride;
  for (int e = first, loaded = layers; e < last; ++e) {
    b.element[D - 1] = e;
    const int layer = rule.first(e);
    for (; loaded <= layer + P; ++loaded) {
      fields.load(task, basis, loaded, base + loaded * stride, b.count);
      integrals.clear(loaded);
    }
    const ElementLayers<Real, P, Q> along(rule, e);
    for (int w = 0; w < basis.points; ++w) {
      fields.interpolate(along, w);
      S out[channels][1 + D][Q];
      for (int q = 0; q < Q; ++q) {
        const auto point = point_at<Term, Q, S>(geometry, task, b, q * basis.points + w);
        using Point = std::remove_const_t<decltype(point)>;
        const Test test = task.term.residual(Trial::read(Reader<N, D, decltype(fields), Point>{fields, point, q}));
        const S weight = (task.factor * rule.weight(q, e)) * basis.weight[w];
        test.write(Writer<S, N, D, Q, Point>{out, point, weight, q});
      }
      integrals.add(along, w, out);
    }
    const int complete = e + 1 < last ? rule.first(e + 1) : layer + P + 1;
    for (int k = layer; k < complete; ++k) integrals.store(task, basis, k, base + k * stride, b.count);
  }
}

}  // namespace softwet
