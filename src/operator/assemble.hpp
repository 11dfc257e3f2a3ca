// The driver: runs one term over one region, as residual (plain numbers), Jacobian-vector product (dual numbers) or
// reduction. Rows of elements are coloured, so every sum has one fixed order, whatever the number of threads.
#pragma once

#include "operator/element.hpp"

namespace softwet {

/// Points of a term along the last axis, of Q on an axis: one where it acts on the wall.
template <class Term, int Q>
inline constexpr int points_across = Term::where == Where::wall ? 1 : Q;

/// Everything a term needs on a region. Pointers are to control value (0, 0, 0) of each component's own grid. Arrays of
/// unknowns are numbered by `Component::unknown`; those that the term does not read stay empty.
template <int D, class Term, class Motion, class R = double>
struct Task {
  using Real = R;
  using Trial = typename Term::template Trial<double, D>;
  using Test = typename Term::template Test<double, D>;

  Region<D, Real> region;
  Term term;
  Motion motion;
  const Real* slot[Trial::slot_count];
  Real scale[Trial::slot_count];  ///< d slot / d unknown
  const Real* tangent[D + 2];     ///< of the unknowns
  Real* test[Test::channel_count];
  Real factor = 1;  ///< of the integrals
};

/// Whether a trial bundle needs the value, or the gradient, of the tangent of an unknown.
template <class Trial, int D>
constexpr bool reads(int unknown, bool Slot::*what) {
  for (int s = 0; s < Trial::slot_count; ++s)
    if (Trial::slot(s).from.unknown(D) == unknown && Trial::slot(s).*what) return true;
  return false;
}
template <class Trial, int D>
constexpr bool reads(int unknown) {
  return reads<Trial, D>(unknown, &Slot::value) || reads<Trial, D>(unknown, &Slot::gradient);
}

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
      return N(value[s][c][q], scale[s] * tangent[Trial::slot(s).from.unknown(D)][c][q]);
    } else {
      return value[s][c][q];
    }
  }
};

/// What Trial::read sees: values and physical gradients of slots at point q.
template <class N, int D, class Fields, class Point>
struct Reader {
  const Fields& fields;
  const Point& point;
  int q;

  KOKKOS_FORCEINLINE_FUNCTION N value(int s) const { return fields.number(s, 0, q); }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> gradient(int s) const {
    Vector<N, D> g;
    for (int d = 0; d < D; ++d) g[d] = fields.number(s, 1 + d, q);
    return point.physical(g);
  }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> mesh_velocity() const { return point.mesh_velocity(); }
  KOKKOS_FORCEINLINE_FUNCTION N volume_ratio() const { return point.volume_ratio(); }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> position() const { return point.position; }
};

/// What Test::write sees: integrands are weighted, pulled back and stored for the integration sweeps.
template <class S, class N, int D, int points, class Point>
struct Writer {
  S (*out)[1 + D][points];
  const Point& point;
  S weight;
  int q;

  KOKKOS_FORCEINLINE_FUNCTION void add(int channel, const N& value) const {
    out[channel][0][q] = weight * outcome(point.measured(value));
  }
  KOKKOS_FORCEINLINE_FUNCTION void add(int channel, const N& value, const Vector<N, D>& flux) const {
    add(channel, value);
    const Vector<N, D> f = point.reference_flux(flux);
    for (int d = 0; d < D; ++d) out[channel][1 + d][q] = weight * outcome(f[d]);
  }
};

/// Quadrature weight and height of point q of a batch.
template <class S, int D, int Q>
KOKKOS_FORCEINLINE_FUNCTION S weight_at(const Region<D, RealOf<S>>& region, const Batch<D>& b, int q) {
  constexpr int wall_points = power(Q, D - 1);
  RealOf<S> shared = region.axis[D - 1].weight(q / wall_points, b.element[D - 1]);
  if constexpr (D == 3) shared *= region.axis[1].weight((q % wall_points) / Q, b.element[1]);
  return shared * load<S>(&region.axis[0].weight(q % Q, b.element[0]));
}

/// Geometry at point q of a batch.
template <class Term, int Q, class S, int D, class BatchGeometryType>
KOKKOS_FORCEINLINE_FUNCTION auto point_at(const BatchGeometryType& geometry, const Region<D, RealOf<S>>& region,
                                          const Batch<D>& b, int q) {
  constexpr int wall_points = power(Q, D - 1);
  const RealOf<S> height = region.axis[D - 1].position(q / wall_points, b.element[D - 1]);
  Vector<S, D> reference;
  reference[0] = load<S>(&region.axis[0].position(q % Q, b.element[0]));
  if constexpr (D == 3) reference[1] = S(region.axis[1].position((q % wall_points) / Q, b.element[1]));
  reference[D - 1] = S(height);
  return geometry.at(q, reference, height, Term::where == Where::wall);
}

/// Residual (N = S) or Jacobian-vector product (N = Dual<S>) of one batch.
template <class S, class N, int D, int P, class Term, class Motion>
KOKKOS_FUNCTION void assemble_batch(const Task<D, Term, Motion, RealOf<S>>& task, const Batch<D>& b) {
  constexpr int Q = P + 1, QL = points_across<Term, Q>, points = power(Q, D - 1) * QL;
  using Trial = typename Term::template Trial<N, D>;
  using Test = typename Term::template Test<N, D>;
  constexpr int channels = Test::channel_count;
  const BatchBasis<S, D, P, Q, QL> basis(task.region, b);
  const BatchFields<S, N, D, P, Q, QL, Trial> fields(task, b, basis);
  const BatchGeometry<S, N, D, P, Q, Motion> geometry(task.region, b, basis.x, basis.y, task.motion);
  S out[channels][1 + D][points];
  for (int q = 0; q < points; ++q) {
    const auto point = point_at<Term, Q, S>(geometry, task.region, b, q);
    using Point = std::remove_const_t<decltype(point)>;
    const Test test = task.term.residual(Trial::read(Reader<N, D, decltype(fields), Point>{fields, point, q}));
    const S weight = task.factor * weight_at<S, D, Q>(task.region, b, q);
    test.write(Writer<S, N, D, points, Point>{out, point, weight, q});
  }
  const int first = first_test(task.region, b);
  for (int c = 0; c < channels; ++c) {
    S nodal[power(P + 1, D)];
    basis.template backward<Test::has_flux>(out[c], nodal);
    scatter<S, D, P>(task.test[c], task.region, first, b.count, nodal);
  }
}

/// Rows of elements along the first axis, numbered within one colour of the other axes: elements of a colour are
/// `stride` = degree + 1 apart, so they share no control point; with a shared test function a colour has one layer.
template <int D>
struct Colouring {
  int extent[D], start[D], step[D], count[D];

  template <class Real>
  Colouring(const Region<D, Real>& region, int stride, int colour, bool include_first) {
    for (int d = 0; d < D; ++d) {
      const bool coloured = d > 0 || include_first;
      extent[d] = region.axis[d].elements;
      step[d] = colours_of(region, stride, d);
      start[d] = coloured ? colour % step[d] : 0;
      if (coloured) colour /= step[d];
      count[d] = coloured ? (extent[d] - start[d] + step[d] - 1) / step[d] : 1;
    }
  }
  template <class Real>
  static int colours_of(const Region<D, Real>& region, int stride, int d) {
    return d == D - 1 && stride > 1 && region.shared_test ? region.axis[d].elements : stride;
  }
  int items() const {
    int n = 1;
    for (int d = 0; d < D; ++d) n *= count[d] > 0 ? count[d] : 0;
    return n;
  }
  KOKKOS_FUNCTION Batch<D> batch(int item) const {
    Batch<D> b{};
    b.count = 1;
    for (int d = 0; d < D; ++d) {
      b.element[d] = start[d] + step[d] * (item % count[d]);
      item /= count[d];
    }
    return b;
  }
};

/// Numbers of a batch: a lane for each element on the host. On a device single precision is a pack of one lane, because
/// packs round parameters to their precision, and a plain float would be computed as a double beside them.
template <class Real>
using BatchNumber = std::conditional_t<on_host || std::is_same_v<Real, float>, Pack<Real>, Real>;

/// Runs body(batch) for all elements of a row, `lanes` elements in a batch.
template <int D, int lanes, class Body>
KOKKOS_FORCEINLINE_FUNCTION void for_row(const Colouring<D>& rows, int row, const Body& body) {
  const int n = rows.extent[0];
  Batch<D> b = rows.batch(row);
  for (int e = 0; e < n; e += lanes) {
    b.element[0] = e;
    b.count = n - e < lanes ? n - e : lanes;
    body(b);
  }
}

/// An item of one colour: a row of elements on the host, one element on a device.
template <int D, int lanes, class Body>
struct ColourItem {
  Colouring<D> colouring;
  Body body;

  KOKKOS_FUNCTION void operator()(int item) const {
    if constexpr (on_host) {
      for_row<D, lanes>(colouring, item, body);
    } else {
      body(colouring.batch(item));
    }
  }
};

/// Runs body(batch) for all elements of a region, one colour after another.
template <int D, class Real, class Body>
void for_colours(const char* name, const Region<D, Real>& region, int stride, const Body& body) {
  constexpr int lanes = Lanes<BatchNumber<Real>>::count;
  int colours = 1;
  for (int d = on_host ? 1 : 0; d < D; ++d) colours *= Colouring<D>::colours_of(region, stride, d);
  for (int colour = 0; colour < colours; ++colour) {
    const Colouring<D> colouring(region, stride, colour, !on_host);
    if (colouring.items() == 0) continue;
    Kokkos::parallel_for(name, Kokkos::RangePolicy<Exec>(0, colouring.items()),
                         ColourItem<D, lanes, Body>{colouring, body});
  }
}

template <int D, int P, bool Tangent, class Term, class Motion, class Real>
struct AssembleBatch {
  Task<D, Term, Motion, Real> task;

  KOKKOS_FUNCTION void operator()(const Batch<D>& b) const {
    using S = BatchNumber<Real>;
    assemble_batch<S, std::conditional_t<Tangent, Dual<S>, S>, D, P, Term, Motion>(task, b);
  }
};

/// Adds the term's residual, or (Tangent) its Jacobian-vector product, to task.test[].
template <int P, bool Tangent, int D, class Term, class Motion, class Real>
void assemble(const Task<D, Term, Motion, Real>& task) {
  for_colours("softwet::assemble", task.region, P + 1, AssembleBatch<D, P, Tangent, Term, Motion, Real>{task});
}

}  // namespace softwet
