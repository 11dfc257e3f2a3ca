// Where each component of the unknown vector lies.
#pragma once

#include <array>

#include "field/array.hpp"
#include "spline/axis.hpp"

namespace softwet {

/// The patch: one axis per dimension, rows of control points along the last axis. Velocity lives on all rows, the
/// displacement on the solid's rows, density and chemical potential on the fluid's; they share the wall's row.
/// A component is a dense box [k][j][i], i fastest; a row is everything but the last axis.
template <int D>
struct Layout {
  std::vector<Axis> axis;
  int solid_elements = 0;  ///< element rows of the solid; 0: rigid wall
  bool has_fluid = true, has_solid = true;
  int row_size = 0, rows = 0;
  int wall_row = 0;  ///< last row of the solid = first row of the fluid

  int solid_rows() const { return has_solid ? wall_row + 1 : 0; }
  int fluid_rows() const { return has_fluid ? rows - wall_row : 0; }
  int velocity_size() const { return D * rows * row_size; }
  int scalar_size() const { return fluid_rows() * row_size; }
  int solid_size() const { return D * solid_rows() * row_size; }
  int size() const { return velocity_size() + 2 * scalar_size(); }

  int velocity_offset(int d) const { return d * rows * row_size; }
  int density_offset() const { return velocity_size(); }
  int potential_offset() const { return velocity_size() + scalar_size(); }
  int displacement_offset(int d) const { return d * solid_rows() * row_size; }

  /// Distance from control value (0, ..) of a fluid component to where row 0 of the patch would be.
  int fluid_shift() const { return wall_row * row_size; }
  int wall_shift() const { return wall_row * row_size; }

  /// Components: velocity 0 .. D - 1, density D, potential D + 1. The values of one lie in a vector of unknowns at
  /// component_shift + control point of the patch, from the control point component_first on.
  int components() const { return has_fluid ? D + 2 : D; }
  int component_first(int c) const { return c < D ? 0 : fluid_shift(); }
  int component_shift(int c) const {
    if (c < D) return velocity_offset(c);
    return (c == D ? density_offset() : potential_offset()) - fluid_shift();
  }
};

}  // namespace softwet
