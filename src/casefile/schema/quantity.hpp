// A physical quantity in text, "72 mN/m", as a number in SI units.
#pragma once

#include <optional>
#include <string>

namespace softwet {

enum class Quantity { length, surface_tension, density, viscosity, stress };

/// The number in SI units; nothing where the text is not a positive number with a unit of this quantity. Units may be
/// written as people write them: "500 um", "500µm", "72 dyn/cm", "1 mPa s", "1000 kg/m^3".
std::optional<double> si_from(Quantity, const std::string& text);

/// What is wrong with a text that si_from does not take: the units that there are, and of what the one given is.
std::string problem_with(Quantity, const std::string& text);

/// As si_from; what is wrong is thrown as Error (invalid_input).
/// @param name  of the option, for the message
double si_from_text(const std::string& name, Quantity quantity, const std::string& text);

}  // namespace softwet
