#include "solver/direct/device/level_tree.hpp"

#include <algorithm>

namespace softwet {

namespace {

/// Goes from the root to the leaves. A front's children get their numbers with the next level.
class LevelTreeBuilder {
 public:
  explicit LevelTreeBuilder(const Dissection& dissection) : nodes_(dissection.nodes), front_of_(nodes_.size(), -1) {
    for (const std::vector<int>& level : dissection.levels) add_level(level);
    tree_.inherited.assign(2 * tree_.unknown.size(), -1);
    for (std::size_t n = 0; n < nodes_.size(); ++n)
      if (front_of_[n] >= 0) link(nodes_[n], tree_.fronts[front_of_[n]]);
  }
  LevelTree take() { return std::move(tree_); }

 private:
  void add_level(const std::vector<int>& nodes) {
    TreeLevel level;
    level.first = static_cast<int>(tree_.fronts.size());
    level.first_forward = static_cast<int>(tree_.forward.size());
    level.first_backward = static_cast<int>(tree_.backward.size());
    for (int n : nodes) add_front(n, level);
    level.last = static_cast<int>(tree_.fronts.size());
    level.last_forward = static_cast<int>(tree_.forward.size());
    level.last_backward = static_cast<int>(tree_.backward.size());
    if (level.last > level.first) tree_.levels.push_back(level);
  }

  void add_front(int n, TreeLevel& level) {
    const DissectionNode& node = nodes_[n];
    LevelFront f{};
    f.own = static_cast<int>(node.own.size());
    f.size = f.own + static_cast<int>(node.border.size());
    if (f.size == 0) return;
    f.first = static_cast<int>(tree_.unknown.size());
    f.matrix = level.entries;
    f.lower = tree_.factor_entries;
    f.upper = f.lower + std::int64_t(f.own) * f.stride();
    tree_.factor_entries = f.upper + std::int64_t(f.border()) * f.upper_stride();
    level.entries += std::int64_t(f.size) * f.stride();
    level.rows = std::max(level.rows, f.size);
    level.pivots = std::max(level.pivots, f.own);
    level.border = std::max(level.border, f.border());
    front_of_[n] = static_cast<int>(tree_.fronts.size());
    tree_.unknown.insert(tree_.unknown.end(), node.own.begin(), node.own.end());
    tree_.unknown.insert(tree_.unknown.end(), node.border.begin(), node.border.end());
    for (int row = 0; row < f.size; row += LevelStrip::rows) tree_.forward.push_back({front_of_[n], row});
    for (int row = 0; row < f.own && f.border() > 0; row += LevelStrip::rows)
      tree_.backward.push_back({front_of_[n], row});
    tree_.fronts.push_back(f);
  }

  void link(const DissectionNode& node, LevelFront& f) {
    f.child[0] = f.child[1] = -1;
    for (std::size_t c = 0; c < node.children.size(); ++c) {  // a dissection cuts a box into two parts at most
      f.child[c] = front_of_[node.children[c]];
      if (f.child[c] < 0) continue;
      const LevelFront& child = tree_.fronts[f.child[c]];
      const std::vector<int>& to = nodes_[node.children[c]].border_in_parent;
      for (std::size_t i = 0; i < to.size(); ++i)
        tree_.inherited[2 * std::size_t(f.first) + c * f.size + to[i]] = child.first + child.own + static_cast<int>(i);
    }
  }

  const std::vector<DissectionNode>& nodes_;
  std::vector<int> front_of_;  ///< [node] -1: it has no unknowns
  LevelTree tree_;
};

}  // namespace

LevelTree make_level_tree(const Dissection& dissection) { return LevelTreeBuilder(dissection).take(); }

}  // namespace softwet
