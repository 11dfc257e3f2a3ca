// The terms of a scene, as lists in both precisions.
#pragma once

#include "scene/pieces.hpp"

namespace softwet {

/// What a case asks for, and nothing else. Each list is made where its terms are compiled (make_pieces.hpp).
template <int D, int P>
class Terms {
 public:
  Terms(const Regions<D>& regions, const Coefficients<D>& coefficients, const Case& c)
      : pieces_(made<double>(regions, coefficients, c)), single_(made<float>(regions, coefficients, c)) {}

  const Pieces<D, double>& pieces() const { return pieces_; }
  const Pieces<D, float>& single_pieces() const { return single_; }

 private:
  template <class Real>
  static Pieces<D, Real> made(const Regions<D>& regions, const Coefficients<D>& coefficients, const Case& c) {
    if constexpr (D == 2)
      if (c.axisymmetric()) return make_axisymmetric_pieces<D, P, Real>(regions, coefficients, c);
    return make_pieces<D, P, Real>(regions, coefficients, c);
  }

  Pieces<D, double> pieces_;
  Pieces<D, float> single_;
};

}  // namespace softwet
