// What an explicit time scheme sees of a scene: y' = f(t, y), and a stiff linear part of it.
#pragma once

#include "case/refusal.hpp"
#include "field/vector.hpp"

namespace softwet {

/// An evolution equation in a vector y. `rates` may keep what it has computed, so results of the last call count.
class Evolution {
 public:
  virtual ~Evolution() = default;
  virtual int size() const = 0;

  /// out = f(t, y). @return empty, or why f has no value there
  virtual Refusal rates(double t, const Array& y, const Array& out) = 0;

  /// out = f(t, y) - g(y), g the stiff dissipative part (viscosity).
  virtual Refusal gentle_rates(double t, const Array& y, const Array& out) = 0;

  /// out = g(y), where g takes what it depends on beside its own part of y from the last `hold`, or from the last rates.
  /// @return empty, or why g has no value there
  virtual Refusal stiff_rates(const Array& y, const Array& out) = 0;
  virtual Refusal hold(const Array& y) = 0;

  /// Replaces y by the solution of y - c g(y) = y_given and returns g(y) in `out`, with what is held as in `stiff_rates`.
  virtual Refusal implicit_part(double c, const Array& y, const Array& out) = 0;
};

}  // namespace softwet
