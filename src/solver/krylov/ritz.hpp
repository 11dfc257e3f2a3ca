// Eigenvalues of an operator from its projection on a Krylov space.
#pragma once

#include <complex>
#include <vector>

namespace softwet {

struct RitzValue {
  std::complex<double> value;
  double error;  ///< ||A x - value x|| / ||x|| of its vector x
};

/// The eigenvalues of the projection of an operator A. Arnoldi's method has made an orthonormal basis v_0, v_1, ...
/// with A v_j = sum_{i <= j+1} h_ij v_i.
/// @param columns  h_0j .. h_{j+1,j} of each j
/// Source: Saad 1992, section 6.2.   Tested: tests/unit/solver/krylov/test_ritz.cpp
std::vector<RitzValue> ritz_values(const std::vector<std::vector<double>>& columns);

}  // namespace softwet
