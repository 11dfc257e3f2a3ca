#include "solver/direct/host/work_split.hpp"

#include <algorithm>
#include <limits>

namespace softwet {

WorkSplit split_work(const Dissection& tree, int threads) {
  std::vector<double> of_node, of_subtree;
  for (const DissectionNode& node : tree.nodes) {
    const double own = node.own.size(), border = node.border.size();
    of_node.push_back(own * (own + 2 * border));
    double sum = of_node.back();
    for (int child : node.children) sum += of_subtree[child];
    of_subtree.push_back(sum);
  }
  WorkSplit best;
  double least = std::numeric_limits<double>::max(), above = 0;
  std::vector<std::vector<int>> top;
  std::vector<int> leaves;  // above the cut; they are subtrees too
  for (const std::vector<int>& level : tree.levels) {
    std::vector<int> roots = level;
    roots.insert(roots.end(), leaves.begin(), leaves.end());
    std::stable_sort(roots.begin(), roots.end(), [&](int a, int b) { return of_subtree[a] > of_subtree[b]; });
    std::vector<double> load(threads, 0.0);
    for (int root : roots) *std::min_element(load.begin(), load.end()) += of_subtree[root];
    const double time = above + *std::max_element(load.begin(), load.end());
    if (time < least) {
      least = time;
      best = {roots, top};
    }
    top.emplace_back();
    for (int n : level) {
      if (tree.nodes[n].children.empty()) {
        leaves.push_back(n);
      } else {
        top.back().push_back(n);
        above += of_node[n];
      }
    }
  }
  return best;
}

}  // namespace softwet
