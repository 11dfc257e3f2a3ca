// A growing list of vectors with what Krylov methods need of it: each as one kernel for all vectors at once.
#pragma once

#include <algorithm>
#include <vector>

#include "field/vector.hpp"

namespace softwet {

/// out = b out + sum_j a_j v_j for some entries. With b = 0 the old values are not read.
template <class Real>
struct BasisSum {
  static constexpr int most = 32;                             ///< vectors at once
  static constexpr int entries = host_algorithms ? 1024 : 1;  ///< of one item: they stay in the nearest cache

  ConstArrayOf<Real> all;
  ArrayOf<Real> out;
  Real b;
  int size, stride, first, count;
  Real a[most];

  KOKKOS_FUNCTION void operator()(int item) const {
    const int begin = item * entries, end = begin + entries < size ? begin + entries : size;
    for (int i = begin; i < end; ++i) out(i) = b == 0 ? Real(0) : b * out(i);
    for (int j = 0; j < count; ++j) {
      const Real* v = all.data() + std::int64_t(first + j) * stride;
      for (int i = begin; i < end; ++i) out(i) += a[j] * v[i];
    }
  }
};

/// Vectors of one size behind each other in memory. Sums are of double precision and have one fixed order, whatever the
/// vectors are and however many threads there are.   Tested: tests/unit/solver/test_krylov_basis.cpp
template <class Real>
class KrylovBasis {
 public:
  using Vector = ArrayOf<Real>;

  KrylovBasis(const char* name, int size, int count)
      : size_(size), stride_((size + 15) / 16 * 16), all_(name, std::size_t(stride_) * count) {
    for (int j = 0; j < count; ++j) {
      const std::size_t first = std::size_t(j) * stride_;
      vector_.push_back(Kokkos::subview(all_, Kokkos::make_pair(first, first + size)));
    }
  }

  const Vector& operator[](int j) const { return vector_[j]; }

  /// (v_j, w) for j < count, and (w, w) behind them.
  std::vector<double> dots(int count, const ConstArrayOf<Real>& w) const {
    return strip_sums<Real>(all_.data(), stride_, count, w.data(), true, size_);
  }

  /// out = b out + sum_j a_j v_j
  void sum(const Vector& out, double b, const std::vector<double>& a) const {
    constexpr int most = BasisSum<Real>::most, entries = BasisSum<Real>::entries;
    const int count = static_cast<int>(a.size());
    for (int first = 0; first < count; first += most) {
      BasisSum<Real> part{all_, out, static_cast<Real>(first == 0 ? b : 1), size_, stride_, first, 0, {}};
      part.count = std::min(most, count - first);
      for (int j = 0; j < part.count; ++j) part.a[j] = static_cast<Real>(a[first + j]);
      Kokkos::parallel_for("softwet::basis_sum", Kokkos::RangePolicy<Exec>(0, (size_ + entries - 1) / entries), part);
    }
  }

 private:
  int size_, stride_;
  Vector all_;
  std::vector<Vector> vector_;
};

}  // namespace softwet
