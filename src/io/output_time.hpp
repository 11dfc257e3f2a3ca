// Times as people write them.
#pragma once

namespace softwet {

/// The number of 12 significant digits that differs from the value by no more than `rounding`, or else the value
/// itself: 3 * 0.1 = 0.30000000000000004 becomes 0.3.
double short_decimal(double value, double rounding);

/// The short decimal next to a value that is a product or a quotient of short decimals: it may differ by a few units in
/// its last place.
double short_decimal(double value);

/// t = time - zero on the clock of all results, without what the subtraction and the sum of the steps have rounded.
/// @param time  on the clock of the computation  @param zero  Case::clock_zero
double output_time(double time, double zero);

}  // namespace softwet
