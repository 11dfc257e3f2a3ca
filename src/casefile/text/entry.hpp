// One value of a case file, checked against its key.
#pragma once

#include <string>

#include "casefile/text/document.hpp"
#include "casefile/text/toml_value.hpp"

namespace softwet {

/// The entry of a key, of its table number `index` where that is repeated. @param place  where the value stands
/// Throws CaseError where the value has another type, lies out of range or is not a choice of the key.
Entry make_entry(const Key&, std::size_t index, const toml::node&, const std::string& place);

}  // namespace softwet
