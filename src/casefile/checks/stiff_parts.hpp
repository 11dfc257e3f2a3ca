// How stiff parts of a solid may be before the digits of a number no longer hold what they do.
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"

namespace softwet {

/// The largest stiffness k of a needle that leaves its reading three digits. The reading is k (U - u) in the volume of
/// its box. With a displacement u as large as the scene, S, or as the way of the needle, the last digit e of u is a
/// force k e u for each volume, and a strain of u/S is one of E u/S^2: k <= 1e-3 E / (e S max(S, |U|)).
/// Tested: tests/unit/casefile/test_needle_cases.cpp, and against readings: tests/regression/stiff_parts.py
double largest_needle_stiffness(const Case&, const Needle&);

/// A stiffness of a needle that holds rigidly, with digits to spare: 1e4 E/h^2.
double rigid_needle_stiffness(const Case&);

/// Adds a sentence for each part of the solid that is too stiff beside it for the digits of linear solves: fibres,
/// moduli of its face.
void warn_of_stiff_parts(const Case&, std::vector<std::string>& found);

}  // namespace softwet
