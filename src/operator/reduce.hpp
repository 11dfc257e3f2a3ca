// Integrals of functionals (mass, energies, dissipation) over a region, summed in one fixed order.
#pragma once

#include <array>

#include "operator/assemble.hpp"

namespace softwet {

/// Like Task, for a functional: no tangent, no test functions.
template <int D, class Functional, class Motion>
struct ReduceTask {
  using Trial = typename Functional::template Trial<double, D>;

  Region<D> region;
  Functional functional;
  Motion motion;
  const double* slot[Trial::slot_count];
  double scale[scale_count] = {};
};

template <class S, int D, int P, int QL, class Functional, class Motion>
KOKKOS_FUNCTION void reduce_batch(const ReduceTask<D, Functional, Motion>& task, const Batch<D>& b, double* sum) {
  constexpr int Q = P + 1, wall_points = power(Q, D - 1), points = wall_points * QL;
  using Trial = typename Functional::template Trial<S, D>;
  const BatchBasis<S, D, P, Q, QL> basis(task.region, b);
  const BatchFields<S, S, D, P, Q, QL, Trial> fields(task, b, basis);
  const BatchGeometry<S, S, D, P, Q, Motion> geometry(task.region, b, basis.x, basis.y, task.motion);
  for (int q = 0; q < points; ++q) {
    const auto point = geometry.at(q, task.region.axis[D - 1].position(q / wall_points, b.element[D - 1]), QL == 1);
    const Reader<S, D, decltype(fields), std::remove_const_t<decltype(point)>> reader{fields, point, q};
    const Vector<S, Functional::count> value = task.functional.value(Trial::read(reader));
    const S weight = weight_at<S, D, Q>(task.region, b, q);
    for (int f = 0; f < Functional::count; ++f) {
      const S part = weight * point.measured(value[f]);
      if constexpr (Lanes<S>::count == 1) {
        sum[f] += part;
      } else {
        for (int l = 0; l < b.count; ++l) sum[f] += part[l];
      }
    }
  }
}

/// Partial sums of one row of elements.
template <int D, int P, int QL, class Functional, class Motion>
struct ReduceRow {
  ReduceTask<D, Functional, Motion> task;
  Colouring<D> rows;
  Kokkos::View<double**, Kokkos::LayoutRight, Exec> partial;

  KOKKOS_FUNCTION void operator()(int item) const {
    using S = std::conditional_t<on_host, Pack<double>, double>;
    double sum[Functional::count] = {};
    for_packs<D>(task.region, rows.batch(item), Lanes<S>::count,
                 [&](const Batch<D>& b) { reduce_batch<S, D, P, QL, Functional, Motion>(task, b, sum); });
    for (int f = 0; f < Functional::count; ++f) partial(item, f) = sum[f];
  }
};

template <int P, int QL, int D, class Functional, class Motion>
std::array<double, Functional::count> reduce(const ReduceTask<D, Functional, Motion>& task) {
  const Colouring<D> rows(task.region, 1, 0, false);
  Kokkos::View<double**, Kokkos::LayoutRight, Exec> partial("partial", rows.items(), Functional::count);
  Kokkos::parallel_for("softwet::reduce", Kokkos::RangePolicy<Exec>(0, rows.items()),
                       ReduceRow<D, P, QL, Functional, Motion>{task, rows, partial});
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), partial);
  std::array<double, Functional::count> sum{};
  for (std::size_t r = 0; r < host.extent(0); ++r)
    for (int f = 0; f < Functional::count; ++f) sum[f] += host(r, f);
  return sum;
}

}  // namespace softwet
