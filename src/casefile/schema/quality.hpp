// The qualities a case can ask for: named sets of values for keys that it leaves out.
#pragma once

#include <string>
#include <vector>

#include "case/choices.hpp"

namespace softwet {

struct QualityValue {
  const char* key;   ///< schema name
  const char* text;  ///< TOML text
};

struct QualityValues {
  Quality quality;
  const char* purpose;
  std::vector<QualityValue> values;  ///< "standard" has none: it is what the defaults are
};

/// Their errors and costs are measured: docs/tradeoff.md.
const std::vector<QualityValues>& qualities();

/// True for the keys that some quality sets.
bool set_by_quality(const std::string& key);

/// Sentences for `explain quality`.
std::string describe_qualities();

}  // namespace softwet
