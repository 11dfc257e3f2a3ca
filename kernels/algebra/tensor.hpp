// Small dense vectors and matrices of numbers at a point.
#pragma once

#include "kernels/algebra/dual.hpp"

/// Before a loop over components: device compilers unroll it, so that what it indexes stays in registers.
#if defined(__CUDA_ARCH__) || defined(__HIP_DEVICE_COMPILE__)
#define SOFTWET_UNROLL _Pragma("unroll")
#else
#define SOFTWET_UNROLL
#endif

namespace softwet {

template <class N, int D>
struct Vector {
  N c[D];
  KOKKOS_FORCEINLINE_FUNCTION N& operator[](int i) { return c[i]; }
  KOKKOS_FORCEINLINE_FUNCTION const N& operator[](int i) const { return c[i]; }
};

template <class N, int D>
struct Matrix {
  N c[D][D];
  KOKKOS_FORCEINLINE_FUNCTION N& operator()(int i, int j) { return c[i][j]; }
  KOKKOS_FORCEINLINE_FUNCTION const N& operator()(int i, int j) const { return c[i][j]; }
};

template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> operator+(const Vector<N, D>& a, const Vector<N, D>& b) {
  Vector<N, D> r;
  for (int i = 0; i < D; ++i) r[i] = a[i] + b[i];
  return r;
}
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> operator-(const Vector<N, D>& a, const Vector<N, D>& b) {
  Vector<N, D> r;
  for (int i = 0; i < D; ++i) r[i] = a[i] - b[i];
  return r;
}
template <class N, class F, int D>
KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> operator*(const F& s, const Vector<N, D>& a) {
  Vector<N, D> r;
  for (int i = 0; i < D; ++i) r[i] = s * a[i];
  return r;
}
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION N dot(const Vector<N, D>& a, const Vector<N, D>& b) {
  N r = a[0] * b[0];
  for (int i = 1; i < D; ++i) r = r + a[i] * b[i];
  return r;
}

/// Dual numbers from values and their tangents.
template <class S, int D>
KOKKOS_FORCEINLINE_FUNCTION Vector<Dual<S>, D> join(const Vector<S, D>& value, const Vector<S, D>& tangent) {
  Vector<Dual<S>, D> r;
  for (int i = 0; i < D; ++i) r[i] = Dual<S>(value[i], tangent[i]);
  return r;
}

template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> operator+(const Matrix<N, D>& a, const Matrix<N, D>& b) {
  Matrix<N, D> r;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) r(i, j) = a(i, j) + b(i, j);
  return r;
}
template <class N, class F, int D>
KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> operator*(const F& s, const Matrix<N, D>& a) {
  Matrix<N, D> r;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) r(i, j) = s * a(i, j);
  return r;
}

/// (A B)_ij = A_ik B_kj
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> product(const Matrix<N, D>& a, const Matrix<N, D>& b) {
  Matrix<N, D> r;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) {
      r(i, j) = a(i, 0) * b(0, j);
      for (int k = 1; k < D; ++k) r(i, j) = r(i, j) + a(i, k) * b(k, j);
    }
  return r;
}
/// (A b)_i = A_ij b_j
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Vector<N, D> product(const Matrix<N, D>& a, const Vector<N, D>& b) {
  Vector<N, D> r;
  for (int i = 0; i < D; ++i) {
    r[i] = a(i, 0) * b[0];
    for (int k = 1; k < D; ++k) r[i] = r[i] + a(i, k) * b[k];
  }
  return r;
}
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> transpose(const Matrix<N, D>& a) {
  Matrix<N, D> r;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) r(i, j) = a(j, i);
  return r;
}
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION N trace(const Matrix<N, D>& a) {
  N r = a(0, 0);
  for (int i = 1; i < D; ++i) r = r + a(i, i);
  return r;
}
/// A : B
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION N contract(const Matrix<N, D>& a, const Matrix<N, D>& b) {
  N r = a(0, 0) * b(0, 0);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      if (i + j > 0) r = r + a(i, j) * b(i, j);
  return r;
}
/// (a (x) b)_ij = a_i b_j
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> outer(const Vector<N, D>& a, const Vector<N, D>& b) {
  Matrix<N, D> r;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) r(i, j) = a[i] * b[j];
  return r;
}
/// A + s I
template <class N, class F, int D>
KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> add_diagonal(Matrix<N, D> a, const F& s) {
  for (int i = 0; i < D; ++i) a(i, i) = a(i, i) + s;
  return a;
}

/// Cofactor matrix: cof(A) = det(A) A^-T.
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Matrix<N, D> cofactor(const Matrix<N, D>& a) {
  Matrix<N, D> r;
  if constexpr (D == 2) {
    r(0, 0) = a(1, 1);
    r(0, 1) = -a(1, 0);
    r(1, 0) = -a(0, 1);
    r(1, 1) = a(0, 0);
  } else {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        r(i, j) = a(i1, j1) * a(i2, j2) - a(i1, j2) * a(i2, j1);
      }
  }
  return r;
}
/// det(A) by the first row, given cof(A).
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION N determinant(const Matrix<N, D>& a, const Matrix<N, D>& cof) {
  N r = a(0, 0) * cof(0, 0);
  for (int j = 1; j < D; ++j) r = r + a(0, j) * cof(0, j);
  return r;
}

}  // namespace softwet
