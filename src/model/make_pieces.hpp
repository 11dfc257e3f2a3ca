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
    if (layout.has_solid)
      std::visit([&](const auto& solid) { add<NoMotion>(solid.material.name, solid); }, model_.solid());
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

  template <class Motion, class Term>
  auto piece(const char* name, const Term& term, Where where = Term::where, Instant instant = Instant::stage) const {
    return std::make_unique<PieceOf<D, P, Term, Motion, Real>>(
        name, model_.region(where, model_.points()), model_.region(where, matrix_points<D, P>(model_.points())), term,
        model_.blend(), instant);
  }
  template <class Motion, class Term>
  void add(const char* name, const Term& term, Where where = Term::where, Instant instant = Instant::stage) {
    pieces_.list.push_back({piece<Motion>(name, term, where, instant), nullptr});
  }

  CapillaryTraction traction() const { return {model_.fluid().gas, model_.fluid().capillarity}; }

  template <class Motion>
  void add_fluid() {
    add<Motion>("navier_stokes_korteweg", model_.fluid());
    add<Motion>("density_moment", DensityMoment{}, Where::fluid, Instant::end);
    if constexpr (std::is_same_v<Real, double>) {
      const VariationalDerivative term{model_.fluid().gas, model_.fluid().capillarity};
      pieces_.variational_derivative = piece<Motion>("variational_derivative", term);
    }
    if (!model_.has_wall()) return;
    if (std::abs(model_.wall().cosine) > 1e-14) add_wall<Motion>();  // 90 degrees: nothing to integrate
    add_traction<Motion>();
  }

  template <class Motion>
  void add_wall() {
    const EnergyWall& wall = model_.wall();
    if (case_.fluid->wall_law == WallLaw::gradient) {
      const GradientWall law{wall.capillarity, wall.cosine, case_.fluid->smoothing};
      add<Motion>("contact_angle (gradient law)", law);
    } else {
      add<Motion>("contact_angle (wall energy)", wall);
    }
    pieces_.wall_law = pieces_.list.back().piece.get();
  }

  template <class Motion>
  void add_traction() {
    if (!model_.layout().has_solid) {
      pieces_.rigid_traction = piece<Motion>("capillary_traction", traction());
      return;
    }
    pieces_.traction = pieces_.list.size();
    add<Motion>("capillary_traction", traction());
    if (case_.fluid->traction == Traction::blended)
      pieces_.list.back().exact = std::make_unique<PieceOf<D, P, CapillaryTraction, Motion, Real>>(
          "capillary_traction (blended)", blended(), blended(), traction(), model_.blend());
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
