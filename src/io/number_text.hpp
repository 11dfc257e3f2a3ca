// Numbers as text: the shortest form that reads back as the same double.
#pragma once

#include <string>

namespace softwet {

/// Shortest decimal text that round-trips (at most 17 significant digits), independent of the locale; whole numbers
/// below 2^53 are printed as integers ("1000000", not "1e+06"). Not finite: "nan", "inf", "-inf".
std::string number_text(double value);

}  // namespace softwet
