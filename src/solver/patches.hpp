// Overlapping boxes of control points that cover the patch, with all fields of a control point together.
#pragma once

#include <vector>

#include "field/ghosts.hpp"

namespace softwet {

/// Index tables of the boxes. Every unknown is in the core of exactly one box.
struct PatchTables {
  int count = 0;          ///< number of boxes
  int unknowns = 0;       ///< largest number of unknowns of a box
  int cores = 0;          ///< largest number of core unknowns of a box
  std::vector<int> size;  ///< [count] unknowns of each box; its core unknowns come first
  std::vector<int> core;  ///< [count] core unknowns of each box
  std::vector<int> dof;   ///< [count][unknowns] index into the vector of unknowns, -1 beyond size
};

template <int D>
PatchTables make_patches(const Layout<D>&, const std::vector<double>& mask, int core, int overlap);

}  // namespace softwet
