// How a walk over the tree of a dissection is shared among threads.
#pragma once

#include "solver/direct/dissection.hpp"

namespace softwet {

/// Whole subtrees, which threads take one after another, and the nodes above them.
struct WorkSplit {
  std::vector<int> subtrees;          ///< roots, the ones with the most work first
  std::vector<std::vector<int>> top;  ///< by depth, the root of the tree first
};

/// Cuts the tree at the depth where the longest of `threads` equal workers is done first. The work of a node is the
/// number of its factors' entries; the nodes above the cut are walked by one worker.
WorkSplit split_work(const Dissection&, int threads);

}  // namespace softwet
