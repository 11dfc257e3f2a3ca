// The numbers of a case that may vary: from their texts to formulas, and whether their values are allowed.
#pragma once

#include <string>
#include <vector>

#include "casefile/text/document.hpp"

namespace softwet {

/// Whether tables are read, or left alone with what depends on them: their files may be gone.
enum class Tables { read, leave };

/// Gives each profile of a case that has a text its formula: an expression, or a table whose path is relative to the
/// folder of the case and becomes an absolute one. An expression without variables becomes a number, and keeps its
/// text. Smallest and largest value are set, from the corners and the middles of the elements (of many elements, from
/// fewer points). Values that are not finite or out of the range of the key are refused with their position.
void build_profiles(Case&, const Document&, Problems&, Tables);

/// The values of a profile that varies.
struct ProfileRange {
  std::string key;  ///< indexed name, "load[0].factor"; of a list with the number, "initial.velocity, x"
  double least, most;
  std::string over;  ///< "over the layer"
};
std::vector<ProfileRange> profile_ranges(const Case&);

/// Values of the profiles that vary in space, at points over their part of the scene, as JSON: a list "profiles" with
/// the "key" (as in ProfileRange), the "unit", the "axes" (positions along each) and the "values", those along the
/// first axis next to each other.
std::string profile_samples(const Case&);

/// What `explain` says of a key that is a profile: the names that its expressions may use, and how a table looks.
std::string profile_text(const Key&);

/// The case with texts that tell tables apart by their values in place of their paths.
Case with_identities(const Case&);

}  // namespace softwet
