// The largest density on the sides of the fluid.
#pragma once

#include <array>

#include "field/vector.hpp"
#include "model/model.hpp"

namespace softwet {

/// Which axes end at each control point of the density: a bit for each axis that is not periodic. The wall above a solid is
/// an end too.
template <int D>
Kokkos::View<const int*, Exec> axes_that_end(const Layout<D>& l) {
  std::vector<int> ends(l.scalar_size(), 0);
  for (int i = 0; i < l.scalar_size(); ++i) {
    int rest = i;
    for (int d = 0; d < D; ++d) {
      const int extent = d == D - 1 ? l.fluid_rows() : l.extent(d), place = rest % extent;
      const int index = l.function(place, d), last = (d == D - 1 ? extent : l.axis[d].functions()) - 1;
      rest /= extent;
      if (!l.axis[d].periodic() && (index == 0 || index == last)) ends[i] |= 1 << d;
    }
  }
  return to_device<Kokkos::View<int*, Exec>>(ends, "side_density.ends");
}

/// The largest value at each kind of place, 0 where there is none.
struct LargestOfKinds {
  using value_type = double[];
  static constexpr int kinds = 8;
  unsigned value_count = kinds;
  ConstArray values;
  Kokkos::View<const int*, Exec> kind;

  KOKKOS_FUNCTION void init(double* best) const {
    for (int k = 0; k < kinds; ++k) best[k] = 0;
  }
  KOKKOS_FUNCTION void join(double* best, const double* other) const {
    for (int k = 0; k < kinds; ++k) best[k] = best[k] < other[k] ? other[k] : best[k];
  }
  KOKKOS_FUNCTION void operator()(int i, double* best) const {
    const int k = kind(i);
    if (best[k] < values(i)) best[k] = values(i);
  }
};

template <int D>
class SideDensity {
 public:
  explicit SideDensity(const Layout<D>& layout) : kind_(axes_that_end(layout)) {}

  /// By the axes that end there, a bit for each; [0] is inside.
  std::array<double, LargestOfKinds::kinds> largest(const ConstArray& density) const {
    std::array<double, LargestOfKinds::kinds> found{};
    const Kokkos::View<double*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> result(found.data(),
                                                                                                   found.size());
    Kokkos::parallel_reduce("softwet::side_density", Items(0, kind_.extent(0)), LargestOfKinds{8, density, kind_},
                            result);
    for (int k = 0; k < 1 << D; ++k) found[k] = ranks::largest(found[k]);
    return found;
  }

 private:
  Kokkos::View<const int*, Exec> kind_;
};

}  // namespace softwet
