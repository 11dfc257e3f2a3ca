// The weights of Newton's fields on a vector, in one kernel.
#pragma once

#include <stdexcept>
#include <vector>

#include "field/array.hpp"

namespace softwet {

/// to(i) = factor from(i), with a factor for each range of entries; where none holds i, it is 1.
template <class To, class From>
struct ScaleFields {
  static constexpr int most = 4;
  ArrayOf<To> to;
  ConstArrayOf<From> from;
  int count = 0, first[most] = {}, last[most] = {};
  To factor[most] = {};

  void add(int begin, int end, double value) {
    if (count == most) throw std::logic_error("more fields than a vector has");
    first[count] = begin;
    last[count] = end;
    factor[count++] = static_cast<To>(value);
  }
  void run() const { Kokkos::parallel_for("softwet::scale", Kokkos::RangePolicy<Exec>(0, to.extent(0)), *this); }

  KOKKOS_FUNCTION void operator()(int i) const {
    To scale = 1;
    for (int f = 0; f < count; ++f)
      if (i >= first[f] && i < last[f]) scale = factor[f];
    to(i) = scale * static_cast<To>(from(i));
  }
};

}  // namespace softwet
