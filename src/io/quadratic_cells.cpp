#include "io/quadratic_cells.hpp"

namespace softwet {
namespace {

using Node = std::array<int, 3>;  // place in the 3 x 3 (x 3) lattice of a cell, 0..2 per axis

/// Corners, then mid-edges, then the centre, as vtkBiQuadraticQuad numbers them.
constexpr Node quad_nodes[9] = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 0, 0},
                                {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 1, 0}};

/// Corners, edges of the bottom, of the top, upright edges, faces (-x, +x, -y, +y, -z, +z), centre, as
/// vtkTriQuadraticHexahedron numbers them.
constexpr Node hexahedron_nodes[27] = {
    {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2},  // corners
    {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2}, {1, 2, 2}, {0, 1, 2},  // bottom, top edges
    {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1},                                              // upright edges
    {0, 1, 1}, {2, 1, 1}, {1, 0, 1}, {1, 2, 1}, {1, 1, 0}, {1, 1, 2}, {1, 1, 1}};            // faces, centre

Node cells_per_axis(const TensorGrid& grid) {
  return {grid.cells[0], grid.cells[1], grid.dimension == 3 ? grid.cells[2] : 1};
}

}  // namespace

std::int64_t point_count(const TensorGrid& grid) {
  std::int64_t count = 1;
  for (int axis = 0; axis < grid.dimension; ++axis) {
    const bool doubled = axis == grid.dimension - 1 && grid.rows_below_joint > 0;
    count *= 2 * std::int64_t(grid.cells[axis]) + (doubled ? 2 : 1);
  }
  return count;
}

std::int64_t cell_count(const TensorGrid& grid) {
  std::int64_t count = 1;
  for (int axis = 0; axis < grid.dimension; ++axis) count *= grid.cells[axis];
  return count;
}

std::vector<std::int64_t> cell_nodes(const TensorGrid& grid) {
  const Node cells = cells_per_axis(grid);
  const Node* nodes = grid.dimension == 3 ? hexahedron_nodes : quad_nodes;
  const int nodes_per_cell = grid.dimension == 3 ? 27 : 9;
  const std::int64_t row = 2 * std::int64_t(cells[0]) + 1;
  const std::int64_t plane = row * (2 * std::int64_t(cells[1]) + 1);
  std::vector<std::int64_t> connectivity;
  connectivity.reserve(static_cast<std::size_t>(cell_count(grid) * nodes_per_cell));
  const std::int64_t layer = grid.dimension == 3 ? plane : row;  // of points at one height
  for (int k = 0; k < cells[2]; ++k) {
    for (int j = 0; j < cells[1]; ++j) {
      const int height = grid.dimension == 3 ? k : j;
      const std::int64_t first = grid.rows_below_joint > 0 && height >= grid.rows_below_joint ? layer : 0;
      for (int i = 0; i < cells[0]; ++i) {
        for (int n = 0; n < nodes_per_cell; ++n) {
          const Node& node = nodes[n];
          connectivity.push_back(first + (2 * i + node[0]) + row * (2 * j + node[1]) + plane * (2 * k + node[2]));
        }
      }
    }
  }
  return connectivity;
}

}  // namespace softwet
