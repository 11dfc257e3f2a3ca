#include "spline/evaluate.hpp"

#include <algorithm>

namespace softwet {

AxisSamples sample_axis(const Axis& axis, const std::vector<double>& points, Sampled sampled, int shift, int lowest,
                        int highest) {
  AxisSamples s;
  s.functions = axis.degree() + 1;
  s.first.resize(points.size());
  s.weight.resize(points.size() * s.functions);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const int e = std::clamp(axis.element_at(points[i]), lowest, std::min(highest, axis.elements()) - 1);
    s.first[i] = axis.span(e) - shift;
    double* const weight = s.weight.data() + i * s.functions;
    sampled == Sampled::values ? axis.values(e, points[i], weight) : axis.slopes(e, points[i], weight);
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
      count[d] = *high + at[d].functions - *low;
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
                                  const std::array<AxisSamples, D>& at) {
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
    const int functions = at[d].functions;
    std::vector<double> next(outer * points * inner, 0.0);
    for (std::size_t o = 0; o < outer; ++o)
      for (std::size_t q = 0; q < points; ++q) {
        const double* weight = at[d].weight.data() + q * functions;
        double* out = next.data() + (o * points + q) * inner;
        const double* in = now.data() + (o * extent[d] + at[d].first[q] - crop.first[d]) * inner;
        if (d == 0) {
          double sum = 0;
          for (int a = 0; a < functions; ++a) sum += weight[a] * in[a];
          *out = sum;
          continue;
        }
        for (int a = 0; a < functions; ++a, in += inner)
          for (std::size_t i = 0; i < inner; ++i) out[i] += weight[a] * in[i];
      }
    now = std::move(next);
    outer *= points;
    if (d > 0) inner /= extent[d - 1];
  }
  return now;
}

template std::vector<double> evaluate_grid<2>(const double*, const std::array<int, 2>&,
                                              const std::array<AxisSamples, 2>&);
template std::vector<double> evaluate_grid<3>(const double*, const std::array<int, 3>&,
                                              const std::array<AxisSamples, 3>&);

}  // namespace softwet
