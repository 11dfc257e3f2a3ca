// From a TOML node to a Value of the kind a key asks for. Only the sources of this room see the TOML library.
#pragma once

#include <optional>
#include <string>

#include "casefile/schema/schema.hpp"
#include "casefile/text/toml_reader.hpp"

namespace softwet {

/// The node as one line of TOML, for messages.
std::string text_of_node(const toml::node& node);

/// The node's value when it has the key's kind (numbers also as "1/256"), nothing otherwise. No range check.
std::optional<Value> value_of_node(const toml::node& node, Kind kind);

}  // namespace softwet
