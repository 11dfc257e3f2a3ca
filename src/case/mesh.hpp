// The elements of a case along each axis: equal ones, or short ones where the scene needs them and longer ones beside.
#pragma once

#include <vector>

#include "case/case.hpp"

namespace softwet {

/// Length of the elements where the scene needs them: domain.size / domain.elements. Unit L0.
double fine_length(const Case&, int axis);

/// Where the elements along an axis end, ascending from 0 to its length; empty where all are equal. The box of
/// domain.grading has elements of the fine length, from line to line of the mesh of equal elements. Beside it each
/// element is longer than its neighbour by at most `ratio`, up to `coarsest` fine lengths: the fewest elements that
/// fill the room, by the smallest ratio that does. An axis that would keep more than 95 % of its elements has equal
/// ones. Around a periodic axis the last element is the neighbour of the first: the ratio holds there too, and the box
/// may reach around.
std::vector<double> graded_breaks(const Case&, int axis);

int elements_along(const Case&, int axis);

/// Between which places along an axis elements have the fine length; beyond all places where it reaches a side. Around
/// a periodic axis `low` lies in the domain, and `high` may lie beyond its end.
struct FinePart {
  double low, high;
};
FinePart fine_part(const Case&, int axis);

/// Capillarities between the middle of an interface and the end of the fine elements. With 3 the mesh moves a droplet
/// at rest by 2e-5 of the domain, with 1.3 by 5e-4. Above a cap on a wall less will do, for what grows there is the
/// same on its left and right.
constexpr double least_fine_margin = 3, least_fine_margin_above = 2;

/// Rows of elements in the solid; 0 without a solid.
int solid_elements(const Case&);

/// Rows of elements below substrate.joint; 0 without one.
int joint_element(const Case&);

/// Height of the end of so many rows of elements.
double end_of_row(const Case&, int row);

/// Elements of the whole case over the elements of a mesh of equal ones.
double share_of_elements(const Case&);

}  // namespace softwet
