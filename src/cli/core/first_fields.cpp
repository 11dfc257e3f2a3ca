#include "cli/core/dispatched.hpp"

#include "observe/output_fields.hpp"
#include "run/host/run_status.hpp"
#include "scene/initial.hpp"

namespace softwet {

template <int D, int P>
void write_first_fields(const Case& c, const std::string& folder) {
  const Scene<D, P> scene(c);
  const State state = initial_state<D, P>(c, scene);
  const Snapshot<D> snapshot(scene.layout(), state);
  write_field_files(folder, origin_of(c), {"density", "displacement"}, c, scene.coefficients(), snapshot,
                    {c.run_start() - c.clock_zero()});
}

template void write_first_fields<SOFTWET_DIMENSION, SOFTWET_DEGREE>(const Case&, const std::string&);

}  // namespace softwet
