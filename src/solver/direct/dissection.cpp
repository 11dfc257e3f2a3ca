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
  Builder(const Layout<D>& layout, std::vector<std::vector<int>> unknowns_at, int leaf)
      : layout_(layout), unknowns_at_(std::move(unknowns_at)), leaf_(leaf) {}

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
      own.insert(own.end(), unknowns_at_[index].begin(), unknowns_at_[index].end());
      int d = 0;
      while (d < D && ++p[d] == box[d][1]) {
        p[d] = box[d][0];
        ++d;
      }
      if (d == D) return;
    }
  }

  const Layout<D>& layout_;
  std::vector<std::vector<int>> unknowns_at_;
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

template <int D>
void find_border(Dissection& tree, int index, const std::vector<int>& position, const Stencil<D>& stencil,
                 const UnknownTable<D>& table) {
  DissectionNode& node = tree.nodes[index];
  if (node.own.empty() && node.children.empty()) return;
  int last = -1;
  for (int unknown : node.own) last = std::max(last, position[unknown]);
  for (int child : node.children)
    for (int unknown : tree.nodes[child].own) last = std::max(last, position[unknown]);
  std::vector<int>& border = node.border;
  for (int unknown : node.own)
    for_column_point(stencil, table.point(unknown), [&](int from, std::int64_t) {  // rows and columns alike
      for (int a = 0; a < stencil.components; ++a)
        if (const int row = table.unknown(a, from); row >= 0 && position[row] > last) border.push_back(row);
    });
  for (int child : node.children)
    for (int unknown : tree.nodes[child].border)
      if (position[unknown] > last) border.push_back(unknown);
  std::sort(border.begin(), border.end(), [&](int a, int b) { return position[a] < position[b]; });
  border.erase(std::unique(border.begin(), border.end()), border.end());
}

/// Blocks of the matrix that a node takes. `local` has the local numbers of its unknowns, -1 for others.
template <int D>
void find_pairs(DissectionNode& node, const std::vector<int>& local, const Stencil<D>& stencil,
                const UnknownTable<D>& table) {
  const int own = static_cast<int>(node.own.size());
  /// Local number of the first unknown of a point (-1: none), and its components.
  const auto find = [&](int point, std::uint8_t& fields) {
    int first = -1;
    fields = 0;
    for (int c = stencil.components - 1; c >= 0; --c) {
      const int unknown = table.unknown(c, point);
      if (unknown < 0) continue;
      first = local[unknown];
      fields |= static_cast<std::uint8_t>(1u << c);
    }
    return first;
  };
  int previous = -1;
  for (const std::vector<int>* columns : {&node.own, &node.border})
    for (int unknown : *columns) {
      const int point = table.point(unknown);
      if (point == previous) continue;
      previous = point;
      DissectionNode::PointPair pair;
      pair.column = find(point, pair.column_fields);
      for_column_point(stencil, point, [&](int from, std::int64_t place) {
        pair.place = place;
        pair.row = find(from, pair.row_fields);
        const bool mine = pair.column < own ? pair.row >= 0 : pair.row >= 0 && pair.row < own;
        if (mine) node.pairs.push_back(pair);
      });
    }
  node.pairs.shrink_to_fit();
}

}  // namespace

template <int D>
Dissection dissect(const Layout<D>& layout, const UnknownTable<D>& table, int leaf) {
  const Stencil<D> stencil(layout);
  std::vector<std::vector<int>> unknowns_at(stencil.points);
  for (int i = 0; i < layout.size(); ++i)
    if (table.component(i) >= 0) unknowns_at[table.point(i)].push_back(i);
  Dissection tree = Builder<D>(layout, std::move(unknowns_at), leaf).build();
  const std::vector<int> position = elimination_order(tree, layout.size());
  std::vector<int> local(layout.size(), -1);
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    find_border(tree, static_cast<int>(n), position, stencil, table);
    DissectionNode& node = tree.nodes[n];
    const int own = static_cast<int>(node.own.size());
    for (int i = 0; i < own; ++i) local[node.own[i]] = i;
    for (std::size_t i = 0; i < node.border.size(); ++i) local[node.border[i]] = own + static_cast<int>(i);
    find_pairs(node, local, stencil, table);
    for (int child : node.children)
      for (int unknown : tree.nodes[child].border) tree.nodes[child].border_in_parent.push_back(local[unknown]);
    for (int unknown : node.own) local[unknown] = -1;
    for (int unknown : node.border) local[unknown] = -1;
    if (static_cast<int>(tree.levels.size()) <= node.depth) tree.levels.resize(node.depth + 1);
    tree.levels[node.depth].push_back(static_cast<int>(n));
  }
  return tree;
}

template Dissection dissect<2>(const Layout<2>&, const UnknownTable<2>&, int);
template Dissection dissect<3>(const Layout<3>&, const UnknownTable<3>&, int);

}  // namespace softwet
