#include "solver/colours.hpp"

#include <algorithm>

namespace softwet {

namespace {

/// Colours along an axis such that equal colours are more than 2 degree apart (cyclically on a periodic axis).
std::vector<int> axis_colours(const Axis& axis) {
  const int width = 2 * axis.degree() + 1, n = axis.owned();
  const int regular = axis.periodic() ? n - n % width : n;
  std::vector<int> colour(axis.functions());
  for (int i = 0; i < n; ++i) colour[i] = i < regular ? i % width : width + i - regular;
  for (int i = n; i < axis.functions(); ++i) colour[i] = colour[i - n];
  return colour;
}

}  // namespace

template <int D>
Colours make_colours(const Layout<D>& layout, const std::vector<double>& mask) {
  Colours result;
  result.of.assign(layout.size(), -1);
  result.point.assign(3 * static_cast<std::size_t>(layout.size()), 0);
  std::vector<int> colour[D];
  int total[D];
  for (int d = 0; d < D; ++d) {
    colour[d] = axis_colours(layout.axis[d]);
    total[d] = *std::max_element(colour[d].begin(), colour[d].end()) + 1;
  }
  for_unknowns(layout, [&](int unknown, int component, const int* point) {
    int key = component;
    for (int d = 0; d < D; ++d) {
      key = key * total[d] + colour[d][point[d]];
      result.point[3 * unknown + d] = point[d];
    }
    if (mask[unknown] == 0) return;
    result.of[unknown] = key;
    result.count = std::max(result.count, key + 1);
  });
  return result;
}

template Colours make_colours<2>(const Layout<2>&, const std::vector<double>&);
template Colours make_colours<3>(const Layout<3>&, const std::vector<double>&);

}  // namespace softwet
