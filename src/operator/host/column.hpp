// A column of batches on the host: the elements above each other share the sweeps along the other axes.
//
// A plane holds a field on one layer of control values, swept along all axes but the last: its value and its slopes at
// the points of the plane. An element combines degree + 1 planes along the last axis, and the next element needs one new
// plane only. On the way back integrals are collected in planes, and a plane that no further element adds to is swept
// back to control values. So the numbers at work stay few, and each plane is swept once.
#pragma once

#include "operator/task.hpp"

namespace softwet {

/// Points of a plane, and what it holds at each: value, then slopes along all axes but the last.
template <class S, int D, int Q>
using Plane = S[D][power(Q, D - 1)];

/// The bases that all elements of a column share.
template <class S, int D, int P, int Q>
struct PlaneBasis {
  using Real = RealOf<S>;
  static constexpr int controls = power(P + 1, D - 1), points = power(Q, D - 1);
  AxisBasis<S, P, Q> x;
  AxisBasis<Real, P, Q> y;  // 3D only
  S weight[points];

  PlaneBasis(const Region<D, Real>& region, const Batch<D>& b) : x(load_basis<S, P, Q>(region.axis[0], b.element[0])) {
    if constexpr (D == 3) y = load_basis<Real, P, Q>(region.axis[1], b.element[1]);
    for (int w = 0; w < points; ++w) {
      weight[w] = load<S>(&region.axis[0].weight(w % Q, b.element[0]));
      if constexpr (D == 3) weight[w] = weight[w] * region.axis[1].weight(w / Q, b.element[1]);
    }
  }

  template <bool Slopes>
  KOKKOS_FORCEINLINE_FUNCTION void forward(const S (&nodal)[controls], Plane<S, D, Q>& out) const {
    if constexpr (D == 3) {
      interpolate<true, Slopes, S, P, Q, Q>(nodal, x, y, out);
    } else {
      for (int q = 0; q < Q; ++q) {
        S value = x.value[q][0] * nodal[0], slope = x.slope[q][0] * nodal[0];
        for (int i = 1; i <= P; ++i) {
          value = value + x.value[q][i] * nodal[i];
          if constexpr (Slopes) slope = slope + x.slope[q][i] * nodal[i];
        }
        out[0][q] = value;
        if constexpr (Slopes) out[1][q] = slope;
      }
    }
  }

  template <bool Slopes>
  KOKKOS_FORCEINLINE_FUNCTION void backward(const Plane<S, D, Q>& in, S (&nodal)[controls]) const {
    if constexpr (D == 3) {
      integrate<Slopes, S, P, Q, Q>(in, x, y, nodal);
    } else {
      for (int i = 0; i <= P; ++i) {
        S sum = x.value[0][i] * in[0][0];
        if constexpr (Slopes) sum = sum + x.slope[0][i] * in[1][0];
        for (int q = 1; q < Q; ++q) {
          sum = sum + x.value[q][i] * in[0][q];
          if constexpr (Slopes) sum = sum + x.slope[q][i] * in[1][q];
        }
        nodal[i] = sum;
      }
    }
  }
};

/// The basis of an element along the last axis, and where a ring keeps the planes of its layers.
template <class Real, int P, int Q>
struct ElementLayers : AxisBasis<Real, P, Q> {
  int place[P + 1];

  ElementLayers(const AxisRuleOf<Real>& rule, int element)
      : AxisBasis<Real, P, Q>(load_basis<Real, P, Q>(rule, element)) {
    for (int k = 0; k <= P; ++k) place[k] = (rule.first(element) + k) % (P + 1);
  }
};

/// The planes of one field around an element: that of layer k at k % (degree + 1).
template <class S, int D, int P, int Q>
struct PlaneRing {
  Plane<S, D, Q> plane[P + 1];

  KOKKOS_FORCEINLINE_FUNCTION Plane<S, D, Q>& of(int layer) { return plane[layer % (P + 1)]; }

  /// Value and gradient at the points above point w of the plane.
  template <bool Value, bool Gradient>
  KOKKOS_FORCEINLINE_FUNCTION void interpolate_line(const ElementLayers<RealOf<S>, P, Q>& last, int w,
                                                    S (&out)[1 + D][Q]) const {
    S layer[D][P + 1];
    for (int k = 0; k <= P; ++k)
      for (int c = 0; c < (Gradient ? D : 1); ++c) layer[c][k] = plane[last.place[k]][c][w];
    for (int q = 0; q < Q; ++q) {
      if constexpr (Value) out[0][q] = along(last.value[q], layer[0]);
      if constexpr (Gradient) {
        for (int d = 1; d < D; ++d) out[d][q] = along(last.value[q], layer[d]);
        out[D][q] = along(last.slope[q], layer[0]);
      }
    }
  }

  /// Transpose: adds the integrals of the points above point w.
  template <bool Flux>
  KOKKOS_FORCEINLINE_FUNCTION void integrate_line(const ElementLayers<RealOf<S>, P, Q>& last, int w,
                                                  const S (&in)[1 + D][Q]) {
    for (int k = 0; k <= P; ++k) {
      Plane<S, D, Q>& to = plane[last.place[k]];
      S value = to[0][w];
      for (int q = 0; q < Q; ++q) {
        value = value + last.value[q][k] * in[0][q];
        if constexpr (Flux) value = value + last.slope[q][k] * in[D][q];
      }
      to[0][w] = value;
      for (int d = 1; d < D && Flux; ++d) {
        S slope = to[d][w];
        for (int q = 0; q < Q; ++q) slope = slope + last.value[q][k] * in[d][q];
        to[d][w] = slope;
      }
    }
  }

  static KOKKOS_FORCEINLINE_FUNCTION S along(const RealOf<S> (&basis)[P + 1], const S (&layer)[P + 1]) {
    S sum = basis[0] * layer[0];
    for (int k = 1; k <= P; ++k) sum = sum + basis[k] * layer[k];
    return sum;
  }
};

/// The control values that a plane is made of, of one layer of a component.
template <class S, int D, int P>
KOKKOS_FORCEINLINE_FUNCTION void gather_layer(const RealOf<S>* p, const Region<D, RealOf<S>>& region, int count,
                                              S (&nodal)[power(P + 1, D - 1)]) {
  for (int a = 0; a < power(P + 1, D - 1); ++a)
    nodal[a] = load_lanes<S>(p + a % (P + 1) + (D == 3 ? a / (P + 1) * region.stride[1] : 0), count);
}

/// Adds a layer of control values for all channels. Packs of neighbouring i overlap in memory: with i outermost a pack is
/// stored long before its lanes are read again.
template <class S, int D, int P, int channels>
KOKKOS_FORCEINLINE_FUNCTION void scatter_layer(RealOf<S>* const (&test)[channels], const Region<D, RealOf<S>>& region,
                                               int first, int count, const S (&nodal)[channels][power(P + 1, D - 1)]) {
  for (int i = 0; i <= P; ++i)
    for (int c = 0; c < channels; ++c)
      for (int j = 0; j < (D == 3 ? P + 1 : 1); ++j)
        add_lanes(test[c] + first + i + (D == 3 ? j * region.stride[1] : 0), nodal[c][j * (P + 1) + i], count);
}

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

/// Residual (N = S) or Jacobian-vector product (N = Dual<S>) of the elements [first, last) of a column. The control layers
/// of its elements follow each other one by one, and the test functions are those of the trial.
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
