// Functions of fields at all Gauss points of a region, kept for terms that remember them.
#pragma once

#include "operator/integrate_task.hpp"
#include "operator/rows.hpp"

namespace softwet {

/// Writes a vector lane by lane, as far as there are lanes.
template <class S>
KOKKOS_FORCEINLINE_FUNCTION void store_lanes(RealOf<S>* p, const S& x, int count) {
  if constexpr (Lanes<S>::count == 1) {
    *p = plain(x);
  } else {
    for (int l = 0; l < count; ++l) p[l] = x[l];
  }
}

/// The function of a batch, at the places of PointMemory.
template <int D, int P, int Q, class Function>
struct BatchAtPoints {
  ReduceTask<D, Function, NoMotion> task;
  Array out;

  KOKKOS_FUNCTION void operator()(const Batch<D>& b) const {
    using S = BatchNumber<double>;
    using Trial = typename Function::template Trial<S, D>;
    using Fields = BatchFields<S, S, D, P, Q, Q, Trial>;
    const Region<D>& region = task.region;
    const BatchBasis<S, D, P, Q, Q> basis(region, b);
    const Fields fields(task, b, basis);
    const BatchGeometry<S, S, D, P, Q, NoMotion> geometry(region, b, basis.x, basis.y, task.motion);
    for (int q = 0; q < Fields::points; ++q) {
      const auto point = point_at<Function, Q, S>(geometry, task, b, q);
      const Reader<S, D, Fields, std::remove_const_t<decltype(point)>> reader{fields, point, q};
      write(task.functional.value(Trial::read(reader)), b, q);
    }
  }

 private:
  template <class S, int size>
  KOKKOS_FORCEINLINE_FUNCTION void write(const Vector<S, size>& value, const Batch<D>& b, int q) const {
    using Memory = PointMemory<D, Q, size>;
    const Region<D>& region = task.region;
    double* const first = out.data() + Memory::place(region.stride, region.axis[1].elements, b.element, q);
    for (int k = 0; k < size; ++k) store_lanes<S>(first + k * Memory::apart(region.stride), value[k], b.count);
  }
};

/// out = the function of the fields of a task at all points of its region; no element is written twice.
template <int P, int D, class Function>
void write_at_points(const ReduceTask<D, Function, NoMotion>& task, const Array& out) {
  with_points<P>(task.region, [&]<int Q>(PointsPerAxis<Q>) {
    for_colours("softwet::at_points", task.region, 1, BatchAtPoints<D, P, Q, Function>{task, out});
  });
}

}  // namespace softwet
