// What a scene has of mass, energy and power: the integrals that history.csv is made of, and what judges a mesh.
#pragma once

#include <array>
#include <vector>

#include "scene/coefficients.hpp"
#include "scene/forces.hpp"
#include "scene/integrals.hpp"
#include "scene/regions.hpp"
#include "scene/terms.hpp"

namespace softwet {

/// Mass and volume of the fluid, as the moments of the density have them: in the coordinates (r, z) those for each
/// radian.
struct Filling {
  double mass = 0, volume = 0;
};
/// Volumes of the fluid's mesh and of the solid that are turned inside out.
struct MeshFaults {
  double folded = 0, inverted = 0;
};

/// What a row of history.csv takes from a scene.
struct Measured {
  Integrals integrals;
  double load_power = 0;               ///< of the loads on the velocity of the state
  std::vector<NeedleReading> needles;  ///< of the whole scene
};

/// All processes have to call what takes a stage. What it takes has to outlive it.
template <int D, int P>
class Balance {
 public:
  Balance(const Regions<D>&, const Coefficients<D>&, const Forces<D>&, const Terms<D, P>&);

  /// Starts all that a row takes from a state. It is there when `pending` is finished, and `found` has to stay where it
  /// is until then.
  void start_row(const Stage&, PendingIntegrals& pending, Measured& found) const;
  Integrals integrals(const Stage&) const;
  Filling filling(const Stage&) const;
  MeshFaults faults(const Stage&) const;
  /// Power of the loads on a velocity field at a time.
  double load_power(double time, const ConstArray& unknown) const;
  /// What each needle measures of a state, of the whole scene.
  std::vector<NeedleReading> needle_readings(const Stage&) const;

 private:
  // These start kernels, whose numbers are there when the list is finished.
  void start_integrals(const Stage&, PendingIntegrals&, Integrals&, const std::vector<NeedleReading>&) const;
  void start_load_power(double time, const ConstArray& unknown, PendingIntegrals&, double& power) const;
  void start_readings(const Stage&, PendingIntegrals&, std::vector<NeedleReading>&) const;
  template <class Motion>
  void fluid_integrals(const Evaluation<D>&, PendingIntegrals&, Integrals&) const;
  template <class Motion, class Functional>
  void wall_integrals(const Functional&, Evaluation<D>, PendingIntegrals&, Integrals&) const;
  void solid_integrals(const Evaluation<D>&, PendingIntegrals&, Integrals&) const;
  void branch_integrals(const Stage&, PendingIntegrals&, Integrals&) const;
  /// What branches follow, and its rate: the displacement and the velocity, or strains at points.
  void followed_by_branches(const Stage&, const Array& followed, const Array& rate) const;
  /// Integrals of a functional over the moved fluid domain.
  template <class Functional>
  std::array<double, Functional::count> over_fluid(const Functional&, const Stage&) const;

  const Layout<D>& layout_;
  const Regions<D>& regions_;
  const Coefficients<D>& coefficients_;
  const Forces<D>& forces_;
  const Terms<D, P>& terms_;
};

}  // namespace softwet
