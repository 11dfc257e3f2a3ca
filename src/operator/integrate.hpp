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
    const auto point = point_at<Functional, Q, S>(geometry, task, b, q);
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

/// With Rate, not the integrals but the rates at which they change because the domain moves; `motion.tangent` is then the
/// velocity of the wall and `motion.scale` 1.
template <int P, bool Rate = false, int D, class Functional, class Motion>
std::array<double, Functional::count> reduce(const ReduceTask<D, Functional, Motion>& task) {
  constexpr int count = Functional::count;
  const Colouring<D> rows(task.region, 1, 0, false);
  const ElementColumns& columns = rows.first_axis;
  const int strips = columns.last_strip - columns.first_strip, items = rows.items() * strips;
  const SumScratch& scratch = sum_scratch(static_cast<std::size_t>(items) * count);
  with_points<P>(task.region, [&]<int Q>(PointsPerAxis<Q>) {
    if constexpr (host_algorithms) {
      Kokkos::parallel_for("softwet::reduce", Items(0, items),
                           ReduceRow<D, P, Q, Rate, Functional, Motion>{task, rows, scratch.device});
    } else {
      TeamReduce<D, P, Q, Rate, Functional, Motion>::launch(task, rows, scratch.device, items);
    }
  });
  Kokkos::deep_copy(scratch.host, scratch.device);
  StripTotals totals(columns.strips, count, task.region.columns.strips > 0);
  for (int i = 0; i < items; ++i)
    for (int f = 0; f < count; ++f) totals.add(columns.first_strip + i % strips, f, scratch.host(i * count + f));
  std::array<double, count> sum{};
  for (int f = 0; f < count; ++f) sum[f] = totals.total(f);
  return sum;
}

}  // namespace softwet
