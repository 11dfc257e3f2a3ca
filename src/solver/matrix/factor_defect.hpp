// How much of a matrix its factors have lost.
#pragma once

#include <cmath>
#include <cstdint>

#include "solver/preconditioner.hpp"

namespace softwet {

/// || b - A M^-1 b || / || b || in rows of size one, for the factors M of a matrix A and a random vector b, the same
/// one each time. Memory is allocated once.
template <int D>
class FactorDefect {
 public:
  explicit FactorDefect(const ConstArray& mask)
      : random_(to_host(mask)),
        right_("defect.right", random_.size()),
        solution_("defect.solution", random_.size()),
        product_("defect.product", random_.size()),
        right_host_(Kokkos::create_mirror_view(right_)),
        product_host_(Kokkos::create_mirror_view(product_)) {
    std::uint32_t state = 1;
    for (double& x : random_) {
      state = state * 1664525u + 1013904223u;  // Numerical Recipes, ranqd1
      x *= state / 2147483648.0 - 1;
    }
  }

  /// @param row  factors that bring each row of the matrix to the size one
  double measure(StencilSolver<D>& factors, const StencilMatrix<D>& matrix, const std::vector<float>& row) {
    for (std::size_t i = 0; i < random_.size(); ++i) right_host_(i) = random_[i] / row[i];
    Kokkos::deep_copy(right_, right_host_);
    factors.apply(right_, solution_);
    matrix.multiply(solution_, product_);
    Kokkos::deep_copy(product_host_, product_);
    double wrong = 0, all = 0;
    for (std::size_t i = 0; i < random_.size(); ++i) {
      if (random_[i] == 0) continue;  // prescribed
      wrong += std::pow(product_host_(i) * row[i] - random_[i], 2);
      all += random_[i] * random_[i];
    }
    return all > 0 ? std::sqrt(wrong / all) : 0;
  }

 private:
  std::vector<double> random_;
  Array right_, solution_, product_;
  Array::host_mirror_type right_host_, product_host_;
};

}  // namespace softwet
