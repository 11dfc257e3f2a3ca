// What the cross checks of a case share: the case, where its values stand, and what is wrong so far.
#pragma once

#include <fmt/core.h>

#include <string>
#include <vector>

#include "casefile/text/document.hpp"

namespace softwet {

constexpr double slack = 1e-9;  ///< lengths closer than this (relative to the domain) are equal

/// Added where a list is twice as long as it should be: [0,5, 1,0] has four numbers.
constexpr const char* decimal_comma = "; decimal numbers have a point, 0.5, for a comma begins the next number";

/// A resolved case together with the places of its keys, for messages.
struct Checker {
  const Case& c;
  const Document& document;
  Problems& problems;

  /// Does a check whose inputs are all right so far.
  template <class Check>
  void with(const std::vector<std::string>& inputs, const Check& check) const {
    for (const std::string& input : inputs)
      if (problems.about(input)) return;
    problems.keep(check);
  }

  [[noreturn]] void refuse(const std::string& key, const std::string& problem, const std::string& remedy) const {
    const auto found = document.entries.find(key);
    if (found != document.entries.end()) reject(found->second.place, key, found->second.text, problem, remedy);
    const auto table = document.table_place.find(key.substr(0, key.find('.')));
    reject(table == document.table_place.end() ? document.place : table->second, key, "", problem, remedy);
  }
  /// Refuses a list that does not have one number for each axis.
  void require_axes(const std::string& key, std::size_t count, const std::string& remedy) const {
    const std::size_t axes = c.domain.size.size();
    if (count == axes) return;
    refuse(key, fmt::format("must be {} numbers, as many as domain.size, not {}", axes, count),
           remedy + (count == 2 * axes ? decimal_comma : ""));
  }
  std::size_t vertical() const { return c.domain.size.size() - 1; }
  double height() const { return c.domain.size.back(); }
  double element_height() const { return height() / c.domain.elements.back(); }
  double interface() const { return c.wall_height(); }
  bool periodic(std::size_t axis) const { return c.boundary.side[axis][0] == Side::periodic; }
};

/// "boundary.left"; the last axis is vertical.
inline const std::string& side_name(std::size_t axis, std::size_t end, std::size_t vertical) {
  static const std::string names[3][2] = {
      {"boundary.left", "boundary.right"}, {"boundary.front", "boundary.back"}, {"boundary.bottom", "boundary.top"}};
  return names[axis == vertical ? 2 : axis][end];
}

/// A box that is given by its corners, inside of [0, top] along each axis. @param place  what it has to lie in
void check_corners(const Checker& check, const std::string& key, const std::vector<double>& lower,
                   const std::vector<double>& upper, const std::vector<double>& top, const char* place);

// The parts of check_case.

/// Size, elements, sides, coordinates. @return whether the axes are known, which all other parts need
bool check_domain(const Checker& check);
/// Droplets, films, waves and the densities of the start.
void check_initial(const Checker& check);
/// What is written and when.
void check_output(const Checker& check);
void check_probes(const Checker& check);
/// A solid that is stretched before the scene begins.
void check_prestretch(const Checker& check);
/// Checks the wall that a fluid wets: its tension, its angles, friction of contact lines.
void check_wall(const Checker& check);
/// Loads and needles.
void check_forces(const Checker& check);

}  // namespace softwet
