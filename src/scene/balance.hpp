// What a scene has of mass, energy and power: the integrals that history.csv is made of, and what judges a mesh.
#pragma once

#include <array>
#include <functional>
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

  /// From each radian about an axis to the whole turn. What points away from the axis cancels.
  void turn(double angle) {
    integrals.turn(angle);
    load_power *= angle;
    for (NeedleReading& one : needles) {
      for (double* number : {&one.energy, &one.power, &one.power_on_solid, &one.force[1]}) *number *= angle;
      one.force[0] = 0;
    }
  }
};

/// All processes have to call what takes a stage. What it takes has to outlive it.
template <int D, int P>
class Balance {
 public:
  Balance(const Regions<D>&, const Coefficients<D>&, const Forces<D>&, const Terms<D, P>&);
  Balance(const Balance&) = delete;

  /// Starts all that a row takes from a state. It is there when `pending` is finished, and `found` has to stay where it
  /// is until then.
  void start_row(const Stage&, PendingIntegrals& pending, Measured& found) const;
  /// What a row takes from a state, finished.
  Measured measure(const Stage&) const;
  Filling filling(const Stage&) const;
  MeshFaults faults(const Stage&) const;

 private:
  /// Starts kernels, whose numbers are there when the list is finished.
  using Part = std::function<void(const Evaluation<D>&, PendingIntegrals&, Measured&)>;

  /// Adds a functional, with the parts that it names, or with Rate the rate at which the motion of the wall changes it.
  template <class Motion, bool Rate = false, class Functional>
  void add(const Region<D>&, const Functional&, const double* given = nullptr);
  template <class Motion>
  void add_fluid();
  template <class Motion, class Functional>
  void add_wall(const Functional&);
  void start_forces(const Stage&, PendingIntegrals&, Measured&) const;
  void start_branches(const Stage&, PendingIntegrals&, Integrals&) const;
  /// What branches follow, and its rate: the displacement and the velocity, or strains at points.
  void followed_by_branches(const Stage&, const Array& followed, const Array& rate) const;
  /// Integrals of a functional over the moved fluid domain.
  template <class Functional>
  std::array<double, Functional::count> over_fluid(const Functional&, const Stage&) const;

  const Layout<D>& layout_;
  const Regions<D>& regions_;
  const Coefficients<D>& coefficients_;
  const Forces<D>& forces_;
  std::vector<Part> parts_;
};

}  // namespace softwet
