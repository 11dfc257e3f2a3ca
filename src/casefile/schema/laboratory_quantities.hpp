// The quantities of the table [laboratory], once: names, units, and the keys of the case that follow from them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "case/physical.hpp"
#include "casefile/schema/quantity.hpp"

namespace softwet {

struct LaboratoryQuantity {
  const char* name;
  Quantity quantity;
  double PhysicalScene::*place;
  std::vector<std::string> keys;  ///< that follow, by schema name; of a repeated table in its first entry
  const char* example;
  const char* help;

  std::string key() const { return std::string("laboratory.") + name; }
};

/// In the order in which the reference has them. The first three set the scales, and no key follows from them.
const std::vector<LaboratoryQuantity>& laboratory_quantities();
inline constexpr std::size_t quantities_of_scales = 3;

/// Whether a key of the case may follow from a quantity.
bool may_follow(const std::string& key);

}  // namespace softwet
