// The command `softwet units` on the command line.
#pragma once

#include "case/physical.hpp"

namespace CLI {
class App;
}

namespace softwet {

/// Adds the command; `scene` and `written` outlive `app`.
void add_units_command(CLI::App& app, PhysicalScene& scene, WrittenCase& written);

}  // namespace softwet
