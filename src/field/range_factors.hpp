// A factor for each of some ranges of the entries of a vector.
#pragma once

#include <stdexcept>

#include "memory/array.hpp"

namespace softwet {

/// Entries that no range holds have the factor 1.
struct RangeFactors {
  static constexpr int most = 4;
  int count = 0, first[most] = {}, last[most] = {};
  double factor[most] = {};

  /// @throws std::logic_error  when there are more ranges than a vector has fields
  void add(int begin, int end, double value) {
    if (count == most) throw std::logic_error("more ranges than a vector has fields");
    first[count] = begin;
    last[count] = end;
    factor[count++] = value;
  }
  KOKKOS_FORCEINLINE_FUNCTION double at(int i) const {
    double value = 1;
    for (int f = 0; f < (host_algorithms ? count : most); ++f)  // ranges that are not there are empty
      if (i >= first[f] && i < last[f]) value = factor[f];
    return value;
  }
  /// Whether all ranges begin and end at multiples of a number.
  bool multiples_of(int length) const {
    bool all = true;
    for (int f = 0; f < count; ++f) all = all && first[f] % length == 0 && last[f] % length == 0;
    return all;
  }
};

}  // namespace softwet
