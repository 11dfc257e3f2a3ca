#include "scene/admissible.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/error.hpp"
#include "case/text.hpp"
#include "field/ranks.hpp"

namespace softwet {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Greville point of control value i of the density.
template <int D>
std::array<double, D> place_of(const Layout<D>& l, int i) {
  std::array<double, D> x;
  for (int d = 0; d < D; ++d) {
    const int n = d < D - 1 ? l.extent(d) : l.fluid_rows();
    x[d] = l.axis[d].greville(l.function(i % n, d) + (d == D - 1 ? l.wall_row : 0));
    i /= n;
  }
  return x;
}

/// What one process knows, on all of them.
double told_by(int speaker, double value) { return ranks::largest(ranks::mine() == speaker ? value : -infinite); }

/// Names and amplitudes of the waves on chosen fields: "wave[0].amplitude = 0.3, wave[2].amplitude = 0.1".
template <class Chosen>
std::string waves_on(const Case& c, const Chosen& chosen) {
  std::string names;
  for (std::size_t k = 0; k < c.waves.size(); ++k)
    if (chosen(c.waves[k].field))
      names += (names.empty() ? "wave[" : ", wave[") + std::to_string(k) +
               "].amplitude = " + short_text(c.waves[k].amplitude, 4);
  return names;
}

/// Factor by which the waves would have to be multiplied so that no control value leaves [0, close_packed).
double factor_that_fits(const std::vector<double>& without_waves, const std::vector<double>& density) {
  double factor = 1;
  for (std::size_t i = 0; i < density.size(); ++i) {
    const double wave = density[i] - without_waves[i];
    const double room = wave > 0 ? close_packed - without_waves[i] : without_waves[i];
    if (wave != 0) factor = std::min(factor, room / std::abs(wave));
  }
  return ranks::least(factor);
}

}  // namespace

template <int D>
void require_density(const Case& c, const Layout<D>& layout, const std::vector<double>& without_waves,
                     const std::vector<double>& density) {
  const std::string waves = waves_on(c, [](WaveField field) { return field == WaveField::density; });
  if (waves.empty() && !c.gives_density())
    return;  // droplets and films have densities of the two phases, or between them
  const bool of_a_run = c.initial && c.initial->earlier && !c.initial->density;
  const double least = of_a_run ? -c.solver.newton_undershoot : 0;  // a run may undershoot the vapour's small density
  std::size_t worst = 0;
  double outside = -1;  // of [least, close_packed), by this much
  for (std::size_t i = 0; i < density.size(); ++i) {
    if (density[i] >= least && density[i] < close_packed) continue;
    const double here = std::isfinite(density[i]) ? std::max(least - density[i], density[i] - close_packed) : infinite;
    if (here > outside) outside = here, worst = i;
  }
  const double most = ranks::largest(outside);
  if (most < 0) return;
  const int speaker = static_cast<int>(ranks::least(outside == most ? ranks::mine() : infinite));
  std::string place;
  for (double x : place_of(layout, static_cast<int>(worst)))
    place += (place.empty() ? "" : ", ") + short_text(told_by(speaker, x), 4);
  const std::string bare = short_text(told_by(speaker, without_waves[worst]), 4),
                    value = short_text(told_by(speaker, density[worst]), 4);
  const std::string range = "[" + short_text(least, 4) + ", " + short_text(close_packed, 4) + ")";
  if (waves.empty())
    throw Error(
        Exit::invalid_input,
        std::string(of_a_run ? "initial.from" : "initial.density") + ": the density is " + value + " at (" + place +
            "), where it must lie in " + range +
            (of_a_run ? "; begin from another time of that run (initial.time), or raise solver.newton.undershoot"
                      : "; bound it there, for example with max and min"));
  const double factor = 0.99 * factor_that_fits(without_waves, density);
  throw Error(Exit::invalid_input,
              "the density at the start is " + value + " at (" + place + "), where it must lie in " + range +
                  ": it is " + bare + " there without the waves on the density, which are " + waves +
                  "; multiply these amplitudes by at most " + short_text(factor, 4) + ", or choose other modes");
}

template <int D, int P>
void require_upright(const Case& c, const Layout<D>& layout, const Balance<D, P>& balance, const State& state) {
  const std::string waves = waves_on(c, is_displacement);
  const bool given = c.initial && (!c.initial->displacement.empty() || c.initial->earlier);
  if (waves.empty() && !given) return;
  const MeshFaults faults = balance.faults(stage_at(layout, state));
  if (faults.inverted == 0 && faults.folded == 0) return;
  const std::string what = faults.inverted != 0 ? "turn the solid inside out somewhere (det F <= 0)"
                                                : "fold the mesh of the fluid above the solid (J < 0)";
  if (given)
    throw Error(Exit::invalid_input, "initial" + (waves.empty() ? "" : " with the waves (" + waves + ")") +
                                         ": these displacements " + what +
                                         " at the start; their slopes must stay well below 1: write smaller ones");
  throw Error(Exit::invalid_input, "the waves on the displacement (" + waves + ") " + what +
                                       " at the start; amplitude x mode x pi / size must stay well below 1 along each "
                                       "axis: write smaller amplitudes or modes");
}

template void require_density(const Case&, const Layout<SOFTWET_DIMENSION>&, const std::vector<double>&,
                              const std::vector<double>&);
template void require_upright(const Case&, const Layout<SOFTWET_DIMENSION>&,
                              const Balance<SOFTWET_DIMENSION, SOFTWET_DEGREE>&, const State&);

}  // namespace softwet
