#include "observe/scalars.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "case/cap.hpp"
#include "case/mesh.hpp"
#include "case/text.hpp"
#include "field/ranks.hpp"
#include "io/output_time.hpp"
#include "observe/host/probe_quantity.hpp"
#include "observe/host/table_columns.hpp"
#include "observe/probes.hpp"

namespace softwet {
namespace {

std::string energy_sentence(double rise, bool law, bool implicit) {
  return "the energy rose by " + short_text(rise, 2) + " though nothing fed it" +
         (law ? "" : ", by more than the wall law \"gradient\" does") + ": the steps may be too long; a smaller " +
         (implicit ? "time.tolerance" : "time.safety") + " makes them shorter";
}

/// The energy of a state of a scene, and its powers. Springs of needles count as forces from outside, without their
/// energy: a needle that jumps does no work on the solid in no time.
/// @param load_power  of the loads, and of such springs, on the state's velocities
EnergyState energy_of(double time, double load_power, const Integrals& sum) {
  return {.time = time,
          .energy = sum.energy() - sum["energy_needle"],
          .size = sum.size(),
          .kinetic = sum["energy_kinetic"],
          .fed = load_power + sum["wall_stretch"],
          .lost = sum.dissipation()};
}

/// Whether a body, a droplet or one of the films behind the droplets, begins on the wall.
bool begins_on_wall(const Case& c, std::size_t body) {
  if (body < c.droplets.size()) return sits_on_wall(c, c.droplets[body]);
  const double wall = c.wall_height();
  return c.films[body - c.droplets.size()].lower.back() <= wall + 1e-9 * c.domain.size.back();
}

}  // namespace

template <int D, int P>
Scalars<D, P>::Scalars(const Case& c, const Scene<D, P>& scene) : case_(c), scene_(scene) {
  memory_.bodies = bodies_of(c);
  for (std::size_t k = 0; k < memory_.bodies.size(); ++k) {
    const std::array<double, 3>& place = memory_.bodies[k].place;
    memory_.droplets.push_back({{place[0], D == 3 ? place[1] : 0}, begins_on_wall(c, k), false});
  }
  latest_ = memory_;
}

template <int D, int P>
void Scalars<D, P>::restore(const HistoryMemory& memory) {
  memory_ = memory;
  latest_ = memory_;
}

template <int D, int P>
Surface Scalars<D, P>::surface() const {
  const Coexistence& phases = scene_.coefficients().coexistence();
  const double middle = 0.5 * (phases.density_liquid + phases.density_vapour);
  return {middle, case_.fluid->ambient == Phase::liquid ? Phase::vapour : Phase::liquid};
}

template <int D, int P>
std::vector<std::string> Scalars<D, P>::columns() const {
  std::vector<std::string> names =
      history_names(D, case_.droplets.size(), memory_.bodies.size() - case_.droplets.size(), case_.needles.size());
  for (const Probe& probe : case_.probes) names.push_back(probe.name);
  return names;
}

template <int D, int P>
void Scalars<D, P>::set(const std::string& column, double value, TableRow& row) const {
  const Needs needs = history_column(column).needs;
  const Layout<D>& layout = scene_.layout();
  const bool exists = needs == Needs::fluid ? layout.has_fluid : needs == Needs::solid ? layout.has_solid : true;
  row.set(column, exists ? TableRow::Cell(value) : std::nullopt);
}

template <int D, int P>
void Scalars<D, P>::set_integrals(const Integrals& sum, TableRow& row) const {
  for (const std::string& column : history_names(D, 0, 0, case_.needles.size()))
    if (Integrals::has(column)) set(column, sum[column], row);
  set("energy_total", sum.energy(), row);
  set("mass_drift", sum["mass"] / latest_.mass_start - 1, row);
}

template <int D, int P>
void Scalars<D, P>::set_needles(const std::vector<NeedleReading>& needles, TableRow& row) const {
  double power = 0;
  for (const NeedleReading& needle : needles) power += needle.power;
  if (!needles.empty()) row.set("power_needle", power);
  for (std::size_t k = 0; k < needles.size(); ++k)
    for (int d = 0; d < D; ++d)
      row.set(std::string("needle_force_") + "xyz"[d] + ending_of_body(k), needles[k].force[d]);
}

template <int D, int P>
void Scalars<D, P>::follow_energy(const EnergyState& state) {
  const bool law = case_.has_energy_law(), implicit = case_.time.implicit();
  const EnergyRule& rule = !case_.keeps_shown_energy() ? with_other_masses : law ? with_energy_law : without_energy_law;
  const double rise = latest_.energy.follow(state, rule);
  if (rise > 0)
    latest_.events.push_back({output_time(state.time, case_.clock_zero()), energy_sentence(rise, law, implicit)});
}

template <int D, int P>
void Scalars<D, P>::set_extremes(const Extremes& found, TableRow& row) const {
  set("rho_min", found.density_min, row);
  set("rho_max", found.density_max, row);
  set("speed_max_fluid", found.speed_fluid, row);
  set("speed_max_solid", found.speed_solid, row);
  set("speed_max_liquid", found.speed_liquid, row);
}

template <int D, int P>
void Scalars<D, P>::set_droplets(const Snapshot<D>& snapshot, long step, TableRow& row) {
  std::vector<Contact> found;
  if (!latest_.droplets.empty() && scene_.regions().has_wall())
    found = find_contacts(snapshot, surface(), scene_.coefficients().fluid().capillarity, case_.track());
  const std::vector<int> of_droplet = assign_contacts(found, latest_.droplets);
  const double interval = latest_.time - memory_.time;
  for (std::size_t k = 0; k < of_droplet.size(); ++k) {
    DropletTrack& track = latest_.droplets[k];
    const bool was_on_wall = track.on_wall;
    track.on_wall = of_droplet[k] >= 0;
    if (!track.on_wall) {
      for (const std::string& name : contact_names(D)) row.set(name + ending_of_body(k), std::nullopt);
      continue;
    }
    const Contact& contact = found[of_droplet[k]];
    TableRow::Cell velocity;
    if (step > 0 && was_on_wall && interval > 0)
      velocity = advance(scene_.layout(), track.centre, contact.centre, case_.track()) / interval;
    track.centre = contact.centre;
    row.set("velocity" + ending_of_body(k), velocity);
    row.add(contact.cells, ending_of_body(k));
  }
}

template <int D, int P>
PhaseSamples Scalars<D, P>::follow_bodies(const Snapshot<D>& snapshot, const std::string& told) {
  if (latest_.bodies.empty()) return {};
  PhaseSamples samples = sample_phase(snapshot, surface());
  for (int d = 0; d < D; ++d) {
    const FinePart fine = fine_part(case_, d);
    const double margin = (d == D - 1 ? least_fine_margin_above : least_fine_margin) * case_.fluid->capillarity;
    samples.low[d] = d == D - 1 ? samples.low[d] : fine.low + margin;  // below a droplet is the wall
    samples.high[d] = fine.high - margin;
  }
  for (const std::string& what : follow(latest_.bodies, samples, body_names(case_)))
    latest_.events.push_back({output_time(latest_.time, case_.clock_zero()), what + told});
  return samples;
}

template <int D, int P>
void Scalars<D, P>::watch(const State& state, const std::string& told) {
  const Snapshot<D> snapshot(scene_.layout(), state, SnapshotOf::all_but_velocity);
  if (!ranks::root()) return;
  latest_ = memory_;
  latest_.time = state.time;
  TableRow unused;
  set_droplets(snapshot, 0, unused);
  watched_ = follow_bodies(snapshot, told);
  if (!latest_.bodies.empty()) last_seen_ = centres_of(latest_.bodies, watched_);
  if (first_seen_.empty()) first_seen_ = last_seen_;
  keep();
}

template <int D, int P>
std::vector<std::optional<double>> Scalars<D, P>::moved() const {
  return distances(first_seen_, last_seen_, watched_);
}

template <int D, int P>
double Scalars<D, P>::laplace_pressure(const Snapshot<D>& snapshot) const {
  const Droplet& droplet = case_.droplets[0];
  typename Snapshot<D>::Grid at;
  for (int d = 0; d < D; ++d) at[d] = {droplet.centre[d]};
  for (int d = 0; d < D - 1; ++d) at[d] = {latest_.droplets[0].centre[d]};
  if (sits_on_wall(case_, droplet))  // a cap: half its height
    at[D - 1][0] += 0.5 * droplet.radius * (1 - cap_cosine(case_, droplet));
  return snapshot.chemical_potential(at)[0] - scene_.coefficients().coexistence().potential;
}

template <int D, int P>
RowReading<D> Scalars<D, P>::read(long step, const StepReport& report, const State& state, const Stage& end) {
  const Layout<D>& layout = scene_.layout();
  Measured measured;
  Extremes extremes;
  PendingIntegrals pending;
  start_extremes(layout, state, layout.has_fluid ? surface().level : 0, pending, extremes);
  scene_.balance().start_row(end, pending, measured);
  copies_.start(layout, state, probes_need_velocity(case_) ? SnapshotOf::all_fields : SnapshotOf::all_but_velocity);
  pending.finish();
  return {step, state.time, report, std::move(measured), extremes, Snapshot<D>(layout, copies_)};
}

template <int D, int P>
TableRow Scalars<D, P>::row_of(const RowReading<D>& reading) {
  if (!ranks::root()) return {};
  const auto& [sum, load_power, needles] = reading.measured;
  const Snapshot<D>& snapshot = reading.snapshot;
  latest_ = memory_;
  latest_.step = reading.step;
  latest_.time = reading.time;
  if (reading.step == 0) latest_.mass_start = sum["mass"];
  double from_outside = load_power;
  for (const NeedleReading& needle : needles) from_outside += needle.power_on_solid;
  follow_energy(energy_of(latest_.time, from_outside, sum));
  TableRow row{{"step", reading.step},
               {"t", output_time(reading.time, case_.clock_zero())},
               {"dt", reading.report.dt},
               {"newton", reading.report.newton},
               {"krylov", reading.report.krylov}};
  set_integrals(sum, row);
  set("power_load", load_power, row);
  set_needles(needles, row);
  set_extremes(reading.extremes, row);
  set_droplets(snapshot, reading.step, row);
  follow_bodies(snapshot);
  if (!case_.droplets.empty()) set("laplace", laplace_pressure(snapshot), row);
  const std::vector<double> probed = evaluate_probes(case_, scene_.regions(), scene_.coefficients(), snapshot);
  for (std::size_t i = 0; i < probed.size(); ++i) row.set(case_.probes[i].name, probed[i]);
  return row;
}

template class Scalars<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
