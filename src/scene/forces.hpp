// Forces on the solid that are not terms: loads on boxes, gravity and needles.
#pragma once

#include <vector>

#include "scene/loads.hpp"
#include "scene/needles.hpp"

namespace softwet {

/// The layout has to outlive it.
template <int D>
class Forces {
 public:
  Forces(const Layout<D>&, const Case&);

  const std::vector<LoadVector<D>>& loads() const { return loads_; }
  const Needles<D>& needles() const { return needles_; }
  const SolidGravity& gravity() const { return gravity_; }

  /// Subtracts them from a residual, without ghosts. @param displacement  of the solid, at that time
  template <class Real>
  void add_to_residual(double time, const ArrayOf<Real>& displacement, const Array& out) const {
    add_loads(time, out);
    needles_.add_to_residual(layout_, time, displacement, out);
  }
  /// Power of the loads on a velocity field at a time; in the coordinates (r, z) for each radian.
  double load_power(double time, const ConstArray& unknown) const;

 private:
  void add_loads(double time, const Array& out) const;

  const Layout<D>& layout_;
  std::vector<LoadVector<D>> loads_;
  Needles<D> needles_;
  SolidGravity gravity_;
};

}  // namespace softwet
