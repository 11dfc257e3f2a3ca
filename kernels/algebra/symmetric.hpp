// Symmetric tensors as lists of their different entries.
#pragma once

#include "kernels/algebra/axial.hpp"

namespace softwet {

/// Different entries of a symmetric tensor: D (D + 1) / 2, and one more in the coordinates (r, z).
template <class M>
inline constexpr int symmetric_entries = 0;
template <class N, int D>
inline constexpr int symmetric_entries<Matrix<N, D>> = D*(D + 1) / 2;
template <class N>
inline constexpr int symmetric_entries<AxialMatrix<N>> = 4;

/// The entries on and above the diagonal, row by row, and then the hoop entry.
/// Tested: tests/unit/solid/test_branches.cpp
template <class N, int D>
KOKKOS_FORCEINLINE_FUNCTION Vector<N, D*(D + 1) / 2> entries_of(const Matrix<N, D>& a) {
  Vector<N, D*(D + 1) / 2> all;
  int k = 0;
  SOFTWET_UNROLL
  for (int i = 0; i < D; ++i) SOFTWET_UNROLL
  for (int j = i; j < D; ++j) all[k++] = a(i, j);
  return all;
}
template <class N>
KOKKOS_FORCEINLINE_FUNCTION Vector<N, 4> entries_of(const AxialMatrix<N>& a) {
  return {{a(0, 0), a(0, 1), a(1, 1), a.hoop}};
}

/// The symmetric tensor of the kind M with the entries entry(0), entry(1), ...
template <class M, int D, class Entry>
KOKKOS_FORCEINLINE_FUNCTION M symmetric_of(const Entry& entry) {
  M a;
  int k = 0;
  SOFTWET_UNROLL
  for (int i = 0; i < D; ++i) SOFTWET_UNROLL
  for (int j = i; j < D; ++j) a(i, j) = a(j, i) = entry(k++);
  if constexpr (is_axial_matrix<M>) a.hoop = entry(k);
  return a;
}

}  // namespace softwet
