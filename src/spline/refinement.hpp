// Coarse B-splines as sums of fine ones: an axis with half as many elements spans a part of the same space.
#pragma once

#include <vector>

#include "spline/axis.hpp"

namespace softwet {

/// N_I(coarse) = sum_k coefficient[I][k] N_{first[I] + k}(fine); periodic: fine indices wrap and may be negative.
struct Refinement {
  Axis coarse;
  std::vector<int> first;                        ///< [coarse function]
  std::vector<std::vector<double>> coefficient;  ///< [coarse function][fine function - first]
};

/// Half as many elements where their number and the kink are even and at least `least` elements remain; otherwise the
/// axis itself. Oslo algorithm (Cohen, Lyche, Riesenfeld, Comput. Graph. Image Process. 14, 1980).
Refinement refine_from_half(const Axis& fine, int least);

}  // namespace softwet
