// Where each component of the unknown vector lies.
#pragma once

#include <array>
#include <memory>

#include "field/vector_space.hpp"
#include "memory/array.hpp"

namespace softwet {

struct ColumnExchange;

/// The patch: one axis per dimension, rows of control points along the last axis. Velocity lives on all rows, the
/// displacement on the solid's rows, density and chemical potential on the fluid's; they share the wall's row.
/// A component is a dense box [k][j][i], i fastest; a row is everything but the last axis. Where several processes
/// compute a scene, each stores some of its columns, and sizes and offsets count what it stores.
template <int D>
struct Layout {
  std::vector<Axis> axis;                          ///< of the whole patch
  Columns columns;                                 ///< of the first axis that are stored
  std::shared_ptr<const ColumnExchange> exchange;  ///< none where all are
  int solid_elements = 0;                          ///< element rows of the solid; 0: rigid wall
  bool has_fluid = true, has_solid = true;
  int row_size = 0, rows = 0;
  int wall_row = 0;   ///< last row of the solid = first row of the fluid
  int rate_rows = 0;  ///< rows of the density, from the wall on, whose rates are kept behind the rates of the velocity
  int branches = 0;   ///< of a viscoelastic solid
  /// Lines of columns that each branch remembers: lines of a displacement, or of strains at points (PointMemory).
  int branch_lines = 0;
  bool branches_at_points = false;

  /// Whether the axes are r and z.
  bool axisymmetric() const { return axis[0].kind() == AxisKind::radial; }
  /// Length of the shortest element along any axis.
  double shortest() const {
    double least = axis[0].spacing();
    for (const Axis& one : axis) least = std::min(least, one.spacing());
    return least;
  }
  /// Stored control points along an axis; along the last one all of the patch.
  int extent(int d) const { return d == 0 && columns.stored() > 0 ? columns.stored() : axis[d].functions(); }
  /// The axis function that column i of axis d belongs to.
  int function(int i, int d) const { return d == 0 && columns.stored() > 0 ? columns.function[i] : i; }
  /// The places along an axis before its values repeat; 0: never. Where processes share a periodic axis only the first
  /// one has both ends.
  int period(int d) const {
    if (!axis[d].periodic()) return 0;
    if (d > 0 || whole()) return axis[d].owned();
    return columns.rank == 0 ? extent(0) - axis[0].degree() : 0;
  }
  /// Whether column i of axis d is not a copy of one that another process has.
  bool own(int i, int d) const { return d > 0 || columns.stored() == 0 || columns.own(i); }
  /// Whether all columns are stored here, once.
  bool whole() const { return columns.ranks == 1; }
  /// The space of the vectors on these columns: vectors of unknowns, and of any number of rows.
  VectorSpace space() const { return VectorSpace(columns); }
  /// The layout of all columns.
  Layout whole_patch() const {
    Layout all = *this;
    all.columns = {};
    all.exchange = nullptr;
    all.row_size = 1;
    for (int d = 0; d + 1 < D; ++d) all.row_size *= axis[d].functions();
    return all;
  }

  int solid_rows() const { return has_solid ? wall_row + 1 : 0; }
  int fluid_rows() const { return has_fluid ? rows - wall_row : 0; }
  int velocity_size() const { return D * rows * row_size; }
  int scalar_size() const { return fluid_rows() * row_size; }
  /// Size of the rates of the first unknowns: of the velocity, and of the rows of the density that have rates.
  int rate_size() const { return velocity_size() + rate_rows * row_size; }
  int solid_size() const { return D * solid_rows() * row_size; }
  int branch_size() const { return branch_lines * extent(0); }
  int memory_size() const { return branches * branch_size(); }
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
