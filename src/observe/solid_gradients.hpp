// Gradients of the fields of a solid at the points of a grid.
#pragma once

#include <vector>

#include "kernels/algebra/tensor.hpp"
#include "observe/snapshot.hpp"

namespace softwet {

/// Points of one part of the solid, at which what jumps at the ends of the part is read from inside of it.
template <int D>
struct SolidPoints {
  const Snapshot<D>& snapshot;
  const typename Snapshot<D>::Grid& grid;
  ElementRows rows;

  std::size_t size() const {
    std::size_t n = 1;
    for (const auto& points : grid) n *= points.size();
    return n;
  }
  /// The place of a point; at a joint moved by a hair into the part.
  std::array<double, 3> place(std::size_t point) const;
};

/// Grad u
template <int D>
std::vector<Matrix<double, 3>> displacement_gradients(const SolidPoints<D>&);
/// Grad v
template <int D>
std::vector<Matrix<double, 3>> velocity_gradients(const SolidPoints<D>&);
/// Grad a of the displacement that a branch remembers under small strains.
template <int D>
std::vector<Matrix<double, 3>> branch_gradients(const SolidPoints<D>&, int branch);

/// Means of Grad u over the elements of some columns and rows along each axis, which take the place of the points of a
/// grid. In (r, z), the hoop entry is the mean of u_r over the radius of the middle.
template <int D>
std::vector<Matrix<double, 3>> mean_gradients(const Snapshot<D>&, const std::array<std::vector<int>, D>& elements);

}  // namespace softwet
