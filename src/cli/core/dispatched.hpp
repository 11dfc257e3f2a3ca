// What commands compute, in the configuration of a case. Each has the source of its name.
#pragma once

#include <ostream>
#include <string>

#include "case/case.hpp"

namespace softwet {

/// bench: times residual, products, each term, sums and the preconditioner at the initial state; prints the throughput.
template <int D, int P>
void bench_scene(const Case&, std::ostream&);
/// bench_variants: prints for each form of the preconditioner what a build takes, what an iteration takes, and how many
/// iterations of GMRES a step of 0.1, 1 and 10 takes from the state after `time.max_steps` steps, at most 40.
template <int D, int P>
void compare_preconditioners(const Case&, std::ostream&);
/// first_fields: writes the density of the fluid and the displacement of both materials at the beginning into fields/
/// below `folder`.
template <int D, int P>
void write_first_fields(const Case&, const std::string& folder);

}  // namespace softwet
