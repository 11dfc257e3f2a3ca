// The equations of a scene in the parts that explicit schemes evaluate, each in one pass over the elements.
#pragma once

#include "kernels/fluid/explicit_terms.hpp"
#include "scene/coefficients.hpp"
#include "scene/equations.hpp"

namespace softwet {

/// Parts of the residual, added to a vector with the layout of the unknowns; `collect` ends a sum of them. All together, and
/// `Equations::potential_moments`, they are the residual without the terms of the acceleration and of the moments, and without its
/// mask: what is prescribed has values too.
/// Tested: tests/unit/scene/test_explicit_terms.cpp
template <int D, int P>
class ExplicitTerms {
 public:
  ExplicitTerms(const Regions<D>& regions, const Coefficients<D>& coefficients, const Equations<D, P>& equations)
      : regions_(regions), coefficients_(coefficients), equations_(equations) {}

  /// - (grad q, rho (v - vh)).
  void add_mass_flux(const Stage&, const Array& out) const;
  /// (w, rho (grad mu - f)), (grad q, eps (grad mu - f)), the traction on the wall, elasticity and loads.
  void add_pressure(const Stage&, const Array& out) const;
  /// (w, rho (v - vh).grad v) + (grad w, tau)
  /// @param viscous  false: without tau
  void add_convection(const Stage&, bool viscous, const Array& out) const;
  /// Sums what ghosts hold.
  void collect(const Array& out) const;

 private:
  template <class Motion, class Term>
  void add(const Term&, const Evaluation<D>&) const;
  template <class Term>
  void add_fluid(const Term&, const Evaluation<D>&) const;

  const Regions<D>& regions_;
  const Coefficients<D>& coefficients_;
  const Equations<D, P>& equations_;
};

}  // namespace softwet
