// What units of a case are in a laboratory: one place that maps the unit of a column or of a key to the one that is shown.
#pragma once

#include <optional>
#include <string>

#include "case/case.hpp"
#include "case/physical.hpp"

namespace softwet {

/// A unit of the laboratory, and how much of it one unit of the case is: {"um", 500} for L0 = 0.5 mm.
struct ShownUnit {
  std::string name;
  double factor;
};

/// The unit in which a laboratory shows what a case gives in `unit`, for example "a b^2 L0^(d-1)". Nothing where that is no
/// product of a, b and L0, as degrees and pure numbers are not.
/// @param dimension  d of the unit
std::optional<ShownUnit> shown_unit(const std::string& unit, int dimension, const Scales&);

/// d in the units of a case: 3 with an axis of symmetry, too.
inline int dimension_of_units(const Case& c) { return c.axisymmetric() ? 3 : c.dimension(); }

/// The unit of each column of the tables of a run, as JSON, and the scales in SI units: the file units.json.
std::string units_record(const Case&, const Scales&);

}  // namespace softwet
