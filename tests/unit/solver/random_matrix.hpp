// Matrices with random entries on layouts of every kind, and dense or sparse references for what solvers do with them.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <random>

#include "solver/schwarz/coarse_space.hpp"

namespace softwet::testing_tools {

using Sparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using DenseVector = Eigen::VectorXd;

struct Shape {
  std::vector<int> elements;
  int solid_elements = 0;  ///< all of the last axis: a solid alone
  int degree = 2;
  bool periodic = false;  ///< all axes but the last
};

template <int D>
Layout<D> make_layout(const Shape& s) {
  Layout<D> l;
  l.solid_elements = s.solid_elements;
  l.has_solid = s.solid_elements > 0;
  l.has_fluid = s.solid_elements < s.elements[D - 1];
  l.row_size = 1;
  for (int d = 0; d < D; ++d) {
    const int kink = d == D - 1 && l.has_solid && l.has_fluid ? s.solid_elements : 0;
    l.axis.emplace_back(0.7 + 0.2 * d, s.elements[d], s.degree,
                        s.periodic && d < D - 1 ? AxisKind::periodic : AxisKind::bounded, kink);
    if (d < D - 1) l.row_size *= l.axis[d].functions();
  }
  l.rows = l.axis[D - 1].functions();
  if (l.has_solid) l.wall_row = l.has_fluid ? l.axis[D - 1].span(l.solid_elements) : l.rows - 1;
  return l;
}

/// Velocities are prescribed on the lowest row, the first one on the side in front too. Ghosts are never free.
template <int D>
std::vector<double> make_mask(const Layout<D>& l) {
  const Stencil<D> s(l);
  std::vector<double> mask(l.size(), 0.0);
  for (int c = 0; c < s.components; ++c)
    for (int p = l.component_first(c); p < s.points; ++p) {
      bool free = c >= D || (p >= l.row_size && (c > 0 || l.axis[0].periodic() || s.coordinate(p, 0) > 0));
      for (int d = 0; d < D; ++d) free = free && s.coordinate(p, d) < l.axis[d].owned();
      if (free) mask[l.component_shift(c) + p] = 1;
    }
  return mask;
}

/// A well conditioned matrix: a large diagonal, and entries that fall off with the distance.
template <int D>
struct RandomMatrix {
  Layout<D> layout;
  Array mask;
  StencilMatrix<D> matrix;
  std::mt19937 draw{5};

  explicit RandomMatrix(const Shape& shape)
      : layout(make_layout<D>(shape)), mask(to_device<Array>(make_mask(layout))), matrix(layout, mask) {
    fill();
  }
  void fill() {
    const UnknownTable<D> table(layout, to_host(mask));
    std::uniform_real_distribution<float> number(-1, 1);
    matrix.fill([&](const StencilValues& values) {
      const auto host = Kokkos::create_mirror_view(values);
      Kokkos::deep_copy(host, 0.0f);
      const Stencil<D>& s = matrix.stencil();
      for (int p = 0; p < s.points; ++p)
        for (int o = 0; o < s.offsets; ++o) {
          const int to = s.neighbour(p, o);
          float size = 0.5f;
          for (int d = 0; d < D; ++d) size /= 1 + 3 * std::abs(s.shift(o, d));
          for (int a = 0; a < s.components && to >= 0; ++a)
            for (int u = 0; u < s.components; ++u) {
              if (table.unknown(a, p) < 0 || table.unknown(u, to) < 0) continue;
              const float entry = size * number(draw) + (a == u && o == s.offsets / 2 ? 3 : 0);
              if (s.couples(a, u)) host(s.index(a, u, o, p)) = entry;
            }
        }
      Kokkos::deep_copy(values, host);
    });
  }
  DenseVector direction() {
    std::uniform_real_distribution<double> number(-1, 1);
    const std::vector<double> free = to_host(mask);
    DenseVector x(layout.size());
    for (int i = 0; i < layout.size(); ++i) x[i] = free[i] * number(draw);
    return x;
  }
};

inline Array to_array(const DenseVector& x) {
  return to_device<Array>(std::vector<double>(x.data(), x.data() + x.size()));
}
inline DenseVector to_vector(const ConstArray& x) {
  const std::vector<double> v = to_host(x);
  return Eigen::Map<const DenseVector>(v.data(), v.size());
}
inline double relative(const DenseVector& found, const DenseVector& expected) {
  return (found - expected).norm() / expected.norm();
}

/// The matrix of the stencil's values; prescribed unknowns and ghosts have empty rows and columns.
template <int D>
Sparse sparse(const StencilMatrix<D>& matrix) {
  const Stencil<D>& s = matrix.stencil();
  const UnknownTable<D> table(matrix.layout(), to_host(matrix.mask()));
  const auto values = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), matrix.values());
  std::vector<Eigen::Triplet<double>> entries;
  for (int p = 0; p < s.points; ++p)
    for (int o = 0; o < s.offsets; ++o)
      for (int a = 0; a < s.components; ++a)
        for (int u = 0; u < s.components; ++u) {
          const int to = s.neighbour(p, o), row = table.unknown(a, p), column = to < 0 ? -1 : table.unknown(u, to);
          if (row >= 0 && column >= 0 && s.couples(a, u))
            entries.emplace_back(row, column, values(s.index(a, u, o, p)));
        }
  Sparse a(matrix.layout().size(), matrix.layout().size());
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

/// P by its definition: the product of the axes' coefficients, for free unknowns of both sides.
template <int D>
Sparse prolongation(const Layout<D>& fine, const ConstArray& fine_mask, const CoarseSpace<D>& space, int least) {
  const Layout<D>& coarse = space.layout();
  const Stencil<D> in(fine), out(coarse);
  const UnknownTable<D> from(coarse, to_host(space.mask())), to(fine, to_host(fine_mask));
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Refinement> axis;
  for (int d = 0; d < D; ++d) axis.push_back(refine_from_half(fine.axis[d], least));
  for (int p = 0; p < out.points; ++p) {
    std::vector<std::pair<int, double>> points{{0, 1.0}};
    for (int d = 0, stride = 1; d < D; stride *= in.extent[d], ++d) {
      std::vector<std::pair<int, double>> longer;
      const int j = out.coordinate(p, d), n = fine.axis[d].owned();
      for (const auto& [point, weight] : points)
        for (std::size_t k = 0; k < axis[d].coefficient[j].size(); ++k) {
          const int i = (axis[d].first[j] + static_cast<int>(k) + n) % n;
          longer.emplace_back(point + stride * i, weight * axis[d].coefficient[j][k]);
        }
      points = longer;
    }
    for (int c = 0; c < out.components; ++c)
      for (const auto& [point, weight] : points)
        if (from.unknown(c, p) >= 0 && to.unknown(c, point) >= 0)
          entries.emplace_back(to.unknown(c, point), from.unknown(c, p), weight);
  }
  Sparse result(fine.size(), coarse.size());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// One of every kind in three dimensions. Their first axis has the most elements, so that levels differ in shape.
inline std::vector<Shape> shapes_3d() {
  return {{{12, 4, 6}, 2},  // coupled
          {{8, 6, 5}, 0},   // rigid; the last axis cannot be halved
          {{10, 4, 4}, 4},  // a solid alone
          {{12, 8, 4}, 0, 2, true},
          {{8, 8, 6}, 2, 3, true}};
}

}  // namespace softwet::testing_tools
