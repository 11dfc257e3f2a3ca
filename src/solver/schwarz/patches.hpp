// Overlapping boxes of control points that cover the patch, with all fields of a control point together.
#pragma once

#include <vector>

#include "solver/matrix/stencil_matrix.hpp"

namespace softwet {

/// Index tables of the boxes.
struct PatchTables {
  int count = 0;             ///< number of boxes
  int row = 0;               ///< boxes that follow each other along the first axis
  int rows = 0;              ///< rows of boxes that follow each other along the second axis
  int unknowns = 0;          ///< largest number of unknowns of a box
  int sites = 0;             ///< control points times components of a box
  std::vector<int> size;     ///< [count] unknowns of each box
  std::vector<int> dof;      ///< [count][unknowns] index into the vector of unknowns, -1 beyond size
  std::vector<int> local;    ///< [count][control point in the box][component] number of the unknown in the box, or -1
  std::vector<int> start;    ///< [count][D] first control point of each box; along the first axis its function
  std::vector<int> column;   ///< stored column of each function of the first axis, repeated behind a period; -1: none
  std::vector<int> place;    ///< where each unknown is found: box unknowns + number in the box, grouped by unknown
  std::vector<int> grouped;  ///< [unknowns of the layout + 1] the group of each unknown in `place`
  std::vector<int> holders;  ///< [unknowns of the layout] how many boxes of the whole patch hold it
};

/// Boxes `width` >= 3 control points wide, at most `stride` apart (evenly spread) along every axis. A box that has the
/// row shared by solid and fluid as its first or last one leaves it out: fluid on the wall without the fluid above it
/// makes a matrix close to singular. The tables have the boxes that touch a process's own columns; it stores all
/// columns of these.
template <int D>
PatchTables make_patches(const Layout<D>&, const UnknownTable<D>&, int width, int stride);

}  // namespace softwet
