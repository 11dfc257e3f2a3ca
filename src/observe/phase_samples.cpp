#include "observe/phase_samples.hpp"

#include "observe/section.hpp"

namespace softwet {

template <int D>
PhaseSamples sample_phase(const Snapshot<D>& snapshot, const Surface& surface) {
  PhaseSamples samples;
  samples.dimension = D;
  samples.bubbles = surface.inside == Phase::vapour;
  typename Snapshot<D>::Grid grid;
  for (int d = 0; d < D; ++d) {
    const Axis& axis = snapshot.layout().axis[d];
    const int first = d == D - 1 ? snapshot.layout().solid_elements : 0;
    grid[d] = equidistant(axis.lower(first), axis.length(), axis.equal_parts(first));
    if (axis.periodic()) grid[d].pop_back();
    samples.points[d] = static_cast<int>(grid[d].size());
    samples.periodic[d] = axis.periodic();
    samples.origin[d] = axis.lower(first);
    samples.step[d] = grid[d][1] - grid[d][0];
  }
  if (snapshot.layout().axisymmetric())
    for (int i = 0; i < samples.points[0]; ++i)
      samples.rings.push_back(snapshot.layout().axis[0].weight(samples.origin[0] + samples.step[0] * i));
  samples.depth = surface.depth(snapshot.density(grid));
  return samples;
}

template PhaseSamples sample_phase(const Snapshot<2>&, const Surface&);
template PhaseSamples sample_phase(const Snapshot<3>&, const Surface&);

}  // namespace softwet
