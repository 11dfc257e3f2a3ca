#include "solver/direct/host/dense_product.hpp"

#include <algorithm>
#include <cmath>

#include "solver/direct/host/host_pack.hpp"

namespace softwet {

namespace {

/// The innermost loop computes a tile of c, which stays in registers: two packs high, and as wide as there are registers.
template <class Number>
constexpr int tile_rows = 2 * host_lanes<Number>;
constexpr int tile_columns = host_registers >= 32 ? 12 : 6;
/// Parts that stay in the caches: a part of a in the second one, a tile's part of b in the first one.
constexpr int depth = 256, part_rows = 192, part_columns = 85 * 12;
static_assert(part_rows % tile_rows<float> == 0 && part_rows % tile_rows<double> == 0);
static_assert(part_columns % tile_columns == 0);

/// Columns of a panel of the elimination.
constexpr int panel = 16;

/// Tiles of rows, each with its columns one after another; rows that do not exist are zero.
template <class Number>
void copy_a(Number sign, const DenseMatrix<const Number>& a, Number* to) {
  constexpr int height = tile_rows<Number>;
  for (int i = 0; i < a.rows; i += height) {
    const int rows = std::min(height, a.rows - i);
    for (int k = 0; k < a.columns; ++k, to += height) {
      const Number* from = a.column(k) + i;
      if (rows == height) {
        for (int r = 0; r < height; ++r) to[r] = sign * from[r];
      } else {
        for (int r = 0; r < height; ++r) to[r] = r < rows ? sign * from[r] : 0;
      }
    }
  }
}

/// Tiles of columns, each with its rows one after another; columns that do not exist are zero.
template <class Number>
void copy_b(const DenseMatrix<const Number>& b, Number* to) {
  for (int j = 0; j < b.columns; j += tile_columns) {
    const int columns = std::min(tile_columns, b.columns - j);
    const Number* from[tile_columns];
    for (int c = 0; c < tile_columns; ++c) from[c] = b.column(j + std::min(c, columns - 1));
    for (int k = 0; k < b.rows; ++k, to += tile_columns)
      for (int c = 0; c < tile_columns; ++c) to[c] = c < columns ? from[c][k] : 0;
  }
}

/// c += a b on one tile; c is whole.
template <class Number>
void add_tile(int n, const Number* a, const Number* b, Number* c, int stride) {
  using Pack = HostPack<Number>;
  constexpr int lanes = host_lanes<Number>;
  Pack sum[tile_columns][2];
  for (int j = 0; j < tile_columns; ++j) sum[j][0] = sum[j][1] = Pack(Number(0));
  for (int k = 0; k < n; ++k, a += 2 * lanes, b += tile_columns) {
    const Pack low = load(a), high = load(a + lanes);
    for (int j = 0; j < tile_columns; ++j) {
      const Pack factor(b[j]);
      sum[j][0] = sum[j][0] + low * factor;
      sum[j][1] = sum[j][1] + high * factor;
    }
  }
  for (int j = 0; j < tile_columns; ++j, c += stride) {
    store<Number>(load(c) + sum[j][0], c);
    store<Number>(load(c + lanes) + sum[j][1], c + lanes);
  }
}

/// c += a b on a tile inside which c ends.
template <class Number>
void add_tile_at_border(int n, const Number* a, const Number* b, const DenseMatrix<Number>& c) {
  constexpr int height = tile_rows<Number>;
  Number tile[tile_columns * height] = {};
  add_tile(n, a, b, tile, height);
  for (int j = 0; j < c.columns; ++j)
    for (int i = 0; i < c.rows; ++i) c.column(j)[i] += tile[j * height + i];
}

template <class Number>
void add_part(int n, const Number* a, const Number* b, const DenseMatrix<Number>& c) {
  constexpr int height = tile_rows<Number>;
  for (int j = 0; j < c.columns; j += tile_columns)
    for (int i = 0; i < c.rows; i += height) {
      const int rows = std::min(height, c.rows - i), columns = std::min(tile_columns, c.columns - j);
      const Number *tile_a = a + std::ptrdiff_t(i) * n, *tile_b = b + std::ptrdiff_t(j) * n;
      if (rows == height && columns == tile_columns) {
        add_tile(n, tile_a, tile_b, c.column(j) + i, c.stride);
      } else {
        add_tile_at_border(n, tile_a, tile_b, c.part(i, j, rows, columns));
      }
    }
}

/// The free row with the largest entry of a column. Where no entry is larger than zero, the first free row.
template <class Number>
int find_pivot(const Number* column, const Number* free, int n) {
  int best = -1;
  Number largest = 0;
  for (int i = 0; i < n; ++i) {
    const Number size = std::abs(column[i]) * free[i];
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
template <class Number>
void eliminate_panel(const DenseMatrix<Number>& a, Number* free, int* pivot) {
  const int n = a.rows;
  for (int j = 0; j < a.columns; ++j) {
    Number* column = a.column(j);
    const int p = find_pivot(column, free, n);
    pivot[j] = p;
    free[p] = 0;
    const Number inverse = 1 / column[p];
    for (int i = 0; i < n; ++i) column[i] *= -inverse;
    column[p] = inverse;
    for (int c = 0; c < a.columns; ++c) {
      if (c == j) continue;
      Number* other = a.column(c);
      const Number factor = other[p];
      other[p] = 0;
      for (int i = 0; i < n; ++i) other[i] += column[i] * factor;
    }
  }
}

/// What the elimination of a panel does to other columns.
template <class Number>
void eliminate_others(const DenseInput<Number>& eliminated, const int* pivot, const DenseMatrix<Number>& others,
                      Number* scratch) {
  const int n = eliminated.columns;
  const DenseMatrix<Number> rows{scratch, n, others.columns, panel};
  for (int j = 0; j < others.columns; ++j) {
    Number *to = rows.column(j), *from = others.column(j);
    for (int k = 0; k < n; ++k) to[k] = from[pivot[k]];
    for (int k = 0; k < n; ++k) from[pivot[k]] = 0;
  }
  add_product(1, eliminated, rows, others, scratch + std::ptrdiff_t(panel) * others.columns);
}

}  // namespace

std::size_t product_scratch() { return std::size_t(depth) * (part_rows + part_columns); }

template <class Number>
void add_product(std::type_identity_t<Number> sign, const DenseInput<Number>& a, const DenseInput<Number>& b,
                 const DenseOutput<Number>& c, Number* scratch) {
  Number *copy = scratch, *copy_of_b = scratch + depth * part_rows;
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

template <class Number>
void invert(const DenseOutput<Number>& a, const DenseOutput<Number>& inverse, Number* scratch) {
  const int n = a.rows;
  Number* free = scratch;
  int* pivot = reinterpret_cast<int*>(scratch + n);
  Number* rest = scratch + 2 * std::ptrdiff_t(n);
  std::fill(free, free + n, Number(1));
  for (int first = 0; first < n; first += panel) {
    const int columns = std::min(panel, n - first), next = first + columns;
    const DenseMatrix<Number> now = a.part(0, first, n, columns);
    eliminate_panel(now, free, pivot + first);
    eliminate_others(now, pivot + first, a.part(0, 0, n, first), rest);
    eliminate_others(now, pivot + first, a.part(0, next, n, n - next), rest);
  }
  for (int j = 0; j < n; ++j)  // undo the order of the pivots
    for (int i = 0; i < n; ++i) inverse.column(pivot[j])[i] = a.column(j)[pivot[i]];
}

template void add_product(float, const DenseInput<float>&, const DenseInput<float>&, const DenseOutput<float>&, float*);
template void add_product(double, const DenseInput<double>&, const DenseInput<double>&, const DenseOutput<double>&,
                          double*);
template void invert(const DenseOutput<float>&, const DenseOutput<float>&, float*);
template void invert(const DenseOutput<double>&, const DenseOutput<double>&, double*);

}  // namespace softwet
