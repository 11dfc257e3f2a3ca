// A growing list of vectors with what Krylov methods need of it: each as one kernel for all vectors at once.
#pragma once

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "field/vector.hpp"

namespace softwet {

/// For some entries of one result, or of two: out_m = b_m out_m + sum_j a_mj v_j, and then out_1 += link out_0. With
/// b_m = 0 the old values are not read.
template <class Real>
struct BasisSum {
  static constexpr int most = 32;              ///< vectors at once
  static constexpr int entries = chunk(1024);  ///< of one item: they stay in the nearest cache

  ConstArrayOf<Real> all;
  int size, stride, first, count;
  int results;
  ArrayOf<Real> out[2];
  Real b[2], a[2][most], link;

  KOKKOS_FUNCTION void operator()(int item) const {
    const int begin = item * entries, end = begin + entries < size ? begin + entries : size;
    for (int m = 0; m < results; ++m)
      for (int i = begin; i < end; ++i) out[m](i) = b[m] == 0 ? Real(0) : b[m] * out[m](i);
    for (int j = 0; j < count; ++j) {
      const Real* v = all.data() + std::int64_t(first + j) * stride;
      for (int m = 0; m < results; ++m)
        for (int i = begin; i < end; ++i) out[m](i) += a[m][j] * v[i];
    }
    if (link != 0)
      for (int i = begin; i < end; ++i) out[1](i) += link * out[0](i);
  }
};

/// b x + sum_j a_j v_j, where x is what the result was.
struct Combination {
  double b;
  std::vector<double> a;
};

/// Vectors of one size behind each other in memory. Sums are of double precision and have one fixed order, whatever the
/// vectors are and however many threads there are.   Tested: tests/unit/solver/krylov/test_krylov_basis.cpp
template <class Real>
class KrylovBasis {
 public:
  using Vector = ArrayOf<Real>;

  KrylovBasis(const char* name, const VectorSpace& space, int size, int count)
      : space_(space), size_(size), stride_((size + 15) / 16 * 16), all_(name, std::size_t(stride_) * count) {
    for (int j = 0; j < count; ++j) {
      const std::size_t first = std::size_t(j) * stride_;
      vector_.push_back(Kokkos::subview(all_, Kokkos::make_pair(first, first + size)));
    }
  }

  const Vector& operator[](int j) const { return vector_[j]; }

  /// Products of a vector w in a weighted inner product (x, y) = sum_i weight_i x_i y_i.
  struct Dots {
    std::vector<double> along;  ///< (v_j, w)
    double square = 0;          ///< (w, w)
  };
  /// With v_0 .. v_{count - 1}.
  Dots dots(int count, const ConstArrayOf<Real>& w, const RangeFactors& weights = {}) const {
    std::vector<double> sums =
        strip_sums<Real>({{space_, all_.data(), stride_, count, {w.data()}, SquareOfFirst::added, size_, weights}});
    const double square = sums.back();
    sums.pop_back();
    return {std::move(sums), square};
  }
  /// Products of w, and products of v_{count - 1}, with the vectors before it, in one pass over the vectors.
  std::pair<Dots, Dots> dots_with_last(int count, const ConstArrayOf<Real>& w, const RangeFactors& weights = {}) const {
    const std::vector<double> sums = strip_sums<Real>({{space_,
                                                        all_.data(),
                                                        stride_,
                                                        count,
                                                        {w.data(), vector_[count - 1].data()},
                                                        SquareOfFirst::added,
                                                        size_,
                                                        weights}});
    Dots of_w, of_last;
    for (int j = 0; j < count; ++j) {
      of_w.along.push_back(sums[2 * j]);
      of_last.along.push_back(sums[2 * j + 1]);
    }
    of_w.square = sums.back();
    of_last.square = of_last.along.back();
    of_last.along.pop_back();
    return {std::move(of_w), std::move(of_last)};
  }

  /// out becomes a combination.
  void sum(const Vector& out, const Combination& c) const { run({out, {}}, {&c, &c}, 1, 0); }
  /// u becomes a combination, and then w one of as many vectors, plus link u.
  void sum_two(const Vector& u, const Combination& of_u, const Vector& w, const Combination& of_w, double link) const {
    run({u, w}, {&of_u, &of_w}, 2, link);
  }

 private:
  void run(const std::array<Vector, 2>& out, const std::array<const Combination*, 2>& c, int results,
           double link) const {
    constexpr int most = BasisSum<Real>::most, entries = BasisSum<Real>::entries;
    const int count = static_cast<int>(c[0]->a.size());
    for (int first = 0; first < count || first == 0; first += most) {
      const int some = std::min(most, count - first);
      BasisSum<Real> part{all_, size_, stride_, first, some, results, {out[0], out[1]}, {}, {}, 0};
      for (int m = 0; m < results; ++m) {
        part.b[m] = static_cast<Real>(first == 0 ? c[m]->b : 1);
        for (int j = 0; j < some; ++j) part.a[m][j] = static_cast<Real>(c[m]->a[first + j]);
      }
      if (first + some == count) part.link = static_cast<Real>(link);
      Kokkos::parallel_for("softwet::basis_sum", Items(0, chunks_in(size_, entries)), part);
    }
  }

  VectorSpace space_;
  int size_, stride_;
  Vector all_;
  std::vector<Vector> vector_;
};

}  // namespace softwet
