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
template <int D>
struct Binding {
  const Layout<D>& layout;
  const Stage& stage;
  ConstArray tangent;
  Array test;
  Geometry geometry = Geometry::exact;

  const double* velocity(int d) const { return stage.unknown.data() + layout.velocity_offset(d); }
  const double* acceleration(int d) const { return stage.acceleration.data() + layout.velocity_offset(d); }
  const double* displacement(int d) const { return stage.displacement.data() + layout.displacement_offset(d); }
  const double* displacement_end(int d) const { return stage.displacement_end.data() + layout.displacement_offset(d); }
  const double* density() const { return component(stage.unknown, D); }
  const double* potential() const { return component(stage.unknown, D + 1); }
  const double* density_end() const { return stage.density_end.data() - layout.fluid_shift(); }

  /// Control values of component c in a vector of unknowns.
  template <class V>
  auto* component(const V& vector, int c) const {
    return vector.data() + layout.component_shift(c);
  }

  /// Motion of the fluid mesh: the wall's row of displacement and velocity, blended over the fluid's height.
  WallMotion<D> motion(const Blend& blend) const {
    WallMotion<D> m{};
    for (int d = 0; d < D; ++d) {
      m.displacement[d] = displacement(d) + layout.wall_shift();
      m.displacement_end[d] = displacement_end(d) + layout.wall_shift();
      m.velocity[d] = velocity(d) + layout.wall_shift();
      const bool differentiate = tangent.data() && geometry == Geometry::exact;
      m.tangent[d] = differentiate ? component(tangent, d) + layout.wall_shift() : nullptr;
    }
    m.scale = stage.displacement_scale;
    m.scale_end = stage.displacement_scale * stage.end_scale;
    m.blend = blend;
    return m;
  }
};

// Which arrays hold the fields that a term reads: the only term-specific wiring.
template <int D>
void bind_slots(const NavierStokesKorteweg&, const Binding<D>& b, const double** slot) {
  for (int d = 0; d < D; ++d) {
    slot[d] = b.velocity(d);
    slot[D + d] = b.acceleration(d);
  }
  slot[2 * D] = b.density();
  slot[2 * D + 1] = b.potential();
  slot[2 * D + 2] = b.density_end();
}
template <int D>
void bind_slots(const CapillaryTraction&, const Binding<D>& b, const double** slot) {
  slot[0] = b.density();
  slot[1] = b.potential();
}
template <int D>
void bind_slots(const VariationalDerivative&, const Binding<D>& b, const double** slot) {
  slot[0] = b.density();
}
template <int D>
void bind_slots(const GradientWall&, const Binding<D>& b, const double** slot) {
  slot[0] = b.density();
}
template <int D>
void bind_slots(const EnergyWall&, const Binding<D>& b, const double** slot) {
  slot[0] = b.density();
}
template <int D>
void bind_slots(const Elastodynamics&, const Binding<D>& b, const double** slot) {
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
template <int D>
class Piece {
 public:
  virtual ~Piece() = default;
  virtual void residual(const Binding<D>&) const = 0;
  virtual void product(const Binding<D>&) const = 0;
  /// Adds the Jacobian with frozen geometry; the binding has no tangent.
  virtual void jacobian(const Binding<D>&, const Stencil<D>&, const StencilValues&) const = 0;
  virtual const char* name() const = 0;
  virtual const Region<D>& region() const = 0;
};

template <int D, int P, int QL, class Term, class Motion>
class PieceOf final : public Piece<D> {
 public:
  PieceOf(const char* name, const Region<D>& region, const Term& term, Components components, Blend blend = {})
      : name_(name), region_(region), term_(term), components_(components), blend_(blend) {}

  void residual(const Binding<D>& b) const override { assemble<P, QL, false>(task(b)); }
  void product(const Binding<D>& b) const override { assemble<P, QL, true>(task(b)); }
  void jacobian(const Binding<D>& b, const Stencil<D>& stencil, const StencilValues& values) const override {
    assemble_jacobian<P, QL>(task(b), stencil, values, components_.test, components_.trial);
  }
  const char* name() const override { return name_; }
  const Region<D>& region() const override { return region_; }

 private:
  Task<D, Term, Motion> task(const Binding<D>& b) const {
    using Types = Task<D, Term, Motion>;
    Task<D, Term, Motion> t{region_, term_, {}, {}, {}, {}, {}};
    if constexpr (std::is_same_v<Term, NavierStokesKorteweg>) t.term.moment_rate = b.stage.moment_rate;
    if constexpr (std::is_same_v<Motion, WallMotion<D>>) t.motion = b.motion(blend_);
    bind_slots(term_, b, t.slot);
    for (int u = 0; u < Types::Trial::unknown_count; ++u)
      t.tangent[u] = b.tangent.data() ? b.component(b.tangent, components_.trial + u) : nullptr;
    for (int c = 0; c < Types::Test::channel_count; ++c) t.test[c] = b.component(b.test, components_.test + c);
    t.scale[static_cast<int>(Scale::one)] = 1.0;
    t.scale[static_cast<int>(Scale::rate)] = b.stage.rate_scale;
    t.scale[static_cast<int>(Scale::displacement)] = b.stage.displacement_scale;
    t.scale[static_cast<int>(Scale::end)] = b.stage.end_scale;
    return t;
  }

  const char* name_;
  Region<D> region_;
  Term term_;
  Components components_;
  Blend blend_;
};

}  // namespace softwet
