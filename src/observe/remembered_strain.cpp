#include <algorithm>

#include "observe/acting_stress.hpp"

namespace softwet {
namespace {

/// Values at a place, a share of an element, of the polynomials that are 1 at one Gauss point and 0 at the others.
std::vector<double> lagrange(const Gauss& gauss, double place) {
  std::vector<double> values(gauss.point.size(), 1.0);
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = 0; j < values.size(); ++j)
      if (j != i) values[i] *= (place - gauss.point[j]) / (gauss.point[i] - gauss.point[j]);
  return values;
}

/// The elements that hold the points of an axis, and the polynomials of their Gauss points there.
struct Places {
  std::vector<int> element;
  std::vector<std::vector<double>> share;

  Places(const Axis& axis, const std::vector<double>& points, int first, int last, const Gauss& gauss) {
    for (const double x : points) {
      element.push_back(std::clamp(axis.element_at(x), first, last - 1));
      share.push_back(lagrange(gauss, (x - axis.lower(element.back())) / axis.size(element.back())));
    }
  }
};

/// Where the numbers of an element begin in the memory of a branch, and how far apart they are (PointMemory).
struct Room {
  std::size_t first, apart_points, apart_numbers;
};
template <int D>
Room room_of(const Layout<D>& layout, const std::array<int, D>& element, int entries, std::size_t points) {
  const std::size_t columns = layout.extent(0);
  const int rows = D == 3 ? layout.axis[1].elements() : 1;
  const std::size_t row = D == 3 ? std::size_t(element[D - 1]) * rows + element[1] : element[D - 1];
  return {row * entries * points * columns + element[0], columns, points * columns};
}

}  // namespace

template <int D>
std::vector<Matrix<double, 3>> remembered_strains(const SolidPoints<D>& at, int branch, int gauss_points) {
  const Layout<D>& layout = at.snapshot.layout();
  const Gauss gauss(gauss_points);
  const int entries = layout.axisymmetric() ? 4 : D * (D + 1) / 2;
  std::vector<Places> along;
  std::size_t points = 1;
  for (int d = 0; d < D; ++d) {
    const bool vertical = d == D - 1;
    along.emplace_back(layout.axis[d], at.grid[d], vertical ? at.rows.first : 0,
                       vertical ? at.rows.last : layout.axis[d].elements(), gauss);
    points *= gauss_points;
  }
  const double* const memory = at.snapshot.memory().data() + std::size_t(branch) * layout.branch_size();
  std::vector<Matrix<double, 3>> strains;
  for (std::size_t i = 0; i < at.size(); ++i) {
    std::array<int, D> element;
    std::array<const std::vector<double>*, D> share;
    std::size_t rest = i;
    for (int d = 0; d < D; ++d) {
      const std::size_t k = rest % at.grid[d].size();
      element[d] = along[d].element[k], share[d] = &along[d].share[k];
      rest /= at.grid[d].size();
    }
    const Room room = room_of<D>(layout, element, entries, points);
    std::array<double, 6> sum{};
    for (std::size_t q = 0; q < points; ++q) {
      double weight = 1;
      std::size_t number = q;
      for (int d = 0; d < D; ++d, number /= gauss_points) weight *= (*share[d])[number % gauss_points];
      for (int k = 0; k < entries; ++k)
        sum[k] += weight * memory[room.first + k * room.apart_numbers + q * room.apart_points];
    }
    Matrix<double, 3> e{};
    int k = 0;
    for (int a = 0; a < D; ++a)
      for (int b = a; b < D; ++b) e(a, b) = e(b, a) = sum[k++];
    if (layout.axisymmetric()) e(2, 2) = sum[k];
    strains.push_back(e);
  }
  return strains;
}

template std::vector<Matrix<double, 3>> remembered_strains(const SolidPoints<2>&, int, int);
template std::vector<Matrix<double, 3>> remembered_strains(const SolidPoints<3>&, int, int);

}  // namespace softwet
