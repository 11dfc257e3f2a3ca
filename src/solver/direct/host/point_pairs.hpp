// Which matrix entries each front of a nested dissection takes.
#pragma once

#include "solver/direct/dissection.hpp"

namespace softwet {

/// The block of matrix entries between two control points.
struct PointPair {
  std::int64_t place;                      ///< of the entry (0, 0), see for_column_point
  int row, column;                         ///< local numbers of the points' first unknowns
  std::uint8_t row_fields, column_fields;  ///< bit c: the point has component c as an unknown
};

/// By node: the pairs with a row or a column among its own unknowns, of which none is eliminated before.
template <int D>
std::vector<std::vector<PointPair>> find_point_pairs(const Dissection&, const Layout<D>&, const UnknownTable<D>&);

}  // namespace softwet
