// What a checkpoint holds, read and judged as a whole: no Kokkos, so it can be tested and fuzzed alone.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "observe/host/bodies.hpp"
#include "observe/host/checkpoint_file.hpp"

namespace softwet {

/// Everything a resumed run starts from. Times are on the clock of the computation.
struct SavedRun {
  double time = 0;
  std::vector<std::vector<double>> arrays;  ///< in the order asked for
  double previous_dt = 0;                   ///< 0 before the first step
  double proposed_dt = 0;
  std::int64_t steps = 0, rejected_newton = 0, rejected_error = 0;
  std::int64_t history_step = 0;
  double history_time = 0, mass_start = 0;
  /// Per droplet: centre of the footprint (2D: x; 3D: x, y), on the wall (1) or not, merged (1) or not.
  std::vector<std::vector<double>> droplets;
  /// What checkpoints of older programs have not: empty and 0 there.
  std::vector<Body> bodies;
  std::vector<Event> events;
  double started = 0;          ///< when the run began, seconds since 1970
  std::vector<double> energy;  ///< energy_numbers of them
};

/// Numbers that the balance of the energy remembers.
inline constexpr std::size_t energy_numbers = 11;

/// Name and length of an array of the file.
using ArraySize = std::pair<std::string, std::size_t>;

/// Writes what a run knows of its droplets as wholes.
void write_watch(const std::vector<Body>& bodies, const std::vector<Event>& events, CheckpointWriter& file);

/// Reads a checkpoint of this case. Throws Error (invalid_input) naming the file and the value where something is
/// missing, belongs to another case, or is no state of a computation: not finite, a negative time, step or count.
SavedRun read_saved_run(const std::string& path, const Case&, const std::vector<ArraySize>& arrays);

}  // namespace softwet
