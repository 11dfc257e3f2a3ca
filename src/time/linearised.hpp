// An evolution for small changes about one of its states.
#pragma once

#include "field/vector.hpp"
#include "time/evolution.hpp"

namespace softwet {

/// z' = J z with J z = (f(y + s z) - f(y)) / s, s small. What the stiff part depends on is kept as it was held last.
class Linearised final : public Evolution {
 public:
  /// @param space  of its vectors
  Linearised(Evolution& whole, const VectorSpace& space)
      : whole_(whole), space_(space), probe_("linearised.probe", whole.size()) {}

  /// @param rates  f(t, y), or the gentle rates where `gentle`: then the stiff part is added to them where f is asked for
  void set_base(double t, const Array& y, const Array& rates, bool gentle) {
    t_ = t, y_ = y, rates_ = rates, gentle_ = gentle;
    if (gentle && stiff_.extent(0) == 0) stiff_ = Array("linearised.stiff", size());
  }

  int size() const override { return whole_.size(); }
  Refusal rates(double, const Array& z, const Array& out) override {
    Refusal problem = difference(z, out);
    if (!gentle_ || !problem.empty()) return problem;
    problem = whole_.stiff_rates(z, stiff_);
    add_scaled(out, 0, 1, stiff_);
    return problem;
  }
  /// Those that `set_base` was given, without their stiff part where they were gentle.
  Refusal gentle_rates(double, const Array& z, const Array& out) override { return difference(z, out); }
  Refusal stiff_rates(const Array& z, const Array& out) override { return whole_.stiff_rates(z, out); }
  Refusal hold(const Array&) override { return {}; }
  Refusal implicit_part(double c, const Array& z, const Array& out) override { return whole_.implicit_part(c, z, out); }

 private:
  Refusal difference(const Array& z, const Array& out) {
    Kokkos::deep_copy(Exec(), out, 0.0);
    const double length = norm(space_, z);
    if (!(length > 0)) return {};
    const double step = 1e-7 * (1 + norm(space_, y_)) / length;
    Kokkos::deep_copy(Exec(), probe_, y_);
    add_scaled(probe_, 0, step, z);
    const Refusal problem = gentle_ ? whole_.gentle_rates(t_, probe_, out) : whole_.rates(t_, probe_, out);
    add_scaled(out, 0, -1, rates_);
    combine(out, 1 / step, out, 0);
    return problem;
  }

  Evolution& whole_;
  VectorSpace space_;
  Array probe_, stiff_, y_, rates_;
  double t_ = 0;
  bool gentle_ = false;
};

}  // namespace softwet
