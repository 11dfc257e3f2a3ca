// How the list of terms of a scene is made, for the sources that compile it in one precision each.
#pragma once

#include "kernels/fluid/stretched_wall.hpp"
#include "kernels/solid/branches.hpp"
#include "kernels/solid/graded.hpp"
#include "kernels/solid/surface_elasticity.hpp"
#include "kernels/solid/surface_tension.hpp"
#include "scene/coefficients.hpp"
#include "scene/pieces.hpp"
#include "scene/regions.hpp"
#include "scene/selective.hpp"

namespace softwet {

/// A term in the coordinates of a scene.
template <class Term, bool Axial>
using InCoordinates = std::conditional_t<Axial, Axisymmetric<Term>, Term>;

template <int D, int P, class Real, bool Axial = false>
class PieceMaker {
 public:
  PieceMaker(const Regions<D>& regions, const Coefficients<D>& coefficients, const Case& c)
      : regions_(regions),
        fluid_(coefficients.fluid()),
        wall_(coefficients.wall()),
        solid_(coefficients.solid()),
        case_(c) {}

  Pieces<D, Real> make() {
    const Layout<D>& layout = regions_.layout();
    if (layout.has_solid) add_solid(*case_.substrate);
    pieces_.first_of_fluid = pieces_.list.size();
    if (layout.has_fluid) layout.has_solid ? add_fluid<WallMotion<D, Real>>() : add_fluid<NoMotion>();
    return std::move(pieces_);
  }

 private:
  /// All elements of the fluid, tested by the wall's functions blended over its height.
  Region<D> blended() const {
    Region<D> r = regions_.fluid();
    r.test = linear_from(r.test, regions_.layout().wall_row, regions_.blend().low, regions_.blend().height);
    r.shared_test = true;
    return r;
  }

  /// @param part  of the solid where it has a joint
  template <class Motion, class Term>
  auto piece(const char* name, const Term& term, Instant instant = Instant::stage, const GivenField<double>& given = {},
             int part = 0) const {
    using Here = InCoordinates<Term, Axial>;
    constexpr Where where = Term::where;
    return std::make_unique<PieceOf<D, P, Here, Motion, Real>>(name, regions_.parts_of(where, regions_.points())[part],
                                                               regions_.parts_of(where, matrix_points<D, P>)[part],
                                                               Here{term}, regions_.blend(), instant, given);
  }
  template <class Motion, class Term>
  void add(const char* name, const Term& term, Instant instant = Instant::stage, const GivenField<double>& given = {}) {
    for (int part = 0; part < parts(Term::where); ++part)
      pieces_.list.push_back({piece<Motion>(name, term, instant, given, part), nullptr});
  }
  int parts(Where where) const { return static_cast<int>(regions_.parts_of(where, regions_.points()).size()); }

  void add_solid(const Substrate& s) {
    const auto elastic = [&](const auto& solid) {
      if (!solid_.graded[0].values.data()) return add<NoMotion>(solid.material.name, solid);
      const char* name = solid_.prestretch.acts ? "stretched solid" : "graded solid";
      const ElasticLaw law = law_of(solid.material);
      if (s.volume_quadrature == VolumeQuadrature::full)
        return add_graded(name, GradedSolid{{{law, solid_.stiffness, solid_.prestretch}, solid.density}});
      const SelectiveMaterials parts = selective_materials(law, solid_.stiffness, solid_.prestretch);
      add_graded(name, GradedSolid{{parts.everywhere, solid.density}});
      if (parts.has_means()) add_graded("solid, means of elements", SolidOfMeans{{{parts.of_means}}});
    };
    std::visit(elastic, solid_.law);
    if (s.fibre.stiffness > 0) add<NoMotion>("fibres", solid_.fibres);
    if (s.surface_tension > 0) add<NoMotion>("surface tension of the solid", SurfaceTension{s.surface_tension});
    if (s.modulus_of_surface() > 0)
      add<NoMotion>("elasticity of the surface", SurfaceElasticity{s.surface_modulus[0], s.surface_modulus[1]});
    add_parts<Loses::nothing>();
    if (s.has_branches()) add_branches(s.strain);
    pieces_.first_viscous = pieces_.list.size();
    if (const KelvinVoigt term = viscosity_of(s); term.rate() > 0) add<NoMotion>("viscosity of the solid", term);
    add_parts<Loses::energy>();
  }

  enum class Loses { nothing, energy };
  template <Loses loses>
  void add_parts() {
    visit_terms_of_parts(case_, [&](const auto& term) {
      if constexpr (HasDissipation<std::decay_t<decltype(term)>> == (loses == Loses::energy))
        add<NoMotion>(term.name, term);
    });
  }

  /// Points that remember are those of the whole solid, whether it has a joint or not.
  void add_branches(Strain strain) {
    if (strain == Strain::small) return add<NoMotion>("branches of the solid", BranchStress{});
    using Here = InCoordinates<FiniteBranchStress, Axial>;
    pieces_.list.push_back(
        {std::make_unique<PieceOf<D, P, Here, NoMotion, Real>>("branches of the solid", regions_.solid(),
                                                               regions_.of(Where::solid, matrix_points<D, P>), Here{}),
         nullptr});
  }

  template <class Term>
  void add_graded(const char* name, const Term& term) {
    for (int part = 0; part < parts(Term::where); ++part)
      pieces_.list.push_back({piece<NoMotion>(name, term, Instant::stage, solid_.graded[part], part), nullptr});
  }

  CapillaryTraction traction() const { return {fluid_.gas, fluid_.capillarity}; }

  template <class Motion>
  void add_fluid() {
    add<Motion>("navier_stokes_korteweg", fluid_);
    add<Motion>("density_moment", DensityMoment{}, Instant::end);
    if constexpr (std::is_same_v<Real, double>) {
      const VariationalDerivative term{fluid_.gas, fluid_.capillarity};
      pieces_.variational_derivative = piece<Motion>("variational_derivative", term);
    }
    if (!regions_.has_wall()) return;
    if (std::abs(wall_.law().cosine) > 1e-14) add_wall<Motion>();  // 90 degrees: nothing to integrate
    if (regions_.layout().rate_rows > 0) {
      add<Motion>("friction of the contact line", wall_.friction);
      pieces_.friction_bend = piece<Motion>("bend of the friction", LineFrictionBend{wall_.friction});
    }
    add_traction<Motion>();
  }

  template <class Motion>
  void add_wall() {
    const EnergyWall& wall = wall_.law();
    if (case_.fluid->wall_law == WallLaw::gradient) {
      const GradientWall law{wall.capillarity, wall.cosine, case_.fluid->smoothing};
      add_law<Motion>("contact_angle (gradient law)", law);
    } else if (wall_.stretch_exponent > 0) {
      add_stretched<Motion>("contact_angle (stretched wall)", PaintedWall<EnergyWall>{wall}, 1, wall_.cosines);
    } else {
      add_law<Motion>("contact_angle (wall energy)", wall);
    }
    pieces_.wall_law = pieces_.list.back().piece.get();
  }
  template <class Motion, class Law>
  void add_law(const char* name, const Law& law) {
    if (!wall_.cosines.values.data()) return add<Motion>(name, law);
    add<Motion>(name, PaintedWall<Law>{law}, Instant::stage, wall_.cosines);
  }

  /// A law of a wall that knows how much it is stretched. @param share  of the law
  template <class Motion, class Law>
  void add_stretched(const char* name, const Law& law, double share, const GivenField<double>& cosines) {
    if constexpr (!std::is_same_v<Motion, NoMotion>)
      add<Motion>(name, StretchedWall<Law>{law, wall_.stretch_exponent, share}, Instant::stage, cosines);
  }

  template <class Motion>
  void add_traction() {
    if constexpr (std::is_same_v<Motion, NoMotion>) {
      pieces_.rigid_traction = piece<Motion>("capillary_traction", traction());
    } else {
      pieces_.on_wall.push_back(pieces_.list.size());
      add<Motion>("capillary_traction", traction());
      if (case_.fluid->traction == Traction::blended)
        pieces_.list.back().exact =
            std::make_unique<PieceOf<D, P, InCoordinates<CapillaryTraction, Axial>, Motion, Real>>(
                "capillary_traction (blended)", blended(), blended(),
                InCoordinates<CapillaryTraction, Axial>{traction()}, regions_.blend());
      if (!wall_.tension.values.data()) return;
      pieces_.on_wall.push_back(pieces_.list.size());
      const WallTension tension{wall_.of_cosine_one()};
      const double beta = wall_.stretch_exponent;
      if (beta > 0 && case_.fluid->wall_tension == WallTensionModel::acts)
        return add_stretched<Motion>("tension of the stretched wall", tension, 1 - beta, wall_.tension);
      add<Motion>("tension of the wall", tension, Instant::stage, wall_.tension);
    }
  }

  const Regions<D>& regions_;
  const NavierStokesKorteweg& fluid_;
  const WallCoefficients& wall_;
  const SolidCoefficients& solid_;
  const Case& case_;
  Pieces<D, Real> pieces_;
};

template <int D, int P, class Real>
Pieces<D, Real> make_pieces(const Regions<D>& regions, const Coefficients<D>& coefficients, const Case& c) {
  return PieceMaker<D, P, Real>(regions, coefficients, c).make();
}

template <int D, int P, class Real>
Pieces<D, Real> make_axisymmetric_pieces(const Regions<D>& regions, const Coefficients<D>& coefficients,
                                         const Case& c) {
  return PieceMaker<D, P, Real, true>(regions, coefficients, c).make();
}

}  // namespace softwet
