// Points of a tensor-product rule with the B-splines alive there: for load vectors and error norms on the host.
#pragma once

#include "exact.hpp"
#include "field/layout.hpp"

namespace softwet::mms {

/// A point of one axis: where, its weight, and the living functions.
struct AxisPoint {
  double position, weight;
  int first;
  std::vector<double> value;
};

/// Gauss points of the elements [first, last).
inline std::vector<AxisPoint> gauss_points(const Axis& axis, int first, int last, int points) {
  const Gauss rule(points);
  std::vector<AxisPoint> result;
  for (int e = first; e < last; ++e)
    for (int q = 0; q < points; ++q) {
      const double x = axis.lower(e) + axis.size(e) * rule.point[q];
      result.push_back({x, axis.size(e) * rule.weight[q], axis.span(e), axis.values(e, x)});
    }
  return result;
}

/// One point of weight 1 at the lower (side = -1) or upper end of an element: a face.
inline std::vector<AxisPoint> face_point(const Axis& axis, int element, int side) {
  const double x = axis.lower(side < 0 ? element : element + 1);
  return {{x, 1.0, axis.span(element), axis.values(element, x)}};
}

/// A region, or a horizontal face, of the patch with `points` Gauss points per element and axis.
template <int D>
struct Quadrature {
  std::array<std::vector<AxisPoint>, D> axis;
  std::array<int, D> stride;

  Quadrature(const Layout<D>& layout, int points, std::vector<AxisPoint> last) {
    int step = 1;
    for (int d = 0; d < D; ++d) {
      const Axis& a = layout.axis[d];
      axis[d] = d < D - 1 ? gauss_points(a, 0, a.elements(), points) : std::move(last);
      stride[d] = step;
      step *= a.functions();
    }
  }

  /// Calls visit(position, weight, functions) at every point; functions(use) calls use(index, value) for every living
  /// function, with its index in a component that has all rows of the patch.
  template <class Visit>
  void for_points(const Visit& visit) const {
    std::size_t count = 1;
    for (const auto& a : axis) count *= a.size();
    for (std::size_t k = 0; k < count; ++k) {
      std::size_t rest = k;
      const AxisPoint* at[D];
      Vector<double, D> position;
      double weight = 1;
      for (int d = 0; d < D; ++d) {
        at[d] = &axis[d][rest % axis[d].size()];
        rest /= axis[d].size();
        position[d] = at[d]->position;
        weight *= at[d]->weight;
      }
      visit(position, weight, [&](const auto& use) { for_functions(at, use); });
    }
  }

 private:
  template <class Use>
  void for_functions(const AxisPoint* const (&at)[D], const Use& use) const {
    const int n = static_cast<int>(at[0]->value.size());
    int count = 1;
    for (int d = 0; d < D; ++d) count *= n;
    for (int k = 0; k < count; ++k) {
      int rest = k, index = 0;
      double value = 1;
      for (int d = 0; d < D; ++d) {
        const int a = rest % n;
        rest /= n;
        index += (at[d]->first + a) * stride[d];
        value *= at[d]->value[a];
      }
      use(index, value);
    }
  }
};

}  // namespace softwet::mms
