// Where `softwet bench` ends when it is asked to.
#pragma once

#include "field/ranks.hpp"
#include "run/interrupt.hpp"

namespace softwet {

/// Thrown between two measurements.
struct BenchStopped {};

/// Throws BenchStopped in all processes once one of them was asked to stop.
inline void go_on_with_bench() {
  if (ranks::largest(stop_requested() ? 1 : 0) > 0) throw BenchStopped();
}

}  // namespace softwet
