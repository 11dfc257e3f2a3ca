// The known word closest to a misspelt one, for "did you mean" in error messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace softwet {

/// Insertions, deletions, substitutions and swaps of neighbours that turn one word into the other.
int edit_distance(std::string_view from, std::string_view to);

/// The entry of `known` that a misspelt word is likely to mean: few wrong letters ("viscosty"), the last part of a name
/// where the word names no table ("viscosity" finds "fluid.viscosity"), or one word of it ("angle" finds
/// "fluid.contact_angle"). Empty where none is near.
std::string nearest_name(std::string_view word, const std::vector<std::string>& known);

}  // namespace softwet
