// The manual page softwet(1).
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace softwet {

/// The manual page in roff: commands and options of `app`, keys of a case from the schema.
std::string manual_page(const CLI::App& app);

}  // namespace softwet
