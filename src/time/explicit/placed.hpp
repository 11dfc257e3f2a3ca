// The parts that the stage of an explicit step holds, as a type: a call that needs a missing part does not compile.
#pragma once

#include "case/refusal.hpp"

namespace softwet {

/// Parts of a stage that fit together: `velocity` at any time, the others as follows from the mesh and from each other.
/// `flux` and `rates` are what terms have left in the vector of forces: it has to be taken before others are evaluated.
namespace placed {
inline constexpr unsigned mesh = 1, velocity = 2, density = 4, potential = 8, weights = 16, flux = 32, rates = 64;
inline constexpr unsigned fields = mesh | velocity | density, all = fields | potential | weights;
/// What follows from a density.
inline constexpr unsigned of_density = potential | weights;

constexpr bool include(unsigned parts, unsigned wanted) { return (parts & wanted) == wanted; }
}  // namespace placed

template <unsigned parts, unsigned wanted>
concept Holding = placed::include(parts, wanted);
/// The stage has the parts, and no force is left to take.
template <unsigned parts, unsigned wanted>
concept Ready = Holding<parts, wanted> &&(parts&(placed::flux | placed::rates)) == 0;

/// The stage of a SemiDiscrete with some of its parts in place. A call takes one and gives the next one. Where it is
/// refused, what follows does nothing, and the last one has the refusal.
/// Tested: tests/unit/time/explicit/test_placed.cpp
template <unsigned parts>
class [[nodiscard]] Placed {
 public:
  Placed(Placed&&) = default;
  Placed& operator=(Placed&&) = default;

  const Refusal& refusal() const { return refusal_; }

 private:
  template <int D, int P>
  friend class SemiDiscrete;
  template <unsigned others>
  friend class Placed;

  explicit Placed(const Refusal& refusal = {}) : refusal_(refusal) {}
  /// The stage after work() -> Refusal.
  template <unsigned next, class Work>
  Placed<next> after(const Work& work) && {
    return Placed<next>(refusal_.empty() ? work() : refusal_);
  }

  Refusal refusal_;
};

}  // namespace softwet
