#include "solver/direct/host/dense_product.hpp"

#include <algorithm>
#include <cmath>

#include "solver/direct/host/host_pack.hpp"

namespace softwet {

namespace {

/// The innermost loop computes a tile of c, which stays in registers: two packs high, and as wide as there are registers.
constexpr int tile_rows = 2 * host_lanes, tile_columns = host_lanes >= 16 ? 12 : 6;
/// Parts that stay in the caches: a part of a in the second one, a tile's part of b in the first one.
constexpr int depth = 256, part_rows = 192 / tile_rows * tile_rows, part_columns = 85 * 12;
static_assert(part_columns % tile_columns == 0);

/// Columns of a panel of the elimination.
constexpr int panel = 16;

/// Tiles of rows, each with its columns one after another; rows that do not exist are zero.
void copy_a(float sign, const ConstFloatMatrix& a, float* to) {
  for (int i = 0; i < a.rows; i += tile_rows) {
    const int rows = std::min(tile_rows, a.rows - i);
    for (int k = 0; k < a.columns; ++k, to += tile_rows) {
      const float* from = a.column(k) + i;
      if (rows == tile_rows) {
        for (int r = 0; r < tile_rows; ++r) to[r] = sign * from[r];
      } else {
        for (int r = 0; r < tile_rows; ++r) to[r] = r < rows ? sign * from[r] : 0.0f;
      }
    }
  }
}

/// Tiles of columns, each with its rows one after another; columns that do not exist are zero.
void copy_b(const ConstFloatMatrix& b, float* to) {
  for (int j = 0; j < b.columns; j += tile_columns) {
    const int columns = std::min(tile_columns, b.columns - j);
    const float* from[tile_columns];
    for (int c = 0; c < tile_columns; ++c) from[c] = b.column(j + std::min(c, columns - 1));
    for (int k = 0; k < b.rows; ++k, to += tile_columns)
      for (int c = 0; c < tile_columns; ++c) to[c] = c < columns ? from[c][k] : 0.0f;
  }
}

/// c += a b on one tile; c is whole.
void add_tile(int n, const float* a, const float* b, float* c, int stride) {
  HostPack sum[tile_columns][2];
  for (int j = 0; j < tile_columns; ++j) sum[j][0] = sum[j][1] = HostPack(0.0f);
  for (int k = 0; k < n; ++k, a += tile_rows, b += tile_columns) {
    const HostPack low = load(a), high = load(a + host_lanes);
    for (int j = 0; j < tile_columns; ++j) {
      const HostPack factor(b[j]);
      sum[j][0] = sum[j][0] + low * factor;
      sum[j][1] = sum[j][1] + high * factor;
    }
  }
  for (int j = 0; j < tile_columns; ++j, c += stride) {
    store(load(c) + sum[j][0], c);
    store(load(c + host_lanes) + sum[j][1], c + host_lanes);
  }
}

/// The same where c ends inside the tile.
void add_tile_at_border(int n, const float* a, const float* b, const FloatMatrix& c) {
  float tile[tile_columns * tile_rows] = {};
  add_tile(n, a, b, tile, tile_rows);
  for (int j = 0; j < c.columns; ++j)
    for (int i = 0; i < c.rows; ++i) c.column(j)[i] += tile[j * tile_rows + i];
}

void add_part(int n, const float* a, const float* b, const FloatMatrix& c) {
  for (int j = 0; j < c.columns; j += tile_columns)
    for (int i = 0; i < c.rows; i += tile_rows) {
      const int rows = std::min(tile_rows, c.rows - i), columns = std::min(tile_columns, c.columns - j);
      const float *tile_a = a + std::ptrdiff_t(i) * n, *tile_b = b + std::ptrdiff_t(j) * n;
      if (rows == tile_rows && columns == tile_columns) {
        add_tile(n, tile_a, tile_b, c.column(j) + i, c.stride);
      } else {
        add_tile_at_border(n, tile_a, tile_b, c.part(i, j, rows, columns));
      }
    }
}

/// The free row with the largest entry of a column. Where no entry is larger than zero, the first free row.
int find_pivot(const float* column, const float* free, int n) {
  int best = -1;
  float largest = 0;
  for (int i = 0; i < n; ++i) {
    const float size = std::abs(column[i]) * free[i];
    if (size > largest) {
      largest = size;
      best = i;
    }
  }
  if (best < 0)
    for (best = 0; free[best] == 0;) ++best;
  return best;
}

/// Eliminates the columns of a panel inside the panel. Rows are not exchanged: column j finds its pivot in row pivot[j].
void eliminate_panel(const FloatMatrix& a, float* free, int* pivot) {
  const int n = a.rows;
  for (int j = 0; j < a.columns; ++j) {
    float* column = a.column(j);
    const int p = find_pivot(column, free, n);
    pivot[j] = p;
    free[p] = 0;
    const float inverse = 1 / column[p];
    for (int i = 0; i < n; ++i) column[i] *= -inverse;
    column[p] = inverse;
    for (int c = 0; c < a.columns; ++c) {
      if (c == j) continue;
      float* other = a.column(c);
      const float factor = other[p];
      other[p] = 0;
      for (int i = 0; i < n; ++i) other[i] += column[i] * factor;
    }
  }
}

/// What the elimination of a panel does to other columns.
void eliminate_others(const ConstFloatMatrix& eliminated, const int* pivot, const FloatMatrix& others, float* scratch) {
  const int n = eliminated.columns;
  const FloatMatrix rows{scratch, n, others.columns, panel};
  for (int j = 0; j < others.columns; ++j) {
    float *to = rows.column(j), *from = others.column(j);
    for (int k = 0; k < n; ++k) to[k] = from[pivot[k]];
    for (int k = 0; k < n; ++k) from[pivot[k]] = 0;
  }
  add_product(1, eliminated, rows, others, scratch + std::ptrdiff_t(panel) * others.columns);
}

}  // namespace

std::size_t product_scratch() { return std::size_t(depth) * (part_rows + part_columns); }

void add_product(float sign, const ConstFloatMatrix& a, const ConstFloatMatrix& b, const FloatMatrix& c,
                 float* scratch) {
  float *copy = scratch, *copy_of_b = scratch + depth * part_rows;
  for (int j = 0; j < c.columns; j += part_columns) {
    const int columns = std::min(part_columns, c.columns - j);
    for (int k = 0; k < a.columns; k += depth) {
      const int n = std::min(depth, a.columns - k);
      copy_b(b.part(k, j, n, columns), copy_of_b);
      for (int i = 0; i < c.rows; i += part_rows) {
        const int rows = std::min(part_rows, c.rows - i);
        copy_a(sign, a.part(i, k, rows, n), copy);
        add_part(n, copy, copy_of_b, c.part(i, j, rows, columns));
      }
    }
  }
}

std::size_t inversion_scratch(int size) { return std::size_t(size) * (panel + 2) + product_scratch(); }

void invert(const FloatMatrix& a, const FloatMatrix& inverse, float* scratch) {
  const int n = a.rows;
  float* free = scratch;
  int* pivot = reinterpret_cast<int*>(scratch + n);
  float* rest = scratch + 2 * std::ptrdiff_t(n);
  std::fill(free, free + n, 1.0f);
  for (int first = 0; first < n; first += panel) {
    const int columns = std::min(panel, n - first), next = first + columns;
    const FloatMatrix now = a.part(0, first, n, columns);
    eliminate_panel(now, free, pivot + first);
    eliminate_others(now, pivot + first, a.part(0, 0, n, first), rest);
    eliminate_others(now, pivot + first, a.part(0, next, n, n - next), rest);
  }
  for (int j = 0; j < n; ++j)  // undo the order of the pivots
    for (int i = 0; i < n; ++i) inverse.column(pivot[j])[i] = a.column(j)[pivot[i]];
}

}  // namespace softwet
