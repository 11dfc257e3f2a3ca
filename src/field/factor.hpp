// Numbers in kernels that may change from step to step.
#pragma once

#include <type_traits>

#include "memory/array.hpp"

namespace softwet {

/// A number, or the place of one in memory of a device, which is read whenever the kernel runs: so a kernel that is
/// recorded goes on with new numbers.
class PlacedNumber {
 public:
  KOKKOS_FUNCTION PlacedNumber(double number = 0) : number_(number) {}
  KOKKOS_FUNCTION PlacedNumber(double number, const double* place) : number_(number), place_(place) {}
  KOKKOS_FORCEINLINE_FUNCTION operator double() const { return place_ ? *place_ : number_; }

 private:
  double number_;
  const double* place_ = nullptr;
};

/// A number of a kernel that may change from step to step. With the algorithms of a processor no step is recorded, and
/// it is a plain number.
using Factor = std::conditional_t<host_algorithms, double, PlacedNumber>;

/// The number at a place in memory of the device, where there is a place.
inline Factor factor_at([[maybe_unused]] const double* place, double number) {
  if constexpr (host_algorithms) {
    return number;
  } else {
    return PlacedNumber(number, place);
  }
}

}  // namespace softwet
