// The two materials of a solid whose stiffness against changes of volume is integrated in parts (host).
#pragma once

#include "kernels/solid/graded.hpp"

namespace softwet {

/// Their energies and stresses add up to the energy and stress of the law with its prestretch (SelectiveParts). Where
/// the displacement is 0, each part has no energy, and means have no stress: `everywhere` carries their stress, so that
/// a stretched layer is at rest where the full law is, whatever the mesh and however the stiffness varies.
struct SelectiveMaterials {
  ChosenMaterial everywhere, of_means;

  bool has_means() const { return of_means.stiffness.lambda > 0; }
};

/// Tested: tests/unit/scene/test_selective.cpp
SelectiveMaterials selective_materials(ElasticLaw, const LameParameters& whole, const Prestretch&);

}  // namespace softwet
