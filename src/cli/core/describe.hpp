// What `softwet check` prints of a case.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace softwet {

struct Line {
  std::string name, value;
};

/// A title and indented lines below it, their values in one column.
void print_section(std::ostream& out, const std::string& title, const std::vector<Line>& lines);

/// Stiffness, equilibrium, dimensionless groups, time scales and both clocks: what needs no mesh.
void describe_scene(const Case&, std::ostream&);

/// Terms in play, unknowns per field, memory by part, limits of explicit steps, kernel.
template <int D, int P>
void describe_discretisation(const Case&, std::ostream&);

}  // namespace softwet
