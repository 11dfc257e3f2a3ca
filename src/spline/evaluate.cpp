#include "spline/evaluate.hpp"

#include <algorithm>
#include <utility>

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

/// One axis of [outer][extent][inner] contracted: [outer][points][inner].
/// @param Known  number of functions that live at a point, in which loops of a known length are unrolled; 0: any
/// @param first  the row of the axis at which the values begin
template <int Known>
void contract(const AxisSamples& at, int first, std::size_t extent, std::size_t inner,
              const std::vector<double>& values, std::vector<double>& result) {
  const int functions = Known > 0 ? Known : at.functions;
  const std::size_t points = at.first.size(), outer = values.size() / (extent * inner);
  double* out = result.data();
  for (std::size_t o = 0; o < outer; ++o)
    for (std::size_t q = 0; q < points; ++q, out += inner) {
      const double* weight = at.weight.data() + q * functions;
      const double* in = values.data() + (o * extent + at.first[q] - first) * inner;
      for (std::size_t i = 0; i < inner; ++i) {
        double sum = 0;
        for (int a = 0; a < functions; ++a) sum += weight[a] * in[a * inner + i];
        out[i] = sum;
      }
    }
}

void contract(const AxisSamples& at, int first, std::size_t extent, std::size_t inner,
              const std::vector<double>& values, std::vector<double>& result) {
  switch (at.functions) {
    case 3:
      return contract<3>(at, first, extent, inner, values, result);
    case 4:
      return contract<4>(at, first, extent, inner, values, result);
    default:
      return contract<0>(at, first, extent, inner, values, result);
  }
}

}  // namespace

template <int D>
std::vector<double> evaluate_grid(const double* box, const std::array<int, D>& whole,
                                  const std::array<AxisSamples, D>& at) {
  for (const AxisSamples& axis : at)
    if (axis.first.empty()) return {};
  Crop<D> crop(box, whole, at);
  // Last axis first: [k][j][i] -> [qk][j][i] -> ...
  std::vector<double> now = std::move(crop.values);
  std::size_t inner = now.size() / crop.count[D - 1];
  for (int d = D - 1; d >= 0; --d) {
    std::vector<double> next(now.size() / crop.count[d] * at[d].first.size());
    contract(at[d], crop.first[d], crop.count[d], inner, now, next);
    now = std::move(next);
    if (d > 0) inner /= crop.count[d - 1];
  }
  return now;
}

template std::vector<double> evaluate_grid<2>(const double*, const std::array<int, 2>&,
                                              const std::array<AxisSamples, 2>&);
template std::vector<double> evaluate_grid<3>(const double*, const std::array<int, 3>&,
                                              const std::array<AxisSamples, 3>&);

}  // namespace softwet
