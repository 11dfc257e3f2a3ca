#include "scene/selective.hpp"

#include "kernels/solid/isotropic.hpp"

namespace softwet {
namespace {

/// A part whose energy at rest is 0.
ChosenMaterial part(ElasticLaw law, const LameParameters& stiffness, Prestretch prestretch) {
  prestretch.energy_at_rest = 0;
  ChosenMaterial material{law, stiffness, prestretch};
  if (prestretch.acts)
    material.prestretch.energy_at_rest = prestretch.volume_ratio() * material.energy(Matrix<double, 3>{});
  return material;
}

}  // namespace

SelectiveMaterials selective_materials(ElasticLaw law, const LameParameters& whole, const Prestretch& prestretch) {
  const SelectiveParts parts = SelectiveParts::of(whole);
  SelectiveMaterials materials{part(law, parts.everywhere, prestretch), part(law, parts.of_means, prestretch)};
  if (!prestretch.acts) return materials;
  const Matrix<double, 3> at_rest = materials.of_means.first_piola(Matrix<double, 3>{});
  for (int i = 0; i < 3; ++i) {
    materials.everywhere.carried[i] = at_rest(i, i);
    materials.of_means.carried[i] = -at_rest(i, i);
  }
  return materials;
}

}  // namespace softwet
