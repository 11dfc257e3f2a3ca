// How the list of terms of a scene is made, for the sources that compile it in one precision each.
#pragma once

#include <cmath>

#include "model/model.hpp"

namespace softwet {

template <int D, int P, class Real>
class PieceMaker {
 public:
  PieceMaker(const Model<D, P>& model, const Case& c) : model_(model), case_(c) {}

  Pieces<D, Real> make() {
    const Layout<D>& layout = model_.layout();
    if (layout.has_solid) add<P + 1, NoMotion>("saint_venant_kirchhoff", model_.solid_region(), model_.solid(), {0, 0});
    pieces_.first_of_fluid = pieces_.list.size();
    if (layout.has_fluid) layout.has_solid ? add_fluid<WallMotion<D, Real>>() : add_fluid<NoMotion>();
    return std::move(pieces_);
  }

 private:
  template <int QL, class Motion, class Term>
  auto piece(const char* name, const Region<D>& region, const Term& term, Components components) const {
    return std::make_unique<PieceOf<D, P, QL, Term, Motion, Real>>(name, region, term, components, model_.blend());
  }
  template <int QL, class Motion, class Term>
  void add(const char* name, const Region<D>& region, const Term& term, Components components) {
    pieces_.list.push_back(piece<QL, Motion>(name, region, term, components));
  }

  CapillaryTraction traction() const { return {model_.fluid().gas, model_.fluid().capillarity}; }

  template <class Motion>
  void add_fluid() {
    add<P + 1, Motion>("navier_stokes_korteweg", model_.fluid_region(), model_.fluid(), {0, 0});
    if constexpr (std::is_same_v<Real, double>) {
      const VariationalDerivative term{model_.fluid().gas, model_.fluid().capillarity};
      pieces_.variational_derivative =
          piece<P + 1, Motion>("variational_derivative", model_.fluid_region(), term, {D, D + 1});
    }
    if (case_.fluid->form == CapillaryForm::divergence)
      add<P + 1, Motion>("capillary stress (divergence form)", model_.fluid_region(), traction(), {D, 0});
    if (!model_.has_wall()) return;
    if (std::abs(model_.wall().cosine) > 1e-14) add_wall<Motion>();             // 90 degrees: nothing to integrate
    if (case_.fluid->form == CapillaryForm::potential) add_traction<Motion>();  // else it is in the stress already
  }

  template <class Motion>
  void add_wall() {
    const EnergyWall& wall = model_.wall();
    if (case_.fluid->wall_law == WallLaw::gradient) {
      const GradientWall law{wall.capillarity, wall.cosine, case_.fluid->smoothing};
      add<1, Motion>("contact_angle (gradient law)", model_.wall_region(), law, {D, D + 1});
    } else {
      add<1, Motion>("contact_angle (wall energy)", model_.wall_region(), wall, {D, D + 1});
    }
    pieces_.wall_law = pieces_.list.back().get();
  }

  template <class Motion>
  void add_traction() {
    const Layout<D>& layout = model_.layout();
    Region<D> layer = model_.region(layout.solid_elements, layout.solid_elements + 1);
    layer.test = restricted_to(layer.test, 0);
    auto on_layer = piece<P + 1, Motion>("capillary_traction", layer, traction(), {D, 0});
    (layout.has_solid ? pieces_.list.emplace_back() : pieces_.rigid_traction) = std::move(on_layer);
    if (!layout.has_solid || case_.fluid->traction == Traction::layer) return;
    Region<D> all = model_.fluid_region();
    all.test = linear_from(all.test, layout.wall_row, model_.blend().low, model_.blend().height);
    all.shared_test = true;
    pieces_.blended_traction = piece<P + 1, Motion>("capillary_traction (blended)", all, traction(), {D, 0});
  }

  const Model<D, P>& model_;
  const Case& case_;
  Pieces<D, Real> pieces_;
};

template <int D, int P, class Real>
Pieces<D, Real> make_pieces(const Model<D, P>& model, const Case& c) {
  return PieceMaker<D, P, Real>(model, c).make();
}

}  // namespace softwet
