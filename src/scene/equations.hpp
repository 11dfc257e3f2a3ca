// The discrete equations of a scene: residual, products with the Jacobian, and its matrix.
#pragma once

#include <functional>

#include "case/precision.hpp"
#include "field/ghosts.hpp"
#include "scene/forces.hpp"
#include "scene/regions.hpp"
#include "scene/terms.hpp"

namespace softwet {

/// The regions, the forces and the terms have to outlive it.
template <int D, int P>
class Equations {
 public:
  Equations(const Regions<D>&, const Forces<D>&, const Terms<D, P>&, Precision);

  Precision precision() const { return precision_; }  ///< of the computation that evaluates them

  /// Adds a source to the discrete equations: residual() calls source(t_{n+af}, out), which subtracts its load vector.
  /// For manufactured solutions (tests/verification/mms); production never sets it.
  void set_source(std::function<void(double time, const Array& out)> source) { source_ = std::move(source); }

  bool has_source() const { return static_cast<bool>(source_); }

  /// out = R(stage), zero where a value is prescribed.
  void residual(const Stage&, const Array& out) const;
  /// The terms of the fluid alone, before prescribed values are dropped, with the wall traction also on a rigid wall.
  /// The rows of the wall hold minus the force of the fluid on the wall.
  void fluid_residual(const Stage&, const Array& out) const;
  // Parts of a residual that are added to `out` and to the sums of a device, before ghosts are summed.
  /// The rows of the potential equation without (q, mu), so that M mu = -out. Other rows mean nothing.
  void add_potential(const Stage&, TileSums<D, double>&, const Array& out) const;
  /// The solid without its viscosity, the forces of the fluid on the wall, loads and the source. The acceleration of the stage counts as
  /// it is. @param force_numbers  see Forces::add_to_residual
  void add_forces_of_solid(const Stage&, TileSums<D, double>&, const Array& out,
                           const double* force_numbers = nullptr) const;
  /// The viscosity of the solid and the dashpots below it, where it has some. They are linear in the velocities of the stage.
  void add_viscosity_of_solid(const Stage&, TileSums<D, double>&, const Array& out) const;
  bool has_viscous_solid() const { return pieces_.first_viscous < pieces_.first_of_fluid; }
  /// out = dR/d(unknown) direction, exact with the mesh moving along or with the geometry frozen. The direction is zero where
  /// values are prescribed. Its ghosts, where there are some, are filled for the product and then set to zero again.
  /// @param unbalanced  where it is given, with what LineFrictionBend adds: of the rows of the potential, for each area of the wall
  void product(const Stage&, const Array& direction, const Array& out, Geometry,
               const ConstArray& unbalanced = {}) const;

  /// The product in single precision.
  void product(const StageOf<float>&, const ArrayOf<float>& direction, const ArrayOf<float>& out, Geometry,
               const ConstArrayOf<float>& unbalanced = {}) const;

  /// values = dR/d(unknown) with the geometry frozen, and always with the traction of one layer. Prescribed values count
  /// as free here, and rows of ghosts are empty.
  void jacobian(const StageOf<float>&, const StencilValues& values) const;

 private:
  template <class Real>
  void run_product(const Pieces<D, Real>&, const StageOf<Real>&, const ArrayOf<Real>& direction,
                   const ArrayOf<Real>& out, Geometry, const ConstArrayOf<Real>& unbalanced) const;
  /// What follows the terms in a residual: loads, needles, the source, ghosts, and prescribed values.
  void finish_residual(const Stage&, const Array& out) const;

  const Layout<D>& layout_;
  ConstArray mask_;
  const Forces<D>& forces_;
  const Pieces<D, double>& pieces_;
  const Pieces<D, float>& single_;
  Precision precision_;
  std::function<void(double, const Array&)> source_;
};

}  // namespace softwet
