#include "solver/direct/host/point_pairs.hpp"

namespace softwet {

namespace {

/// By control point: its first unknown (-1: none), and bit c where it has component c as an unknown.
struct Points {
  std::vector<int> first;
  std::vector<std::uint8_t> fields;

  template <int D>
  Points(const Stencil<D>& stencil, const UnknownTable<D>& table)
      : first(stencil.points, -1), fields(stencil.points, 0) {
    for (int c = stencil.components - 1; c >= 0; --c)
      for (int p = 0; p < stencil.points; ++p) {
        const int unknown = table.unknown(c, p);
        if (unknown < 0) continue;
        first[p] = unknown;
        fields[p] |= static_cast<std::uint8_t>(1u << c);
      }
  }
};

/// @param node_of, local  by unknown: the last node that had it, and its number there
template <int D>
std::vector<PointPair> pairs_of(const DissectionNode& node, int index, const std::vector<int>& node_of,
                                const std::vector<int>& local, const Points& points, const Stencil<D>& stencil,
                                const UnknownTable<D>& table) {
  const int own = static_cast<int>(node.own.size());
  std::vector<PointPair> pairs;
  int previous = -1;
  for (const std::vector<int>* columns : {&node.own, &node.border})
    for (int unknown : *columns) {
      const int point = table.point(unknown), column = local[points.first[point]];
      if (point == previous) continue;
      previous = point;
      for_column_point(stencil, point, [&](int from, std::int64_t place) {
        const int first = points.first[from];
        if (first < 0 || node_of[first] != index || (column >= own && local[first] >= own)) return;
        pairs.push_back({place, local[first], column, points.fields[from], points.fields[point]});
      });
    }
  pairs.shrink_to_fit();
  return pairs;
}

}  // namespace

template <int D>
std::vector<std::vector<PointPair>> find_point_pairs(const Dissection& tree, const Layout<D>& layout,
                                                     const UnknownTable<D>& table) {
  const Stencil<D> stencil(layout);
  const Points points(stencil, table);
  std::vector<int> node_of(layout.size(), -1), local(layout.size(), -1);
  std::vector<std::vector<PointPair>> pairs;
  for (const DissectionNode& node : tree.nodes) {
    const int index = static_cast<int>(pairs.size());
    for (const std::vector<int>* unknowns : {&node.own, &node.border})
      for (int unknown : *unknowns) node_of[unknown] = index;
    node.number_locally(local);
    pairs.push_back(pairs_of(node, index, node_of, local, points, stencil, table));
  }
  return pairs;
}

template std::vector<std::vector<PointPair>> find_point_pairs<2>(const Dissection&, const Layout<2>&,
                                                                 const UnknownTable<2>&);
template std::vector<std::vector<PointPair>> find_point_pairs<3>(const Dissection&, const Layout<3>&,
                                                                 const UnknownTable<3>&);

}  // namespace softwet
