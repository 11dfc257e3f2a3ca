// run.json: what a run was, where it ran, how it stands, and what it cost.
#pragma once

#include "io/run_record.hpp"
#include "run/host/run_status.hpp"
#include "run/restart.hpp"

namespace softwet {

/// run.json without the status: build, machine, case, unknowns, timings, counts, memory.
template <int D, int P>
RunRecord describe_run(const Case&, const Scene<D, P>&, Stepper<D, P>&, const RunSeconds&, long first_step);

}  // namespace softwet
