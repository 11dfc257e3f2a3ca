// When a run writes field files.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "case/case.hpp"

namespace softwet {

/// Field files of one run: their names have four digits.
constexpr int most_field_files = 10000;

/// Times that differ by rounding alone.
inline bool same_time(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b)); }

/// How many multiples of output.fields.every lie in [0, time.end]; 0 where the case has no interval.
double count_of_multiples(const Case&);

/// Times in t, increasing: output.fields.times, and 0, every, 2 every, ... up to time.end. Multiples of a short
/// decimal are the numbers next to the decimals: 0.3, not 3 * 0.1 = 0.30000000000000004.
std::vector<double> field_times(const Case&);

}  // namespace softwet
