// Preconditioned conjugate gradients for the symmetric positive definite systems of explicit schemes.
#pragma once

#include <cmath>

#include "field/vector.hpp"

namespace softwet {

/// Hestenes and Stiefel 1952. Works on the entries [first, last) of vectors of unknowns; operators get whole vectors
/// whose other entries are zero. Workspace is allocated once.
class ConjugateGradient {
 public:
  ConjugateGradient(const VectorSpace& space, int size)
      : space_(space),
        residual_("cg.residual", size),
        precondition_("cg.precondition", size),
        direction_("cg.direction", size),
        product_("cg.product", size) {}

  /// Improves x until ||b - A x|| <= tolerance ||b||, in at most `limit` iterations. @return the iterations, -1 where
  /// they were not enough or a number is not finite
  template <class Apply, class Precondition>
  int solve(const Apply& apply, const Precondition& precondition, const Array& b, const Array& x, int first, int last,
            double tolerance, int limit) {
    const auto of = [first, last](const Array& a) { return Kokkos::subview(a, Kokkos::make_pair(first, last)); };
    const Array r = of(residual_), z = of(precondition_), p = of(direction_), q = of(product_);
    for (const Array& a : {residual_, precondition_, direction_}) Kokkos::deep_copy(Exec(), a, 0.0);
    const double target = tolerance * norm(space_, of(b));
    apply(x, product_);
    Kokkos::deep_copy(Exec(), r, of(b));
    add_scaled(r, 0, -1, q);
    double before = 0;
    for (int k = 0;; ++k) {
      const double size = norm(space_, r);
      if (size <= target) return k;
      if (k == limit || !std::isfinite(size)) return -1;
      precondition(residual_, precondition_);
      const double now = dot(space_, r, z);
      combine(p, 1, z, k == 0 ? 0 : now / before);
      before = now;
      apply(direction_, product_);
      const double step = now / dot(space_, p, q);
      add_scaled(of(x), 0, step, p);
      add_scaled(r, 0, -step, q);
    }
  }

 private:
  VectorSpace space_;
  Array residual_, precondition_, direction_, product_;
};

}  // namespace softwet
