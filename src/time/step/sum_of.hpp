// The sum of vectors that time schemes are made of.
#pragma once

#include "field/factor.hpp"

namespace softwet {

struct SumOf {
  Array y;
  Factor a, b, c;
  ConstArray x, z, w;
  KOKKOS_FUNCTION void operator()(int i) const { y(i) = a * x(i) + b * z(i) + c * w(i); }
};

/// A sum of vectors that is placed in a second one too, or no sum.
struct Kick {
  SumOf sum = {};
  Array placed = {};
  KOKKOS_FUNCTION void operator()(int i) const {
    sum(i);
    placed(i) = sum.y(i);
  }
};

/// y = a x + b z + c w, element by element; x, z, w have at least the length of y.
inline void sum_of(const Array& y, double a, const ConstArray& x, double b, const ConstArray& z, double c,
                   const ConstArray& w) {
  Kokkos::parallel_for("softwet::sum_of", Items(0, y.extent(0)), SumOf{y, a, b, c, x, z, w});
}

}  // namespace softwet
