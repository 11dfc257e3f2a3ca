// Gradients and stresses of states that do not depend on the angle about an axis.
#pragma once

#include "kernels/algebra/tensor.hpp"

namespace softwet {

/// A tensor in cylindrical coordinates (r, z, angle) that has no entry between the angle and another axis: a 2 x 2
/// matrix along r and z, and the hoop entry. Functions of a tensor do with it what they do with the 3 x 3 matrix that
/// it represents; what follows (r, z) alone, such as A b, takes the 2 x 2 part.
/// Tested: tests/unit/algebra/test_axial.cpp
template <class N>
struct AxialMatrix {
  Matrix<N, 2> plane;  ///< along r and z
  N hoop;              ///< about the axis

  KOKKOS_FORCEINLINE_FUNCTION N& operator()(int i, int j) { return plane(i, j); }
  KOKKOS_FORCEINLINE_FUNCTION const N& operator()(int i, int j) const { return plane(i, j); }
};

template <class M>
inline constexpr bool is_axial_matrix = false;
template <class N>
inline constexpr bool is_axial_matrix<AxialMatrix<N>> = true;

/// A matrix of the axes as a tensor of the kind M; a hoop entry is 0.
template <class M, class N, int D>
KOKKOS_FORCEINLINE_FUNCTION M embedded(const Matrix<N, D>& a) {
  if constexpr (is_axial_matrix<M>) {
    return {a, N(0.0)};
  } else {
    return a;
  }
}

template <class N>
KOKKOS_FORCEINLINE_FUNCTION AxialMatrix<N> operator+(const AxialMatrix<N>& a, const AxialMatrix<N>& b) {
  return {a.plane + b.plane, a.hoop + b.hoop};
}
template <class N, class F>
KOKKOS_FORCEINLINE_FUNCTION AxialMatrix<N> operator*(const F& s, const AxialMatrix<N>& a) {
  return {s * a.plane, s * a.hoop};
}
template <class N>
KOKKOS_FORCEINLINE_FUNCTION AxialMatrix<N> product(const AxialMatrix<N>& a, const AxialMatrix<N>& b) {
  return {product(a.plane, b.plane), a.hoop * b.hoop};
}
template <class N>
KOKKOS_FORCEINLINE_FUNCTION Vector<N, 2> product(const AxialMatrix<N>& a, const Vector<N, 2>& b) {
  return product(a.plane, b);
}
template <class N>
KOKKOS_FORCEINLINE_FUNCTION AxialMatrix<N> transpose(const AxialMatrix<N>& a) {
  return {transpose(a.plane), a.hoop};
}
template <class N>
KOKKOS_FORCEINLINE_FUNCTION N trace(const AxialMatrix<N>& a) {
  return trace(a.plane) + a.hoop;
}
template <class N>
KOKKOS_FORCEINLINE_FUNCTION N contract(const AxialMatrix<N>& a, const AxialMatrix<N>& b) {
  return contract(a.plane, b.plane) + a.hoop * b.hoop;
}
template <class N, class F>
KOKKOS_FORCEINLINE_FUNCTION AxialMatrix<N> add_diagonal(const AxialMatrix<N>& a, const F& s) {
  return {add_diagonal(a.plane, s), a.hoop + s};
}
/// Cofactor matrix: of the block along r and z it has the factor of the hoop entry.
template <class N>
KOKKOS_FORCEINLINE_FUNCTION AxialMatrix<N> cofactor(const AxialMatrix<N>& a) {
  const Matrix<N, 2> plane = cofactor(a.plane);
  return {a.hoop * plane, determinant(a.plane, plane)};
}
/// det(A), given cof(A).
template <class N>
KOKKOS_FORCEINLINE_FUNCTION N determinant(const AxialMatrix<N>& a, const AxialMatrix<N>& cof) {
  return a.hoop * cof.hoop;
}

}  // namespace softwet
