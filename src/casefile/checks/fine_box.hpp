// Where a graded mesh has its short elements, chosen from the scene.
#pragma once

#include <string>

#include "case/case.hpp"

namespace softwet {

/// Sets the box of domain.grading where the case leaves it to softwet: along each axis where the interface and the
/// contact lines are and may come to, with a margin of four capillarities, and the rows of the solid that droplets
/// deform. An axis along which that is not known is fine everywhere: with a droplet that moves at the start, with a
/// gradient along it that drives droplets, with a state that is given at each point.
/// Without a margin the mesh drives droplets: the energy of an interface depends on the length of its elements.
void choose_fine_box(Case&);

/// What to say of a box that ends too near to a droplet; empty: nothing.
std::string warning_about_fine_box(const Case&);

}  // namespace softwet
