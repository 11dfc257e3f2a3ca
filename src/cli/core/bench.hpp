// What `softwet bench` measures of a case.
#pragma once

#include <ostream>

#include "case/case.hpp"

namespace softwet {

/// Times residual, products, each term, sums and the preconditioner at the initial state; prints the throughput.
template <int D, int P>
void bench_scene(const Case&, std::ostream&);

}  // namespace softwet
