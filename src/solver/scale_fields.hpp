// Fields of a vector times factors of their own, in one kernel.
#pragma once

#include "field/range_factors.hpp"
#include "memory/array.hpp"

namespace softwet {

/// to(i) = factor(i) from(i)
template <class To, class From>
struct ScaleFields {
  ArrayOf<To> to;
  ConstArrayOf<From> from;
  RangeFactors factors = {};

  void run() const { Kokkos::parallel_for("softwet::scale", Items(0, to.extent(0)), *this); }
  KOKKOS_FUNCTION void operator()(int i) const { to(i) = static_cast<To>(factors.at(i)) * static_cast<To>(from(i)); }
};

}  // namespace softwet
