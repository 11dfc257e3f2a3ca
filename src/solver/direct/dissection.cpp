#include "solver/direct/dissection.hpp"

#include <algorithm>
#include <array>

namespace softwet {

namespace {

template <int D>
using Bounds = std::array<std::array<int, 2>, D>;  ///< [axis][low, high)

/// Builds the tree top down; children are appended before their parent.
template <int D>
class Builder {
 public:
  Builder(const Layout<D>& layout, const UnknownTable<D>& table, int leaf)
      : layout_(layout), table_(table), leaf_(leaf) {}

  Dissection build() {
    Bounds<D> all;
    for (int d = 0; d < D; ++d) all[d] = {0, layout_.axis[d].owned()};
    split(all, 0, 0);
    return std::move(tree_);
  }

 private:
  /// @param uncut  axes 0 .. uncut-1 that are periodic have been cut open already
  int split(const Bounds<D>& box, int uncut, int depth) {
    const int reach = layout_.axis[0].degree();
    std::vector<Bounds<D>> parts;
    Bounds<D> separator = box;
    while (uncut < D && !layout_.axis[uncut].periodic()) ++uncut;
    if (uncut < D) {  // cut the ring open
      separator[uncut][1] = box[uncut][0] + reach;
      parts.push_back(box);
      parts[0][uncut][0] += reach;
      ++uncut;
    } else {
      int longest = 0, points = 1;
      for (int d = 0; d < D; ++d) {
        points *= box[d][1] - box[d][0];
        if (box[d][1] - box[d][0] > box[longest][1] - box[longest][0]) longest = d;
      }
      const int length = box[longest][1] - box[longest][0];
      if (points > leaf_ && length >= 3 * reach) {
        const int cut = box[longest][0] + (length - reach) / 2;
        separator[longest] = {cut, cut + reach};
        parts.assign(2, box);
        parts[0][longest][1] = cut;
        parts[1][longest][0] = cut + reach;
      }
    }
    DissectionNode node;
    node.depth = depth;
    node.first = static_cast<int>(tree_.nodes.size());
    for (const Bounds<D>& part : parts) node.children.push_back(split(part, uncut, depth + 1));
    collect(separator, node.own);
    const int index = static_cast<int>(tree_.nodes.size());
    tree_.nodes.push_back(std::move(node));
    return index;
  }

  void collect(const Bounds<D>& box, std::vector<int>& own) const {
    std::array<int, D> p;
    for (int d = 0; d < D; ++d) {
      p[d] = box[d][0];
      if (box[d][1] <= box[d][0]) return;
    }
    for (;;) {
      int index = 0;
      for (int d = D - 1; d >= 0; --d) index = index * layout_.axis[d].functions() + p[d];
      for (int c = 0; c < layout_.components(); ++c)
        if (const int unknown = table_.unknown(c, index); unknown >= 0) own.push_back(unknown);
      int d = 0;
      while (d < D && ++p[d] == box[d][1]) {
        p[d] = box[d][0];
        ++d;
      }
      if (d == D) return;
    }
  }

  const Layout<D>& layout_;
  const UnknownTable<D>& table_;
  int leaf_;
  Dissection tree_;
};

/// Position of every unknown in the order of elimination.
std::vector<int> elimination_order(const Dissection& tree, int size) {
  std::vector<int> position(size, -1);
  int next = 0;
  for (const DissectionNode& node : tree.nodes)
    for (int unknown : node.own) position[unknown] = next++;
  return position;
}

/// @param seen  by unknown: the last node whose border has it
template <int D>
void find_border(Dissection& tree, int index, const std::vector<int>& position, const Stencil<D>& stencil,
                 const UnknownTable<D>& table, std::vector<int>& seen) {
  DissectionNode& node = tree.nodes[index];
  if (node.own.empty() && node.children.empty()) return;
  int last = -1;
  for (int unknown : node.own) last = std::max(last, position[unknown]);
  for (int child : node.children)
    for (int unknown : tree.nodes[child].own) last = std::max(last, position[unknown]);
  const auto add = [&](int unknown) {
    if (position[unknown] <= last || seen[unknown] == index) return;
    seen[unknown] = index;
    node.border.push_back(unknown);
  };
  int previous = -1;
  for (int unknown : node.own) {
    const int point = table.point(unknown);
    if (point == previous) continue;
    previous = point;
    for_column_point(stencil, point, [&](int from, std::int64_t) {  // rows and columns alike
      for (int a = 0; a < stencil.components; ++a)
        if (const int row = table.unknown(a, from); row >= 0) add(row);
    });
  }
  for (int child : node.children)
    for (int unknown : tree.nodes[child].border) add(unknown);
  std::sort(node.border.begin(), node.border.end(), [&](int a, int b) { return position[a] < position[b]; });
}

}  // namespace

template <int D>
Dissection dissect(const Layout<D>& layout, const UnknownTable<D>& table, int leaf) {
  const Stencil<D> stencil(layout);
  Dissection tree = Builder<D>(layout, table, leaf).build();
  const std::vector<int> position = elimination_order(tree, layout.size());
  std::vector<int> seen(layout.size(), -1), local(layout.size(), -1);
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    find_border(tree, static_cast<int>(n), position, stencil, table, seen);
    const DissectionNode& node = tree.nodes[n];
    node.number_locally(local);
    for (int child : node.children)
      for (int unknown : tree.nodes[child].border) tree.nodes[child].border_in_parent.push_back(local[unknown]);
    if (static_cast<int>(tree.levels.size()) <= node.depth) tree.levels.resize(node.depth + 1);
    tree.levels[node.depth].push_back(static_cast<int>(n));
  }
  return tree;
}

template Dissection dissect<2>(const Layout<2>&, const UnknownTable<2>&, int);
template Dissection dissect<3>(const Layout<3>&, const UnknownTable<3>&, int);

}  // namespace softwet
