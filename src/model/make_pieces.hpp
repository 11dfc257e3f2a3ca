// How the list of terms of a scene is made, for the sources that compile it in one precision each.
#pragma once

#include "case/gel.hpp"
#include "kernels/fluid/stretched_wall.hpp"
#include "kernels/solid/branches.hpp"
#include "kernels/solid/foundation.hpp"
#include "kernels/solid/graded.hpp"
#include "kernels/solid/kelvin_voigt.hpp"
#include "kernels/solid/surface_elasticity.hpp"
#include "kernels/solid/surface_tension.hpp"
#include "model/model.hpp"

namespace softwet {

/// A term in the coordinates of a scene.
template <class Term, bool Axial>
using InCoordinates = std::conditional_t<Axial, Axisymmetric<Term>, Term>;

template <int D, int P, class Real, bool Axial = false>
class PieceMaker {
 public:
  PieceMaker(const Model<D, P>& model, const Case& c) : model_(model), case_(c) {}

  Pieces<D, Real> make() {
    const Layout<D>& layout = model_.layout();
    if (layout.has_solid) add_solid(*case_.substrate);
    pieces_.first_of_fluid = pieces_.list.size();
    if (layout.has_fluid) layout.has_solid ? add_fluid<WallMotion<D, Real>>() : add_fluid<NoMotion>();
    return std::move(pieces_);
  }

 private:
  /// All elements of the fluid, tested by the wall's functions blended over its height.
  Region<D> blended() const {
    Region<D> r = model_.fluid_region();
    r.test = linear_from(r.test, model_.layout().wall_row, model_.blend().low, model_.blend().height);
    r.shared_test = true;
    return r;
  }

  /// @param part  of the solid where it has a joint
  template <class Motion, class Term>
  auto piece(const char* name, const Term& term, Instant instant = Instant::stage, const GivenField<double>& given = {},
             int part = 0) const {
    using Here = InCoordinates<Term, Axial>;
    constexpr Where where = Term::where;
    return std::make_unique<PieceOf<D, P, Here, Motion, Real>>(
        name, model_.regions(where, model_.points())[part],
        model_.regions(where, matrix_points<D, P>(model_.points()))[part], Here{term}, model_.blend(), instant, given);
  }
  template <class Motion, class Term>
  void add(const char* name, const Term& term, Instant instant = Instant::stage, const GivenField<double>& given = {}) {
    for (int part = 0; part < parts(Term::where); ++part)
      pieces_.list.push_back({piece<Motion>(name, term, instant, given, part), nullptr});
  }
  int parts(Where where) const { return static_cast<int>(model_.regions(where, model_.points()).size()); }

  void add_solid(const Substrate& s) {
    const auto elastic = [&](const auto& solid) {
      if (!model_.graded(0).values.data()) return add<NoMotion>(solid.material.name, solid);
      const char* name = model_.prestretch().acts ? "stretched solid" : "graded solid";
      const ElasticLaw law = law_of(solid.material);
      if (s.volume_quadrature == VolumeQuadrature::full)
        return add_graded(name, GradedSolid{{{law, model_.stiffness(), model_.prestretch()}, solid.density}});
      const SelectiveParts parts = SelectiveParts::of(model_.stiffness());
      add_graded(name, GradedSolid{{{law, parts.everywhere, model_.prestretch()}, solid.density}});
      Prestretch of_means = model_.prestretch();
      of_means.energy_at_rest = 0;  // the other part has that of both
      if (parts.of_means.lambda > 0)
        add_graded("solid, means of elements", SolidOfMeans{{{{law, parts.of_means, of_means}}}});
    };
    std::visit(elastic, model_.solid());
    const double finite = s.strain == Strain::small ? 0 : 1;
    if (s.fibre.stiffness > 0) add<NoMotion>("fibres", model_.fibres());
    if (s.surface_tension > 0) add<NoMotion>("surface tension of the solid", SurfaceTension{s.surface_tension});
    if (s.modulus_of_surface() > 0)
      add<NoMotion>("elasticity of the surface", SurfaceElasticity{s.surface_modulus[0], s.surface_modulus[1]});
    if (const std::vector<double>& springs = case_.boundary.foundation; !springs.empty())
      add<NoMotion>("foundation", Foundation{springs[0], springs[1]});
    if (s.has_branches()) add<NoMotion>("branches of the solid", BranchStress{});
    pieces_.first_viscous = pieces_.list.size();
    if (const double viscosity = shear_viscosity(s); viscosity > 0 || s.bulk_viscosity > 0)
      add<NoMotion>("viscosity of the solid", KelvinVoigt{viscosity, s.bulk_viscosity, finite});
    if (const std::vector<double>& dashpots = case_.boundary.foundation_damping; !dashpots.empty())
      add<NoMotion>("dashpots of the foundation", Dashpots{dashpots[0], dashpots[1]});
  }

  template <class Term>
  void add_graded(const char* name, const Term& term) {
    for (int part = 0; part < parts(Term::where); ++part)
      pieces_.list.push_back({piece<NoMotion>(name, term, Instant::stage, model_.graded(part), part), nullptr});
  }

  CapillaryTraction traction() const { return {model_.fluid().gas, model_.fluid().capillarity}; }

  template <class Motion>
  void add_fluid() {
    add<Motion>("navier_stokes_korteweg", model_.fluid());
    add<Motion>("density_moment", DensityMoment{}, Instant::end);
    if constexpr (std::is_same_v<Real, double>) {
      const VariationalDerivative term{model_.fluid().gas, model_.fluid().capillarity};
      pieces_.variational_derivative = piece<Motion>("variational_derivative", term);
    }
    if (!model_.has_wall()) return;
    if (std::abs(model_.wall().cosine) > 1e-14) add_wall<Motion>();  // 90 degrees: nothing to integrate
    if (model_.layout().rate_rows > 0) {
      add<Motion>("friction of the contact line", model_.line_friction());
      pieces_.friction_bend = piece<Motion>("bend of the friction", LineFrictionBend{model_.line_friction()});
    }
    add_traction<Motion>();
  }

  template <class Motion>
  void add_wall() {
    const EnergyWall& wall = model_.wall();
    if (case_.fluid->wall_law == WallLaw::gradient) {
      const GradientWall law{wall.capillarity, wall.cosine, case_.fluid->smoothing};
      add_law<Motion>("contact_angle (gradient law)", law);
    } else if (model_.wall_stretch_exponent() > 0) {
      add_stretched<Motion>("contact_angle (stretched wall)", PaintedWall<EnergyWall>{wall}, 1, model_.painted());
    } else {
      add_law<Motion>("contact_angle (wall energy)", wall);
    }
    pieces_.wall_law = pieces_.list.back().piece.get();
  }
  template <class Motion, class Law>
  void add_law(const char* name, const Law& law) {
    if (!model_.painted().values.data()) return add<Motion>(name, law);
    add<Motion>(name, PaintedWall<Law>{law}, Instant::stage, model_.painted());
  }

  /// A law of a wall that knows how much it is stretched. @param share  of the law
  template <class Motion, class Law>
  void add_stretched(const char* name, const Law& law, double share, const GivenField<double>& cosines) {
    if constexpr (!std::is_same_v<Motion, NoMotion>)
      add<Motion>(name, StretchedWall<Law>{law, model_.wall_stretch_exponent(), share}, Instant::stage, cosines);
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
                InCoordinates<CapillaryTraction, Axial>{traction()}, model_.blend());
      if (!model_.wall_tension().values.data()) return;
      pieces_.on_wall.push_back(pieces_.list.size());
      const WallTension tension{model_.wall_of_one()};
      const double beta = model_.wall_stretch_exponent();
      if (beta > 0 && case_.fluid->wall_tension == WallTensionModel::acts)
        return add_stretched<Motion>("tension of the stretched wall", tension, 1 - beta, model_.wall_tension());
      add<Motion>("tension of the wall", tension, Instant::stage, model_.wall_tension());
    }
  }

  const Model<D, P>& model_;
  const Case& case_;
  Pieces<D, Real> pieces_;
};

template <int D, int P, class Real>
Pieces<D, Real> make_pieces(const Model<D, P>& model, const Case& c) {
  return PieceMaker<D, P, Real>(model, c).make();
}

template <int D, int P, class Real>
Pieces<D, Real> make_axisymmetric_pieces(const Model<D, P>& model, const Case& c) {
  return PieceMaker<D, P, Real, true>(model, c).make();
}

}  // namespace softwet
