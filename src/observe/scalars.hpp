// The columns of history.csv: integrals of the state, extremes, and the contact lines of each droplet, bubble and film.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "observe/contacts.hpp"
#include "observe/extremes.hpp"
#include "observe/host/history_memory.hpp"
#include "observe/phase_samples.hpp"
#include "scene/balance.hpp"
#include "scene/scene.hpp"
#include "time/stepper.hpp"

namespace softwet {

/// What a row needs of a state, as numbers of the host: they stay while the state changes.
template <int D>
struct RowReading {
  long step;
  double time;
  StepReport report;
  Measured measured;
  Extremes extremes;
  Snapshot<D> snapshot;
};

template <int D, int P>
class Scalars {
 public:
  Scalars(const Case& c, const Scene<D, P>& scene);

  /// The columns of history.csv in their order.
  std::vector<std::string> columns() const;

  /// Reads what a row needs. `end` is the stage at the state itself. All processes have to call it.
  RowReading<D> read(long step, const StepReport& report, const State& state, const Stage& end);
  /// One row. A cell is empty where its quantity does not exist: densities without a fluid, the contact line of a
  /// droplet that is not on the wall. The first process gets the row, and it alone follows the droplets from row to
  /// row. The others get a row without cells. Only the host does this work, so a thread may do it during the next
  /// steps.
  TableRow row_of(const RowReading<D>&);

  /// Follows the droplets to a state for which there is no row, before the first row: `told` stands behind the sentence
  /// of each event. All processes have to call it.
  void watch(const State& state, const std::string& told);
  /// How far each body has moved between the first and the last state that was watched; empty where it is gone.
  std::vector<std::optional<double>> moved() const;

  /// Makes the row evaluated last the reference of the next velocities.
  void keep() { memory_ = latest_; }

  const HistoryMemory& memory() const { return memory_; }
  /// Goes on behind a row of an earlier process.
  void restore(const HistoryMemory& memory);
  /// Events of the droplets up to the row evaluated last.
  const std::vector<Event>& events() const { return latest_.events; }

 private:
  /// Sets the cell of a column, empty where the scene lacks what the column needs.
  void set(const std::string& column, double value, TableRow&) const;
  void set_integrals(const Integrals&, TableRow&) const;
  void set_needles(const std::vector<NeedleReading>&, TableRow&) const;
  void set_extremes(const Extremes&, TableRow&) const;
  void set_droplets(const Snapshot<D>&, long step, TableRow&);
  PhaseSamples follow_bodies(const Snapshot<D>&, const std::string& told = "");
  /// Reports when the energy rises though nothing feeds it.
  void follow_energy(const EnergyState&);
  Surface surface() const;
  double laplace_pressure(const Snapshot<D>&) const;

  const Case& case_;
  const Scene<D, P>& scene_;
  HistoryMemory memory_, latest_;
  SnapshotCopies<D> copies_;                    ///< for the next row
  std::vector<Centre> first_seen_, last_seen_;  ///< by `watch`
  PhaseSamples watched_;                        ///< the last of its samples
};

}  // namespace softwet
