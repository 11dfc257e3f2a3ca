// Ties between the last two functions of an axis: they take away the stiff modes of open knots.
#pragma once

#include "field/ghosts.hpp"

namespace softwet {

/// At an open end of an axis the last function has a third of the mass of those inside (degree 2), so that the difference
/// of the last two control values c_0, c_1 has the highest frequency of all. A tie adds to the lumped mass of this
/// difference,  D = diag(a) + k d d^T  with  d.c = c_0 - c_1.  Then  W = D^{-1} diag(a)  keeps the mean of the two, weighted
/// with a, and the part 1 / (1 + k / a_0 + k / a_1) of their difference. What is uniform stays so.
/// Where a velocity is held, its neighbours are not tied to it. Where solid and fluid meet, velocities are tied on the side of
/// the solid; where two materials are joined, on the lower side. Ties of several sides follow each other: halves of all but the last set, that one, and the other halves in
/// reverse, which is symmetric in the weights.
/// Smaller parts make steps longer, up to a limit, and cost accuracy where a wall has a contact angle.
inline constexpr double kept_of_scalars = 0.6, kept_of_velocities = 0.4;

/// Takes a part of the difference of two values away: of the one at `first`, and of that `step` further.
struct EndTie {
  int first, step;
  bool whole;  ///< else the half of a tie that comes twice
};

/// Tested: tests/unit/time/test_mass_inverse.cpp
template <int D>
class EndTies {
 public:
  EndTies(const Layout<D>&, const ConstArray& mask);

  // Arrays of the components alone; `weights` is a by control point.
  /// x = W x, and what x loses is added to `gains` unless that is empty.
  void velocities(const Array& x, const ConstArray& weights, const Array& gains = {}) const {
    smooth(velocity_, kept_of_velocities, x, weights, gains);
  }
  void scalars(const Array& x, const ConstArray& weights, const Array& gains = {}) const {
    smooth(scalar_, kept_of_scalars, x, weights, gains);
  }
  /// x = W^{-1} x for scalars.
  void untie_scalars(const Array& x, const ConstArray& weights) const {
    smooth(scalar_, 1 / kept_of_scalars, x, weights, {});
  }

 private:
  /// The ties in their order, in clusters that share no value, each with the ties from its start to that of the next one.
  struct Group {
    Kokkos::View<const EndTie*, Exec> ties;
    Kokkos::View<const int*, Exec> start;
    int nodes = 1;  ///< of a component
  };
  enum class End { low, high, below_wall, below_joint };
  using Set = std::vector<EndTie>;  ///< of pairs that share no value

  Set make_set(const Layout<D>&, const std::vector<double>& mask, int first, int last, int axis,
               const std::vector<End>& ends) const;
  static Group make_group(const std::vector<Set>&, int nodes);
  void smooth(const Group&, double kept, const Array& x, const ConstArray& weights, const Array& gains) const;

  Group velocity_, scalar_;
};

}  // namespace softwet
