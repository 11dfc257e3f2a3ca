// Which points of a tensor grid make up each quadratic VTK cell, in the node order of VTK.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "io/field_file.hpp"

namespace softwet {

constexpr std::uint8_t vtk_biquadratic_quad = 28;
constexpr std::uint8_t vtk_triquadratic_hexahedron = 29;

/// Number of points of the grid: product over the axes of 2 cells + 1, with a joint one more along the last axis.
std::int64_t point_count(const TensorGrid& grid);

/// Number of cells of the grid.
std::int64_t cell_count(const TensorGrid& grid);

/// Nodes of the cells, cells x fastest. @return shape (cells, 9 or 27), point numbers of the grid
std::vector<std::int64_t> cell_nodes(const TensorGrid& grid);

}  // namespace softwet
