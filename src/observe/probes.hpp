// The numbers that the probes of a case add to a row of history.csv.
#pragma once

#include <vector>

#include "case/case.hpp"
#include "observe/snapshot.hpp"
#include "scene/coefficients.hpp"

namespace softwet {

/// The number of each probe, in the order of the case. Integrals have the Gauss points of the scene in each element, or
/// part of one, that the box holds: the integral of the density over all of the fluid is the mass.
template <int D>
std::vector<double> evaluate_probes(const Case&, const Regions<D>&, const Coefficients<D>&, const Snapshot<D>&);

}  // namespace softwet
