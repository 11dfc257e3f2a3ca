// Numbers that look random and are the same in every run: where searches for eigenvectors begin.
#pragma once

#include <cmath>

#include "field/vector.hpp"

namespace softwet {

/// Adds numbers that look random to the entries of a vector where `free` is 1; empty: to all.
struct AddNoise {
  Array a;
  ConstArray free;
  double scale;
  KOKKOS_FUNCTION void operator()(int i) const {
    const unsigned mixed = (static_cast<unsigned>(i) * 2654435761u) ^ (static_cast<unsigned>(i) >> 7);
    a(i) += scale * (free.extent(0) > 0 ? free(i) : 1.0) * ((mixed % 20011u) / 10005.0 - 1.0);
  }
};

/// Adds a tenth of a vector's length in noise, so that modes grow that have become the largest since the last search; to a
/// vector that is zero, noise alone.
inline void add_noise(const Array& a, const ConstArray& free) {
  constexpr double part = 0.1;
  const double length = norm(a), size = a.extent(0) > 0 ? a.extent(0) : 1;
  const double scale = length > 0 ? part * length / std::sqrt(size) : 1;
  Kokkos::parallel_for("softwet::noise", Kokkos::RangePolicy<Exec>(0, a.extent(0)), AddNoise{a, free, scale});
}

}  // namespace softwet
