#include "observe/phase_samples.hpp"

#include "observe/section.hpp"

namespace softwet {

template <int D>
PhaseSamples sample_phase(const Snapshot<D>& snapshot, double middle, Phase ambient) {
  PhaseSamples samples;
  samples.dimension = D;
  samples.bubbles = ambient == Phase::liquid;
  typename Snapshot<D>::Grid grid;
  for (int d = 0; d < D; ++d) {
    const Axis& axis = snapshot.layout().axis[d];
    const int first = d == D - 1 ? snapshot.layout().solid_elements : 0;
    grid[d] = equidistant(axis.lower(first), axis.length(), axis.elements() - first);
    if (axis.periodic()) grid[d].pop_back();
    samples.points[d] = static_cast<int>(grid[d].size());
    samples.periodic[d] = axis.periodic();
    samples.origin[d] = axis.lower(first);
    samples.step[d] = axis.spacing();
  }
  for (double density : snapshot.density(grid)) samples.inside.push_back((density >= middle) != samples.bubbles);
  return samples;
}

template PhaseSamples sample_phase(const Snapshot<2>&, double, Phase);
template PhaseSamples sample_phase(const Snapshot<3>&, double, Phase);

}  // namespace softwet
