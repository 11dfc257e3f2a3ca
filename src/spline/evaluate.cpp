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

template <int D>
std::vector<double> evaluate_grid(const double* box, const std::array<int, D>& extent,
                                  const std::array<AxisSamples, D>& at, int derivative) {
  // Contract one axis after the other, last axis first: [k][j][i] -> [qk][j][i] -> ...
  std::size_t outer = 1, inner = 1;
  for (int d = 0; d < D - 1; ++d) inner *= extent[d];
  std::vector<double> now(box, box + inner * extent[D - 1]);
  for (int d = D - 1; d >= 0; --d) {
    const std::size_t points = at[d].first.size();
    std::vector<double> next(outer * points * inner, 0.0);
    for (std::size_t o = 0; o < outer; ++o)
      for (std::size_t q = 0; q < points; ++q) {
        const std::vector<double>& basis = d == derivative ? at[d].slope[q] : at[d].value[q];
        double* out = next.data() + (o * points + q) * inner;
        for (std::size_t a = 0; a < basis.size(); ++a) {
          const double* in = now.data() + (o * extent[d] + at[d].first[q] + a) * inner;
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
