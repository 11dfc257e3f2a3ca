// A physical quantity in text, "72 mN/m", as a number in SI units.
#pragma once

#include <string>

namespace softwet {

enum class Quantity { length, surface_tension, density, viscosity, stress };

/// @param name  of the option, for the message
/// Throws Error (invalid_input) that lists the units there are where the text is not a positive number with one of them.
double si_from_text(const std::string& name, Quantity quantity, const std::string& text);

}  // namespace softwet
