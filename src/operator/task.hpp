// A term on a region: what its kernels read, at which points, and what they see and write there.
#pragma once

#include "kernels/point/fields.hpp"
#include "operator/motion.hpp"
#include "operator/packed.hpp"

namespace softwet {

/// Points of a term along the last axis, of Q on an axis: one where it acts on a face.
template <class Term, int Q>
inline constexpr int points_across = on_face(Term::where) ? 1 : Q;

/// Number of Gauss points on an element along an axis, as a type.
template <int Q>
using PointsPerAxis = std::integral_constant<int, Q>;

/// Whether the program has kernels for reduced quadrature: the CMake option SOFTWET_REDUCED_QUADRATURE.
#ifdef SOFTWET_NO_REDUCED_QUADRATURE
inline constexpr bool has_reduced_quadrature = false;
#else
inline constexpr bool has_reduced_quadrature = true;
#endif

/// Calls body with the points per axis of a region's rules: degree + 1, or as many as the degree.
template <int P, int D, class Real, class Body>
void with_points(const Region<D, Real>& region, const Body& body) {
  if constexpr (has_reduced_quadrature)
    if (region.axis[0].points == P) return body(PointsPerAxis<P>());
  body(PointsPerAxis<P + 1>());
}

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
  Real factor = 1;               ///< of the integrals
  const Real* memory = nullptr;  ///< of the points (PointMemory); null: they remember nothing
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

/// How many numbers a trial bundle remembers at each point.
template <class Trial>
inline constexpr int memory_size_of = [] {
  if constexpr (requires { Trial::memory_size; }) return Trial::memory_size;
  return 0;
}();

/// Where the points of a region keep numbers in addition to the fields, `size` at each of the Q^D points of an element:
/// [layer of elements] [row][number][point][column], so that an element has the column of its first control point, and
/// neighbours share a pack.
template <int D, int Q, int size>
struct PointMemory {
  static constexpr int points = power(Q, D);

  /// @param stride  of the region: stored columns are the columns of its second axis
  static KOKKOS_FORCEINLINE_FUNCTION int apart(const int (&stride)[D]) { return points * stride[1]; }
  /// Place of number 0 at point q of an element. @param rows  of elements along the second of three axes
  static KOKKOS_FORCEINLINE_FUNCTION int place(const int (&stride)[D], int rows, const int (&element)[D], int q) {
    const int row = D == 3 ? element[D - 1] * rows + element[1] : element[D - 1];
    return row * size * apart(stride) + q * stride[1] + element[0];
  }
};

/// A point with the numbers that it remembers.
template <class Point, class S>
struct RememberingPoint : Point {
  const RealOf<S>* memory;  ///< number 0; null: none
  int apart, count;         ///< from one number to the next; lanes

  KOKKOS_FORCEINLINE_FUNCTION bool remembers() const { return memory != nullptr; }
  KOKKOS_FORCEINLINE_FUNCTION S remembered(int k) const {
    return memory ? load_lanes<S>(memory + k * apart, count) : S(0.0);
  }
};

/// A point of the element of a batch for a term with the trial bundle Trial.
template <class Trial, int Q, class S, int D, class Point>
KOKKOS_FORCEINLINE_FUNCTION auto with_memory(const Point& point, const RealOf<S>* memory, const int (&stride)[D],
                                             int rows, const Batch<D>& b, int q) {
  constexpr int size = memory_size_of<Trial>;
  if constexpr (size == 0) {
    return point;
  } else {
    using Memory = PointMemory<D, Q, size>;
    return RememberingPoint<Point, S>{
        {point}, memory ? memory + Memory::place(stride, rows, b.element, q) : nullptr, Memory::apart(stride), b.count};
  }
}

/// Answers about the fields of TrialFields, by loops over slots: for the compiler alone.
template <class Trial, int D>
struct FieldsFound {
  static constexpr int slots = Trial::slot_count;

  static constexpr int tangent_of(int unknown) {
    int place = slots;
    for (int u = 0; u < unknown; ++u) place += reads<Trial, D>(u) ? 1 : 0;
    return place;
  }
  static constexpr int unknown_of(int field) {
    int u = 0;
    while (!reads<Trial, D>(u) || tangent_of(u) != field) ++u;
    return u;
  }
  static constexpr bool needs(int field, bool Slot::*what) {
    return field < slots ? Trial::slot(field).*what : reads<Trial, D>(unknown_of(field), what);
  }
};

/// The fields that a device interpolates: the slots of a term and then, for a product, the tangents of the unknowns
/// that it reads. What a kernel asks for is read from constants.
template <class Trial, int D, bool Tangent>
struct TrialFields {
  using Found = FieldsFound<Trial, D>;
  static constexpr int slots = Trial::slot_count;
  static constexpr int fields = Tangent ? Found::tangent_of(D + 2) : slots;

  /// Whether the term reads an unknown.
  static constexpr bool reads_unknown(int unknown) { return unpacked(read_unknowns, unknown) != 0; }
  /// Place of the tangent of an unknown among the fields.
  static constexpr int tangent_of(int unknown) { return unpacked(tangent_places, unknown); }
  /// The unknown whose tangent a field is.
  static constexpr int unknown_of(int field) { return unpacked(unknowns_of_tangents, field - slots); }
  /// The unknown that a slot follows from; D + 2: none of them.
  static constexpr int unknown_of_slot(int s) { return unpacked(unknowns_of_slots, s); }
  static constexpr bool has_value(int field) { return unpacked(with_value, field) != 0; }
  static constexpr bool has_gradient(int field) { return unpacked(with_gradient, field) != 0; }

 private:
  static constexpr Packed read_unknowns = packed<D + 2>([](int u) { return reads<Trial, D>(u) ? 1 : 0; });
  static constexpr Packed tangent_places = packed<D + 3>([](int u) { return Found::tangent_of(u); });
  static constexpr Packed unknowns_of_tangents =
      packed<fields - slots>([](int f) { return Found::unknown_of(slots + f); });
  static constexpr Packed unknowns_of_slots = packed<slots>([](int s) { return Trial::slot(s).from.unknown(D); });
  static constexpr Packed with_value = packed<fields>([](int f) { return Found::needs(f, &Slot::value) ? 1 : 0; });
  static constexpr Packed with_gradient =
      packed<fields>([](int f) { return Found::needs(f, &Slot::gradient) ? 1 : 0; });
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
    SOFTWET_UNROLL
    for (int d = 0; d < D; ++d) g[d] = fields.number(s, 1 + d, q);
    return point.physical(g);
  }
  /// Value over the distance from the axis, in the coordinates (r, z).
  KOKKOS_FORCEINLINE_FUNCTION N over_radius(int s) const { return value(s) / point.radius(); }
  KOKKOS_FORCEINLINE_FUNCTION bool remembers() const { return point.remembers(); }
  KOKKOS_FORCEINLINE_FUNCTION N remembered(int k) const { return unmoved<N>(point.remembered(k)); }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> mesh_velocity() const { return point.mesh_velocity(); }
  KOKKOS_FORCEINLINE_FUNCTION N volume_ratio() const { return point.volume_ratio(); }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> position() const { return point.position; }
  KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> normal() const { return point.normal; }  ///< on the moving wall
  KOKKOS_FORCEINLINE_FUNCTION N area_ratio() const { return point.area_ratio(); }   ///< on the moving wall
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
    add_flux(channel, flux);
  }
  /// Adds the values and fluxes of a point in the coordinates (r, z), which have a hoop entry.
  KOKKOS_FORCEINLINE_FUNCTION void add(int channel, const N& value, const Vector<N, D>& flux, const N& hoop) const {
    out[channel][0][q] = weight * outcome(point.measured(value, hoop));
    add_flux(channel, flux);
  }

 private:
  KOKKOS_FORCEINLINE_FUNCTION void add_flux(int channel, const Vector<N, D>& flux) const {
    const auto f = point.reference_flux(flux);
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

/// A point in the coordinates of a term. @param reference  its position where nothing is deformed
template <class Term, class Point, class S, int D>
KOKKOS_FORCEINLINE_FUNCTION auto in_coordinates(const Point& point, const Vector<S, D>& reference) {
  if constexpr (is_axisymmetric<Term>) {
    return AxialPoint<Point>(point, reference[0]);
  } else {
    return point;
  }
}

/// Geometry at point q of a batch, and what it remembers. @param task  a Task or a ReduceTask
template <class Term, int Q, class S, class TaskType, int D, class BatchGeometryType>
KOKKOS_FORCEINLINE_FUNCTION auto point_at(const BatchGeometryType& geometry, const TaskType& task, const Batch<D>& b,
                                          int q) {
  constexpr int wall_points = power(Q, D - 1);
  const Region<D, RealOf<S>>& region = task.region;
  const RealOf<S> height = region.axis[D - 1].position(q / wall_points, b.element[D - 1]);
  Vector<S, D> reference;
  reference[0] = load<S>(&region.axis[0].position(q % Q, b.element[0]));
  if constexpr (D == 3) reference[1] = S(region.axis[1].position((q % wall_points) / Q, b.element[1]));
  reference[D - 1] = S(height);
  const auto point = in_coordinates<Term>(geometry.template at<on_face(Term::where)>(q, reference, height), reference);
  return with_memory<typename TaskType::Trial, Q, S>(point, task.memory, region.stride, region.axis[1].elements, b, q);
}

}  // namespace softwet
