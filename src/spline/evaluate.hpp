// Evaluation of spline fields on the host: at single points and on tensor grids of points.
#pragma once

#include <array>
#include <vector>

#include "spline/axis.hpp"

namespace softwet {

/// The living functions of one axis at a list of points, restricted to rows that a component stores.
struct AxisSamples {
  std::vector<int> first;                  ///< per point
  std::vector<std::vector<double>> value;  ///< per point, degree + 1
  std::vector<std::vector<double>> slope;  ///< per point, degree + 1, 1/L0
  std::vector<double> position;
};

/// @param shift  row of the axis at which the component starts (0 except along the last axis)
/// @param lowest element used for points at its lower end, so that a trace on the C0 line is taken from above
AxisSamples sample_axis(const Axis&, const std::vector<double>& points, int shift = 0, int lowest = 0,
                        int highest = 1 << 30);

/// Values of a component at the tensor product of samples, first axis fastest.
/// @param box       control values [k][j][i]
/// @param extent    stored functions per axis
/// @param derivative axis to differentiate along, or -1
template <int D>
std::vector<double> evaluate_grid(const double* box, const std::array<int, D>& extent,
                                  const std::array<AxisSamples, D>& at, int derivative = -1);

}  // namespace softwet
