// The known word closest to a misspelt one, for "did you mean" in error messages.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace softwet {

/// Insertions, deletions, substitutions and swaps of neighbours that turn one word into the other.
int edit_distance(std::string_view from, std::string_view to);

/// The entry of `known` closest to `word`, comparing whole dotted names and last parts ("viscosity" finds
/// "fluid.viscosity"). Empty when `known` is empty.
std::string nearest_name(std::string_view word, const std::vector<std::string>& known);

}  // namespace softwet
