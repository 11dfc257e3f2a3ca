#include "spline/evaluate.hpp"

#include <algorithm>

namespace softwet {

AxisSamples sample_axis(const Axis& axis, const std::vector<double>& points, int shift, int lowest, int highest) {
  AxisSamples s;
  s.position = points;
  for (double x : points) {
    const int e = std::clamp(axis.element_at(x), lowest, std::min(highest, axis.elements()) - 1);
    s.first.push_back(axis.span(e) - shift);
    s.value.push_back(axis.values(e, x));
    s.slope.push_back(axis.slopes(e, x));
  }
  return s;
}

namespace {

/// The control values that samples touch: a box inside the box.
template <int D>
struct Crop {
  std::array<int, D> first, count;
  std::vector<double> values;

  Crop(const double* box, const std::array<int, D>& extent, const std::array<AxisSamples, D>& at) {
    std::size_t all = 1;
    for (int d = 0; d < D; ++d) {
      const auto [low, high] = std::minmax_element(at[d].first.begin(), at[d].first.end());
      first[d] = *low;
      count[d] = *high + static_cast<int>(at[d].value[0].size()) - *low;
      all *= count[d];
    }
    values.reserve(all);
    for (int k = 0; k < (D == 3 ? count[D - 1] : 1); ++k)
      for (int j = 0; j < count[1]; ++j) {
        const std::size_t plane = D == 3 ? static_cast<std::size_t>(first[D - 1] + k) * extent[1] : 0;
        const double* row = box + (plane + first[1] + j) * extent[0] + first[0];
        values.insert(values.end(), row, row + count[0]);
      }
  }
};

}  // namespace

template <int D>
std::vector<double> evaluate_grid(const double* box, const std::array<int, D>& whole,
                                  const std::array<AxisSamples, D>& at, int derivative) {
  for (const AxisSamples& axis : at)
    if (axis.first.empty()) return {};
  Crop<D> crop(box, whole, at);
  const std::array<int, D>& extent = crop.count;
  // Contract one axis after the other, last axis first: [k][j][i] -> [qk][j][i] -> ...
  std::size_t outer = 1, inner = 1;
  for (int d = 0; d < D - 1; ++d) inner *= extent[d];
  std::vector<double> now = std::move(crop.values);
  for (int d = D - 1; d >= 0; --d) {
    const std::size_t points = at[d].first.size();
    std::vector<double> next(outer * points * inner, 0.0);
    for (std::size_t o = 0; o < outer; ++o)
      for (std::size_t q = 0; q < points; ++q) {
        const std::vector<double>& basis = d == derivative ? at[d].slope[q] : at[d].value[q];
        double* out = next.data() + (o * points + q) * inner;
        for (std::size_t a = 0; a < basis.size(); ++a) {
          const double* in = now.data() + (o * extent[d] + at[d].first[q] - crop.first[d] + a) * inner;
          for (std::size_t i = 0; i < inner; ++i) out[i] += basis[a] * in[i];
        }
      }
    now = std::move(next);
    outer *= points;
    if (d > 0) inner /= extent[d - 1];
  }
  return now;
}

template std::vector<double> evaluate_grid<2>(const double*, const std::array<int, 2>&,
                                              const std::array<AxisSamples, 2>&, int);
template std::vector<double> evaluate_grid<3>(const double*, const std::array<int, 3>&,
                                              const std::array<AxisSamples, 3>&, int);

}  // namespace softwet
