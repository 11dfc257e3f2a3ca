// Whether an interface is too wide for the numbers at its contact line to be those of a real one (host).
#pragma once

#include <string>

#include "case/case.hpp"

namespace softwet {

/// The largest width 2 g of the interface with which the numbers at a contact line are near those of a narrow one: Upsilon/E,
/// sigma/E or a quarter of the layer; scale L0. Only with a fluid and a solid.
double widest_interface(const Case&);

/// A sentence where the width 2 g of the interface is more than Upsilon/E, sigma/E or a quarter of the layer: the ridge at the contact
/// line is then lower than that of a narrow interface, by how much and what gives it. Empty where it is not, and without a droplet on a
/// solid. Measured against sharp interfaces: docs/converge.md.
std::string warning_about_width(const Case&);

}  // namespace softwet
