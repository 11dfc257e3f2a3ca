// What a Runge-Kutta scheme sees of a scene: y' = f(t, y).
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
};

}  // namespace softwet
