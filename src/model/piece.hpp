// One entry of a scene: a term on a region, with its map. The model is a list of these.
#pragma once

#include <memory>

#include "field/stage.hpp"
#include "kernels/fluid/navier_stokes_korteweg.hpp"
#include "kernels/solid/elastodynamics.hpp"
#include "model/geometry.hpp"
#include "operator/assemble.hpp"
#include "operator/jacobian.hpp"

namespace softwet {

/// Where the fields of a stage lie, as pointers a task can use; `tangent` is a vector of unknowns or empty.
template <int D, class Real = double>
struct Binding {
  const Layout<D>& layout;
  const StageOf<Real>& stage;
  ConstArrayOf<Real> tangent;
  ArrayOf<Real> test;
  Geometry geometry = Geometry::exact;

  const Real* velocity(int d) const { return stage.unknown.data() + layout.velocity_offset(d); }
  const Real* acceleration(int d) const { return stage.acceleration.data() + layout.velocity_offset(d); }
  const Real* displacement(int d) const { return stage.displacement.data() + layout.displacement_offset(d); }
  const Real* displacement_end(int d) const { return stage.displacement_end.data() + layout.displacement_offset(d); }
  const Real* density() const { return component(stage.unknown, D); }
  const Real* potential() const { return component(stage.unknown, D + 1); }
  const Real* density_end() const { return stage.density_end.data() - layout.fluid_shift(); }

  /// Control values of component c in a vector of unknowns.
  template <class V>
  auto* component(const V& vector, int c) const {
    return vector.data() + layout.component_shift(c);
  }

  /// Motion of the fluid mesh: the wall's row of displacement and velocity, blended over the fluid's height.
  WallMotion<D, Real> motion(const Blend& blend) const {
    WallMotion<D, Real> m{};
    for (int d = 0; d < D; ++d) {
      m.displacement[d] = displacement(d) + layout.wall_shift();
      m.displacement_end[d] = displacement_end(d) + layout.wall_shift();
      m.velocity[d] = velocity(d) + layout.wall_shift();
      const bool differentiate = tangent.data() && geometry == Geometry::exact;
      m.tangent[d] = differentiate ? component(tangent, d) + layout.wall_shift() : nullptr;
    }
    m.scale = static_cast<Real>(stage.displacement_scale);
    m.scale_end = static_cast<Real>(stage.displacement_scale * stage.end_scale);
    m.blend = blend;
    return m;
  }
};

// Which arrays hold the fields that a term reads: the only term-specific wiring.
template <int D, class Real>
void bind_slots(const NavierStokesKorteweg&, const Binding<D, Real>& b, const Real** slot) {
  for (int d = 0; d < D; ++d) {
    slot[d] = b.velocity(d);
    slot[D + d] = b.acceleration(d);
  }
  slot[2 * D] = b.density();
  slot[2 * D + 1] = b.potential();
  slot[2 * D + 2] = b.density_end();
}
template <int D, class Real>
void bind_slots(const CapillaryTraction&, const Binding<D, Real>& b, const Real** slot) {
  slot[0] = b.density();
  slot[1] = b.potential();
}
template <int D, class Real>
void bind_slots(const VariationalDerivative&, const Binding<D, Real>& b, const Real** slot) {
  slot[0] = b.density();
}
template <int D, class Real>
void bind_slots(const GradientWall&, const Binding<D, Real>& b, const Real** slot) {
  slot[0] = b.density();
}
template <int D, class Real>
void bind_slots(const EnergyWall&, const Binding<D, Real>& b, const Real** slot) {
  slot[0] = b.density();
}
template <int D, class Real>
void bind_slots(const Elastodynamics&, const Binding<D, Real>& b, const Real** slot) {
  for (int d = 0; d < D; ++d) {
    slot[d] = b.acceleration(d);
    slot[D + d] = b.displacement(d);
  }
}

/// Unknown component of trial unknown 0 and of test channel 0; the following ones are consecutive.
struct Components {
  int trial, test;
};

/// A term on a region, type erased: the only virtual call of the computation, a handful per residual.
template <int D, class Real>
class PieceIn {
 public:
  virtual ~PieceIn() = default;
  virtual void residual(const Binding<D, Real>&) const = 0;
  virtual void product(const Binding<D, Real>&) const = 0;
  virtual const char* name() const = 0;
  virtual const Region<D, Real>& region() const = 0;
};

/// Matrices are assembled from double precision alone.
template <int D, class Real = double>
class Piece : public PieceIn<D, Real> {};
template <int D>
class Piece<D, double> : public PieceIn<D, double> {
 public:
  /// Adds the Jacobian with frozen geometry; the binding has no tangent.
  virtual void jacobian(const Binding<D>&, const Stencil<D>&, const StencilValues&) const = 0;
};

template <int D, int P, int QL, class Term, class Motion, class Real = double>
class PieceOf final : public Piece<D, Real> {
 public:
  PieceOf(const char* name, const Region<D>& region, const Term& term, Components components, Blend blend = {})
      : name_(name), region_(rounded<Real>(region)), term_(term), components_(components), blend_(blend) {}

  void residual(const Binding<D, Real>& b) const override { assemble<P, QL, false>(task(b)); }
  void product(const Binding<D, Real>& b) const override { assemble<P, QL, true>(task(b)); }
  /// Overrides in double precision. In single precision nothing calls it, and it is not compiled.
  void jacobian(const Binding<D, Real>& b, const Stencil<D>& stencil, const StencilValues& values) const {
    assemble_jacobian<P, QL>(task(b), stencil, values, components_.test, components_.trial);
  }
  const char* name() const override { return name_; }
  const Region<D, Real>& region() const override { return region_; }

 private:
  Task<D, Term, Motion, Real> task(const Binding<D, Real>& b) const {
    using Types = Task<D, Term, Motion, Real>;
    Types t{region_, term_, {}, {}, {}, {}, {}};
    if constexpr (std::is_same_v<Term, NavierStokesKorteweg>) t.term.moment_rate = b.stage.moment_rate;
    if constexpr (std::is_same_v<Motion, WallMotion<D, Real>>) t.motion = b.motion(blend_);
    bind_slots(term_, b, t.slot);
    for (int u = 0; u < Types::Trial::unknown_count; ++u)
      t.tangent[u] = b.tangent.data() ? b.component(b.tangent, components_.trial + u) : nullptr;
    for (int c = 0; c < Types::Test::channel_count; ++c) t.test[c] = b.component(b.test, components_.test + c);
    t.scale[static_cast<int>(Scale::one)] = 1;
    t.scale[static_cast<int>(Scale::rate)] = static_cast<Real>(b.stage.rate_scale);
    t.scale[static_cast<int>(Scale::displacement)] = static_cast<Real>(b.stage.displacement_scale);
    t.scale[static_cast<int>(Scale::end)] = static_cast<Real>(b.stage.end_scale);
    return t;
  }

  const char* name_;
  Region<D, Real> region_;
  Term term_;
  Components components_;
  Blend blend_;
};

}  // namespace softwet
