// Integrals of functionals (mass, energies, dissipation) over a region, summed in one fixed order.
#pragma once

#include <array>

#include "field/vector.hpp"
#include "operator/device/team_reduce.hpp"
#include "operator/rows.hpp"

namespace softwet {

/// N = S: the integral. N = Dual<S>: its rate of change by the motion of the domain alone, at fixed fields.
template <class S, class N, int D, int P, int Q, class Functional, class Motion>
KOKKOS_FUNCTION void reduce_batch(const ReduceTask<D, Functional, Motion>& task, const Batch<D>& b, double* sum) {
  constexpr int QL = points_across<Functional, Q>, points = power(Q, D - 1) * QL;
  using Trial = typename Functional::template Trial<N, D>;
  using Fields = BatchFields<S, S, D, P, Q, QL, typename Functional::template Trial<S, D>>;
  const BatchBasis<S, D, P, Q, QL> basis(task.region, b);
  const Fields values(task, b, basis);
  const LiftedFields<Fields, N> fields{values};
  const BatchGeometry<S, N, D, P, Q, Motion> geometry(task.region, b, basis.x, basis.y, task.motion);
  for (int q = 0; q < points; ++q) {
    const auto point = point_at<Functional, Q, S>(geometry, task.region, b, q);
    const Reader<N, D, std::remove_const_t<decltype(fields)>, std::remove_const_t<decltype(point)>> reader{fields,
                                                                                                           point, q};
    const Vector<N, Functional::count> value = task.functional.value(Trial::read(reader));
    const S weight = weight_at<S, D, Q>(task.region, b, q);
    for (int f = 0; f < Functional::count; ++f) {
      const S part = weight * outcome(point.measured(value[f]));
      if constexpr (is_one_number<S>) {
        sum[f] += part;
      } else {
        for (int l = 0; l < b.count; ++l) sum[f] += part[l];
      }
    }
  }
}

/// Partial sums of one strip of one row of elements, element by element.
template <int D, int P, int Q, bool Rate, class Functional, class Motion>
struct ReduceRow {
  ReduceTask<D, Functional, Motion> task;
  Colouring<D> rows;
  Array partial;  ///< [row][own strip][functional]

  KOKKOS_FUNCTION void operator()(int item) const {
    using S = BatchNumber<double>;
    using N = std::conditional_t<Rate, Dual<S>, S>;
    constexpr int lanes = Lanes<S>::count;
    double sum[Functional::count] = {};
    const ElementColumns& columns = rows.first_axis;
    const int strips = columns.last_strip - columns.first_strip, strip = item % strips;
    const int first = columns.own_begin + strip * strip_width;
    const int last = strip + 1 < strips ? first + strip_width : columns.own_end;
    Batch<D> b = rows.batch(item / strips);
    for (b.element[0] = first; b.element[0] < last; b.element[0] += lanes) {
      b.count = last - b.element[0] < lanes ? last - b.element[0] : lanes;
      reduce_batch<S, N, D, P, Q, Functional, Motion>(task, b, sum);
    }
    for (int f = 0; f < Functional::count; ++f) partial(item * Functional::count + f) = sum[f];
  }
};

/// The rows of elements of an integral, cut into strips.
template <int D>
struct IntegralItems {
  Colouring<D> rows;
  int strips, items;
  bool shared;

  explicit IntegralItems(const Region<D>& region)
      : rows(region, 1, 0, FirstAxis::in_rows),
        strips(rows.first_axis.last_strip - rows.first_axis.first_strip),
        items(rows.items() * strips),
        shared(region.columns.strips > 0) {}

  /// From the partial sums of the items, over all processes.
  template <int count, class Partial>
  std::array<double, count> total(const Partial& partial) const {
    StripTotals totals(rows.first_axis.strips, count, shared);
    for (int i = 0; i < items; ++i)
      for (int f = 0; f < count; ++f) totals.add(rows.first_axis.first_strip + i % strips, f, partial(i * count + f));
    std::array<double, count> sum{};
    for (int f = 0; f < count; ++f) sum[f] = totals.total(f);
    return sum;
  }
};

/// Starts the kernel of the partial sums of an integral.
template <int P, bool Rate = false, int D, class Functional, class Motion>
void start_integral(const ReduceTask<D, Functional, Motion>& task, const Array& partial) {
  const IntegralItems<D> in(task.region);
  with_points<P>(task.region, [&]<int Q>(PointsPerAxis<Q>) {
    if constexpr (host_algorithms) {
      Kokkos::parallel_for("softwet::reduce", Items(0, in.items),
                           ReduceRow<D, P, Q, Rate, Functional, Motion>{task, in.rows, partial});
    } else {
      TeamReduce<D, P, Q, Rate, Functional, Motion>::launch(task, in.rows, partial, in.items);
    }
  });
}

/// With Rate, not the integrals but the rates at which they change because the domain moves; `motion.tangent` is then the
/// velocity of the wall and `motion.scale` 1.
template <int P, bool Rate = false, int D, class Functional, class Motion>
std::array<double, Functional::count> reduce(const ReduceTask<D, Functional, Motion>& task) {
  constexpr int count = Functional::count;
  const IntegralItems<D> in(task.region);
  const SumScratch& scratch = sum_scratch(static_cast<std::size_t>(in.items) * count);
  start_integral<P, Rate>(task, scratch.device);
  Kokkos::deep_copy(scratch.host, scratch.device);
  return in.template total<count>(scratch.host);
}

/// Starts those of two integrals, on a device as one.
template <int P, int D, class First, class FirstMotion, class Second, class SecondMotion>
void start_integrals(const ReduceTask<D, First, FirstMotion>& first, const Array& partial_of_first,
                     const ReduceTask<D, Second, SecondMotion>& second, const Array& partial_of_second) {
  if constexpr (host_algorithms) {
    start_integral<P>(first, partial_of_first);
    start_integral<P>(second, partial_of_second);
  } else {
    const IntegralItems<D> in_first(first.region), in_second(second.region);
    with_points<P>(first.region, [&]<int Q>(PointsPerAxis<Q>) {
      with_points<P>(second.region, [&]<int R>(PointsPerAxis<R>) {
        using One = TeamReduce<D, P, Q, false, First, FirstMotion>;
        using Other = TeamReduce<D, P, R, false, Second, SecondMotion>;
        TeamReducePair<One, Other>{
            {first, in_first.rows, partial_of_first}, {second, in_second.rows, partial_of_second}, in_first.items}
            .launch(in_second.items);
      });
    });
  }
}

}  // namespace softwet
