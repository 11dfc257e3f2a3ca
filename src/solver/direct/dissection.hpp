// Nested dissection of the box of control points: which unknowns are eliminated together, and in which order.
#pragma once

#include <vector>

#include "field/layout.hpp"
#include "solver/matrix/stencil_matrix.hpp"

namespace softwet {

/// A separator (or a leaf box): its own unknowns are eliminated after the unknowns of its children; `border` are
/// unknowns of ancestors that the elimination touches. Local numbering: own first, then border.
struct DissectionNode {
  int depth = 0;
  int first = 0;                 ///< nodes first .. this one are its subtree
  std::vector<int> own, border;  ///< indices into the vector of unknowns
  std::vector<int> children;
  std::vector<int> border_in_parent;  ///< local number of each border unknown in the parent

  /// number[unknown] is its local number, for the unknowns of the node.
  void number_locally(std::vector<int>& number) const {
    int next = 0;
    for (int unknown : own) number[unknown] = next++;
    for (int unknown : border) number[unknown] = next++;
  }
};

/// The tree. Nodes of one depth are independent of each other: levels[d] lists them.
struct Dissection {
  std::vector<DissectionNode> nodes;     ///< children before parents
  std::vector<std::vector<int>> levels;  ///< by depth, root first
};

/// Cuts the box of control points recursively by slabs of `degree` points, which no matrix entry crosses, until boxes
/// hold at most `leaf` control points. The unknowns of a control point follow each other. George 1973.
template <int D>
Dissection dissect(const Layout<D>&, const UnknownTable<D>&, int leaf);

}  // namespace softwet
