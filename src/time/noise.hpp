// Numbers that look random and are the same in every run: where searches for eigenvectors begin.
#pragma once

#include <cmath>

#include "field/vector.hpp"

namespace softwet {

/// Adds numbers that look random to the entries of a vector where `free` is 1; empty: to all. An entry's number follows
/// from its place in the vector of the whole patch.
struct AddNoise {
  Array a;
  ConstArray free;
  double scale;
  int stored, first, functions;  ///< columns of a line; VectorSpace::first_function, and those of it
  KOKKOS_FUNCTION void operator()(int i) const {
    const unsigned place = static_cast<unsigned>(i / stored) * functions + first + i % stored;
    const unsigned mixed = (place * 2654435761u) ^ (place >> 7);
    a(i) += scale * (free.extent(0) > 0 ? free(i) : 1.0) * ((mixed % 20011u) / 10005.0 - 1.0);
  }
};

/// Adds a tenth of a vector's length in noise, so that modes grow that have become the largest since the last search; to a
/// vector that is zero, noise alone.
inline void add_noise(const VectorSpace& space, const Array& a, const ConstArray& free) {
  constexpr double part = 0.1;
  const double all = static_cast<double>(a.extent(0)) / space.stored * space.functions;
  const double length = norm(space, a), size = all > 0 ? all : 1;
  const double scale = length > 0 ? part * length / std::sqrt(size) : 1;
  Kokkos::parallel_for("softwet::noise", Items(0, a.extent(0)),
                       AddNoise{a, free, scale, space.stored, space.first_function, space.functions});
}

}  // namespace softwet
