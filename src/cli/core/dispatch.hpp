// From a validated case (run time) to a compiled configuration (compile time), once.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "case/physical.hpp"
#include "casefile/case_file.hpp"
#include "run/host/options.hpp"

namespace softwet {

/// Computes the case and writes the output folder. Throws Error.
void run_case(const Case&, const RunOptions&);

/// Prints what a case means (stiffness, groups, clock) and what it takes (terms, unknowns, memory, step limits, kernel).
/// A case too large for this machine is described too. Throws Error.
void describe_case(const Case&, std::ostream&);

/// Writes the fields of the first state into fields/ of a folder that exists: density and displacement, at the time with
/// which the computation begins. With time.start = "equilibrium" it is the state before the scene comes to rest. Throws Error.
void write_first_state(const Case&, const std::string& folder);

/// Steps of kick_drift to the end of a case, and up to how many of them are cheaper than implicit ones.
struct StepsForeseen {
  double steps, most;
};
StepsForeseen foresee_steps(const Case&);

/// What is likely to go wrong with a case, a sentence each.
std::vector<std::string> forecast_case(const Case&);

/// A sentence where the interface is too wide for the numbers at its contact line; empty where it is not.
std::string judge_width(const Case&);

/// Prints what physical numbers are in a case, and the other way round, or writes a case of them. Throws Error.
void convert_units(const PhysicalScene&, const WrittenCase&, std::ostream&);

/// The case of a droplet of water on a soft gel, with a table [laboratory]. Throws Error when no case can have the name.
std::string gel_case(const std::string& name);

/// How the quantities of a table [laboratory] become numbers of a case.
Conversion conversion_of_quantities();

/// Prints what the numbers of a case are in the laboratory.
void print_laboratory(const Scales&, const Case&, std::ostream&);

/// Measures residuals, products and preconditioner of a case and prints throughput, or compares preconditioners. Throws
/// Error.
void bench_case(const Case&, const RunOptions&, std::ostream&);

/// The configuration that a case needs, and whether this build has it: "3x2 built", "rz2 missing".
std::string configuration_line(const Case&);

/// Prints version, commit, backend, threads, instruction set and the compiled configurations.
void describe_build(std::ostream&);

}  // namespace softwet
