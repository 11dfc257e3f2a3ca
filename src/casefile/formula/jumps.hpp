// Where a number along the wall jumps.
#pragma once

#include <array>
#include <optional>

#include "case/case.hpp"

namespace softwet {

/// A position on the wall at which a profile changes within a thousandth of an element, and by how much.
struct Jump {
  std::array<double, 3> place;
  double height;
};

/// The largest jump that lines along the wall show, one of 1 or more; none where the profile is smooth.
std::optional<Jump> jump_along_wall(const Case&, const Profile&);

}  // namespace softwet
