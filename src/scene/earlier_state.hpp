// The last state of an earlier run, and its fields on another mesh of the same box (host).
#pragma once

#include <vector>

#include "field/layout.hpp"

namespace softwet {

/// Control values of the whole patch of an earlier run. Ghosts of periodic axes mean nothing.
struct EarlierState {
  std::vector<Axis> axis;
  int solid_elements = 0;
  bool has_fluid = true, has_solid = true;
  std::vector<double> unknown, displacement;
};

/// A component of an earlier run at the ends and in the middle of the elements of one material, first axis fastest, as
/// field files have it; its control values on axes of degree 2, of the rows that live on that material.
/// @param low, high  the elements of the material along the vertical axis
std::vector<double> control_values_of_samples(const std::vector<Axis>&, int low, int high, std::vector<double> samples);

/// Sets velocity, density, potential and displacement from an earlier run, as far as it has the material. In a mesh
/// whose elements divide the elements of the earlier one, with a degree that is not smaller, they are the same
/// functions; in other meshes they are near, and keep their integrals over the undeformed fluid or solid
/// (spline/transfer.hpp). A density stays between the smallest and the largest control value of the earlier one, which
/// cuts overshoots next to an interface that the mesh does not resolve.
template <int D>
void give_earlier(const EarlierState&, const Layout<D>&, std::vector<double>& unknown,
                  std::vector<double>& displacement);

}  // namespace softwet
