// The droplets, bubbles and films of a case as wholes, and what happened to them. Plain data.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace softwet {

/// Something that happened during a run.
struct Event {
  double time = 0;   ///< t, on the clock of the output
  std::string what;  ///< a sentence without its time: "the droplet vanished"
};

/// Bits of `Body::touched`: first the sides of the domain, 2 axis + (0: low, 1: high), then the ends of the fine
/// elements in the same order.
inline constexpr unsigned bits_of_sides = 6, first_bit_of_fine_ends = 8;
inline constexpr unsigned all_touched = ((1U << bits_of_sides) - 1) * (1 + (1U << first_bit_of_fine_ends));

/// A droplet, bubble or film of the case, from row to row of history.csv.
struct Body {
  std::array<double, 3> place{};  ///< reference point deep inside when last seen; before that, of the case
  unsigned touched = 0;           ///< sides and ends of fine elements that it has ever reached
  bool seen = false;              ///< a row has looked at it
  bool on_wall = false;           ///< in the last row
  bool left_wall = false;         ///< it was said that it lost its contact line
  bool gone = false;              ///< vanished, or merged into another body
};

/// The bodies of a case before its first row: droplets (bubbles), then films. Films among bubbles are ambient. The
/// place of a film is the middle of its box, moved into the domain.
std::vector<Body> bodies_of(const Case&);

/// Names of the bodies: "the droplet", "droplet 2", "the film".
std::vector<std::string> body_names(const Case&);

}  // namespace softwet
