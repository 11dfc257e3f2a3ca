// The equations of a scene in the parts that explicit schemes evaluate, each in one pass over the elements.
#pragma once

#include "kernels/fluid/explicit_terms.hpp"
#include "scene/coefficients.hpp"
#include "scene/equations.hpp"

namespace softwet {

/// Whether viscosity counts among all else, or is treated apart.
enum class Viscosity { among_all, apart };

/// How often memory that kernels of terms share has moved or has got other contents, where a device has some. Kernels
/// that were recorded before may not be started then.
inline long moves_of_term_memory() { return moves_of_tile_rooms + replaced_copies_of_bytes(); }

/// Parts of the residual, added to a vector with the layout of the unknowns; `collect` or `taken` ends a sum of them.
/// Together they are the residual without the terms of the acceleration and of the moments and without (q, mu). The
/// mask is not applied: prescribed unknowns have values too.
/// Tested: tests/unit/scene/test_explicit_terms.cpp
template <int D, int P>
class ExplicitTerms {
 public:
  ExplicitTerms(const Regions<D>& regions, const Coefficients<D>& coefficients, const Equations<D, P>& equations)
      : regions_(regions), coefficients_(coefficients), equations_(equations), sums_(regions.layout()) {}

  /// The rows of the potential.
  void add_potential(const Stage&, const Array& out) const;
  /// - (grad q, rho (v - vh)).
  void add_mass_flux(const Stage&, const Array& out) const;
  /// (w, rho (grad mu - f)), (grad q, eps (grad mu - f)), the traction on the wall, elasticity and loads.
  /// @param force_numbers  see Forces::add_to_residual
  void add_pressure(const Stage&, const Array& out, const double* force_numbers = nullptr) const;
  /// (w, rho (v - vh).grad v) + (grad w, tau), or without tau.
  void add_convection(const Stage&, Viscosity, const Array& out) const;
  /// The viscosity of the solid.
  void add_viscosity_of_solid(const Stage&, const Array& out) const;
  /// Ends a sum: adds what a device has summed, and sums what ghosts hold.
  void collect(const Array& out) const;
  /// Ends a sum as `collect` does, except on a device without ghosts: there it returns the missing sums, for the kernel
  /// that reads the vector next.
  TileSumsOf<D> taken(const Array& out) const;

 private:
  template <class Motion, class Term>
  void add(const Term&, const Evaluation<D>&) const;
  template <class Term>
  void add_fluid(const Term&, const Evaluation<D>&) const;

  const Regions<D>& regions_;
  const Coefficients<D>& coefficients_;
  const Equations<D, P>& equations_;
  mutable TileSums<D, double> sums_;  ///< of the terms since the last sum ended
};

}  // namespace softwet
