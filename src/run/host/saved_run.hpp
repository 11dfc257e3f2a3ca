// What a checkpoint holds, read and judged as a whole: no Kokkos, so it can be tested and fuzzed alone.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "io/checkpoint_file.hpp"
#include "io/table_file.hpp"
#include "observe/host/bodies.hpp"

namespace softwet {

/// What a run has written beside its checkpoint. Checkpoints of older programs do not tell it.
struct WrittenFiles {
  std::optional<TableMark> history, interface;     ///< rows of history.csv and interface.csv
  std::optional<std::vector<double>> field_times;  ///< t of the field files, in the order of their numbers
};

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
  /// What checkpoints of older programs have not: empty there.
  std::vector<Body> bodies;
  std::vector<Event> events;
  std::optional<double> started;  ///< when the run began, seconds since 1970
  std::vector<double> energy;     ///< energy_numbers of them
  double largest_kinetic_energy = 0;
  WrittenFiles files;
};

/// Numbers that the balance of the energy remembers.
inline constexpr std::size_t energy_numbers = 11;

/// Name and length of an array of the file.
using ArraySize = std::pair<std::string, std::size_t>;

/// Writes what a run knows of its droplets as wholes.
void write_watch(const std::vector<Body>& bodies, const std::vector<Event>& events, CheckpointWriter& file);

/// Writes what a run has written. Nothing of it may be left out.
void write_files(const WrittenFiles& files, CheckpointWriter& file);

/// Reads a checkpoint of this case. Throws Error (invalid_input) naming the file and the value where something is
/// missing, belongs to another case, or is no state of a computation: not finite, a negative time, step or count.
SavedRun read_saved_run(const std::string& path, const Case&, const std::vector<ArraySize>& arrays);

class SavedEntries;

/// What a time scheme remembered at a checkpoint (field/step_memory.hpp), by name. Throws Error (invalid_input) as
/// read_saved_run does.
class SavedMemory {
 public:
  explicit SavedMemory(const std::string& path);
  ~SavedMemory();

  /// Name of the text of the settings with which it was written. It means nothing to others.
  static constexpr const char* settings = "memory/settings";
  /// The name of an entry in the file.
  static std::string name(const std::string& entry) { return "memory/" + entry; }

  /// Whether it was written with these settings. Checkpoints of older programs have none.
  bool fits(const std::string& settings_now) const;
  double number(const std::string& entry) const;
  int count(const std::string& entry) const;
  std::vector<double> array(const std::string& entry, std::size_t size) const;

 private:
  std::unique_ptr<SavedEntries> file_;
};

}  // namespace softwet
