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
  /// @param numbers  where kernels read what `find` has found for the time; null: they have it as arguments
  template <class Real>
  void add_to_residual(double time, const ArrayOf<Real>& displacement, const Array& out,
                       const double* numbers = nullptr) const {
    add_loads(time, out, numbers);
    needles_.add_to_residual(layout_, time, displacement, out, numbers ? numbers + D * loads_.size() : nullptr);
  }

  // For steps that are recorded: how many numbers kernels read, and these at a time. Then loads that move are where
  // they are then.
  int numbers() const { return D * static_cast<int>(loads_.size()) + needles_.numbers(); }
  void find(double time, double* numbers) const;
  /// Whether a load acts at a time; one that does not starts no kernel.
  std::vector<bool> acting(double time) const;

  /// Starts the power of the loads on a velocity field at a time, in the coordinates (r, z) for each radian. It is
  /// there when `pending` is finished.
  void start_load_power(double time, const ConstArray& unknown, PendingIntegrals& pending, double& power) const;

 private:
  void add_loads(double time, const Array& out, const double* numbers) const;

  const Layout<D>& layout_;
  std::vector<LoadVector<D>> loads_;
  Needles<D> needles_;
  SolidGravity gravity_;
};

}  // namespace softwet
