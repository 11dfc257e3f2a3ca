// The bundle of a term that has a parameter which varies in space.
#pragma once

#include "kernels/point/fields.hpp"

namespace softwet {

/// What a term sees at a point, and the value of the given field there.
template <class Trial, class N>
struct WithGiven {
  Trial trial;
  N given;

  static constexpr int slot_count = Trial::slot_count + 1;
  static constexpr Slot slot(int s) {
    return s < Trial::slot_count ? Trial::slot(s) : Slot{{Field::given}, true, false};
  }
  template <class Reader>
  static KOKKOS_FORCEINLINE_FUNCTION WithGiven read(const Reader& at) {
    return {Trial::read(at), at.value(Trial::slot_count)};
  }
};

}  // namespace softwet
