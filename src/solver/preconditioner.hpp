// Rough inverses of the Jacobian, behind one interface.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "field/layout.hpp"

namespace softwet {

/// Jacobian-vector product with frozen geometry at the current point: what a preconditioner is built from.
using Product = std::function<void(const Array& direction, const Array& out)>;

class Preconditioner {
 public:
  virtual ~Preconditioner() = default;
  /// Rebuilds from the Jacobian at the current point.
  virtual void build(const Product& product) = 0;
  /// z = approximately J^-1 r.
  virtual void apply(const ConstArray& r, const Array& z) = 0;
  virtual std::string name() const = 0;
  virtual double bytes() const = 0;
};

/// z = r. Only for tests and comparisons.
class NoPreconditioner final : public Preconditioner {
 public:
  void build(const Product&) override {}
  void apply(const ConstArray& r, const Array& z) override { Kokkos::deep_copy(Exec(), z, r); }
  std::string name() const override { return "none"; }
  double bytes() const override { return 0; }
};

}  // namespace softwet
