// What a user may have meant by a name that no key and no table has.
#pragma once

#include <string>
#include <vector>

namespace softwet {

struct Suggestion {
  std::string name;      ///< the key or table that is meant, by its name in the schema; empty where none is near
  std::string sentence;  ///< the question or the list for the message
};

/// @param name   dotted, "fluid.viscosty", "load[].forc", "fluids"
/// @param others  other names than keys and tables, which may be meant too
Suggestion suggest(const std::string& name, const std::vector<std::string>& others = {});

}  // namespace softwet
