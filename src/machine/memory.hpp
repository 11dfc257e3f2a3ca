// The memory of this process: how much a case needs at the very least, how much may still be had, and the refusal.
#pragma once

#include <string>

#include "case/case.hpp"

namespace softwet {

/// Unknowns the solver numbers, ghosts and prescribed ones included: no case of this mesh has more.
///   prod_d (elements_d + 2 p) times (D + 2 with a fluid, D without)
double most_unknowns(const Case&);

/// Bytes below which no run of the case stays, whatever its preconditioner: Krylov basis, states and stage, with
///   prod_d elements_d  control points.
double least_bytes(const Case&);

/// Bytes this process can hold in all: what it holds now and what the system has available, within the limits of the
/// process (ulimit -v) and of its control groups. Infinity where the system gives none.
double bytes_to_be_had();

/// Bytes that the control groups of this process (a container, a job) and those above them still leave, cached files
/// counted as left (Linux, versions 1 and 2). Infinity without a limit.
/// @param root  what stands before /proc and /sys: a folder in tests
double left_by_control_groups(const std::string& root = "");

/// Throws Error (machine_failed) with both amounts when `needed` bytes are more than can be had.
void require_bytes(const Case&, double needed);
/// Refuses a case that needs more than the memory of a device.
void require_device_bytes(const Case&, double needed, double available);

/// "734 MiB", "12.5 GiB".
std::string bytes_text(double bytes);

}  // namespace softwet
