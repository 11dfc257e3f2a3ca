// Evaluation of spline fields on the host: at single points and on tensor grids of points.
#pragma once

#include <array>
#include <vector>

#include "spline/axis.hpp"

namespace softwet {

/// The functions of one axis that live at a list of points, restricted to rows that a component stores.
struct AxisSamples {
  int functions = 0;           ///< that live at a point: degree + 1
  std::vector<int> first;      ///< of them, per point
  std::vector<double> weight;  ///< per point: their values, or their slopes, 1/L0
};

/// Whether values or slopes of the functions of an axis are sampled.
enum class Sampled { values, slopes };

/// @param shift  row of the axis at which the component starts (0 except along the last axis)
/// @param lowest element used for points at its lower end, so that a trace on the C0 line is taken from above
AxisSamples sample_axis(const Axis&, const std::vector<double>& points, Sampled = Sampled::values, int shift = 0,
                        int lowest = 0, int highest = 1 << 30);

/// At the tensor product of samples, first axis fastest: values of a component, or its derivative along the axis of
/// slopes.
/// @param box       control values [k][j][i]
/// @param extent    stored functions per axis
template <int D>
std::vector<double> evaluate_grid(const double* box, const std::array<int, D>& extent,
                                  const std::array<AxisSamples, D>& at);

}  // namespace softwet
