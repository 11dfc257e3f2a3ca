// Mass matrices of a scene, on the same driver as its equations: what explicit schemes have to invert.
#pragma once

#include "kernels/fluid/masses.hpp"
#include "scene/coefficients.hpp"
#include "scene/piece.hpp"

namespace softwet {

/// Vectors have the layout of the unknowns; a product reads and writes the parts that it names and zeroes the rest. The
/// density of the stage is the weight in the fluid, its displacement moves the mesh.
template <int D, int P>
class Masses {
 public:
  Masses(const Regions<D>& regions, const Coefficients<D>& coefficients)
      : regions_(regions), coefficients_(coefficients) {}

  /// Part of the density: out_i = (q_i, z J) on the reference domain. Moments are the product with the density.
  void scalar(const Stage&, const Array& z, const Array& out) const;

  /// Adds this product to `out`, without the mask: prescribed unknowns have values too; the ghosts of z are filled.
  void add_scalar(const Stage&, const Array& z, const Array& out) const;

  /// Velocities: out_i = inertia (w_i, rho z) + (grad w_i, tau(z)) in the fluid, inertia (w_i, rho_0 z) in the solid.
  /// @param inertia    1 for the mass, 0 for the viscous force alone
  /// @param viscosity  in tau
  void velocity(const Stage&, double inertia, double viscosity, const Array& z, const Array& out) const;

 private:
  template <class Motion, class Term>
  void add(const Term&, const Region<D>&, const Evaluation<D>&) const;
  template <class Term>
  void add_fluid(const Term&, const Evaluation<D>&) const;
  /// Adds the values of ghosts to their owners, and zeroes prescribed unknowns.
  void collect(const Array& out) const;

  const Regions<D>& regions_;
  const Coefficients<D>& coefficients_;
};

}  // namespace softwet
