// One entry of a scene: a term on a region, with its map. A scene has a list of these.
#pragma once

#include <memory>

#include "field/stage.hpp"
#include "field/vector.hpp"
#include "kernels/functional/term_integrals.hpp"
#include "operator/assemble.hpp"
#include "operator/integrate.hpp"
#include "operator/matrix.hpp"
#include "scene/given_field.hpp"
#include "scene/integrals.hpp"
#include "scene/scene_terms.hpp"

namespace softwet {

/// How a Jacobian-vector product treats the map. exact: it differentiates the mesh (shape derivatives); frozen: the
/// geometry is held (preconditioners).
enum class Geometry { exact, frozen };

/// Which values of the fields a term takes: those of the stage, or those at the end of the step.
enum class Instant { stage, end };

/// One evaluation of terms: where their fields lie, and where their result goes. `tangent` is a vector of unknowns, or
/// empty. The end of the step has density and displacement alone. With `sums` a device adds up several terms at once, later.
template <int D, class Real = double>
struct Evaluation {
  const Layout<D>& layout;
  const StageOf<Real>& stage;
  ConstArrayOf<Real> tangent;
  ArrayOf<Real> test;
  Geometry geometry = Geometry::exact;
  ConstArrayOf<Real> operand = {};
  Instant instant = Instant::stage;
  TileSums<D, Real>* sums = nullptr;
  const Real* given = nullptr;  ///< origin of the given field of the term

  /// Control value (0, 0, 0) of a component on its own grid.
  const Real* field(Component c) const {
    const bool end = instant == Instant::end;
    switch (c.field) {
      case Field::acceleration:
        return stage.acceleration.data() + layout.velocity_offset(c.index);
      case Field::density_rate:
        return component(stage.acceleration, D);
      case Field::displacement:
        return (end ? stage.displacement_end : stage.displacement).data() + layout.displacement_offset(c.index);
      case Field::lag:
        return stage.lag.data() + layout.displacement_offset(c.index);
      case Field::operand:
        return component(operand, c.index);
      case Field::given:
        return given;
      case Field::density:
        if (end) return stage.density_end.data() - layout.fluid_shift();
        [[fallthrough]];
      default:
        return component(stage.unknown, c.unknown(D));
    }
  }

  /// d field / d unknown.
  Real scale(Field f) const {
    const double later = instant == Instant::end ? stage.end_scale : 1.0;
    if (f == Field::acceleration) return static_cast<Real>(stage.rate_scale);
    if (f == Field::density_rate) return static_cast<Real>(stage.density_rate_scale);
    if (f == Field::lag) return static_cast<Real>(stage.branch_weight * stage.displacement_scale);
    return static_cast<Real>(f == Field::displacement ? stage.displacement_scale * later : later);
  }

  /// Control values of component c in a vector of unknowns.
  template <class V>
  auto* component(const V& vector, int c) const {
    return vector.data() + layout.component_shift(c);
  }

  /// Motion of the fluid mesh: the wall's row of displacement and velocity, blended over the fluid's height.
  WallMotion<D, Real> motion(const Blend& blend) const {
    WallMotion<D, Real> m{};
    for (int d = 0; d < D; ++d) {
      m.displacement[d] = field({Field::displacement, d}) + layout.wall_shift();
      m.velocity[d] = field({Field::velocity, d}) + layout.wall_shift();
      const bool differentiate = tangent.data() && geometry == Geometry::exact;
      m.tangent[d] = differentiate ? component(tangent, d) + layout.wall_shift() : nullptr;
    }
    m.scale = scale(Field::displacement);
    m.blend = blend;
    return m;
  }
};

/// Fills what a task of operator/ reads: the fields of its slots, and the motion of the mesh where there is one.
template <int D, class Real, class TaskType>
void bind_fields(const Evaluation<D, Real>& at, const Blend& blend, TaskType& task) {
  using Trial = typename TaskType::Trial;
  for (int s = 0; s < Trial::slot_count; ++s) {
    task.slot[s] = at.field(Trial::slot(s).from);
    task.scale[s] = at.scale(Trial::slot(s).from.field);
  }
  if constexpr (std::is_same_v<decltype(task.motion), WallMotion<D, Real>>) task.motion = at.motion(blend);
  if constexpr (memory_size_of < Trial >> 0) task.memory = at.stage.lag.data();
}

/// The same for a term, with its tangents and the equations that it adds to.
template <int D, class Term, class Motion, class Real>
Task<D, Term, Motion, Real> task_of(const Term& term, const Region<D, Real>& region, const Evaluation<D, Real>& at,
                                    const Blend& blend) {
  Task<D, Term, Motion, Real> task{region, term, {}, {}, {}, {}, {}};
  using Types = decltype(task);
  bind_fields(at, blend, task);
  for (int u = 0; u < D + 2; ++u)
    if (at.tangent.data() && reads<typename Types::Trial, D>(u)) task.tangent[u] = at.component(at.tangent, u);
  for (int c = 0; c < Types::Test::channel_count; ++c)
    task.test[c] = at.component(at.test, Types::Test::channel(c).unknown(D));
  return task;
}

/// Adds a term's residual, or (Tangent) its Jacobian-vector product, to the result of an evaluation.
template <int P, bool Tangent, class List, int D, class Term, class Motion, class Real>
void assemble(const Task<D, Term, Motion, Real>& task, const Evaluation<D, Real>& at) {
  if (at.sums) return assemble<P, Tangent, List>(task, *at.sums);
  TileSums<D, Real> sums(at.layout, at.tangent);
  assemble<P, Tangent, List>(task, sums);
  sums.add_to(at.test);
}

/// A term on a region, type erased: the only virtual call of the computation, a handful per residual.
template <int D, class Real>
class PieceIn {
 public:
  virtual ~PieceIn() = default;
  virtual void product(const Evaluation<D, Real>&) const = 0;
  virtual const char* name() const = 0;
  virtual const Region<D, Real>& region() const = 0;
};

/// Residuals and integrals are made in double precision alone, matrices in single precision.
template <int D, class Real = double>
class Piece : public PieceIn<D, Real> {
 public:
  virtual void residual(const Evaluation<D, Real>&) const = 0;
  /// Adds the energy and the dissipation of the term, where it has them.
  virtual void add_integrals(const Evaluation<D, Real>&, PendingIntegrals&, Integrals&) const = 0;
};
template <int D>
class Piece<D, float> : public PieceIn<D, float> {
 public:
  /// Adds the Jacobian with frozen geometry; the evaluation has no tangent.
  virtual void jacobian(const Evaluation<D, float>&, const Stencil<D>&, const StencilValues&) const = 0;
};

template <int D, int P, class Term, class Motion, class Real = double>
class PieceOf final : public Piece<D, Real> {
 public:
  /// @param matrix_region  the same box with the quadrature of the matrix; `region` where none is assembled
  PieceOf(const char* name, const Region<D>& region, const Region<D>& matrix_region, const Term& term, Blend blend = {},
          Instant instant = Instant::stage, const GivenField<double>& given = {})
      : name_(name),
        region_(rounded<Real>(region)),
        term_(term),
        blend_(blend),
        instant_(instant),
        given_(rounded<Real>(given)) {
    if constexpr (std::is_same_v<Real, float>) matrix_region_ = rounded<Real>(matrix_region);
  }

  void product(const Evaluation<D, Real>&) const override;
  /// Overrides in single precision. In double precision nothing calls it, and it is not compiled.
  void jacobian(const Evaluation<D, Real>&, const Stencil<D>&, const StencilValues&) const;
  // Override in double precision, likewise.
  void residual(const Evaluation<D, Real>&) const;
  void add_integrals(const Evaluation<D, Real>&, PendingIntegrals&, Integrals&) const;
  const char* name() const override { return name_; }
  const Region<D, Real>& region() const override { return region_; }

 private:
  static constexpr bool remembers = memory_size_of<typename Term::template Trial<Real, D>> > 0;
  static constexpr bool of_branches = remembers || [] {
    using Trial = typename Term::template Trial<Real, D>;
    for (int s = 0; s < Trial::slot_count; ++s)
      if (Trial::slot(s).from.field == Field::lag) return true;
    return false;
  }();

  /// Moments at the end of the step count by their rate, which is 0 where only the fluxes are wanted. Branches of a solid count where a
  /// stage lets them carry something.
  bool idle(const Evaluation<D, Real>& at) const {
    if constexpr (of_branches) return at.stage.branch_weight == 0;
    return instant_ == Instant::end && at.stage.moment_rate == 0;
  }

  Task<D, Term, Motion, Real> task(Evaluation<D, Real> at, const Region<D, Real>& region) const {
    at.instant = instant_;
    at.given = given_.origin();
    auto task = task_of<D, Term, Motion, Real>(term_, region, at, blend_);
    if (instant_ == Instant::end) task.factor = static_cast<Real>(at.stage.moment_rate);
    if constexpr (remembers) task.factor = static_cast<Real>(at.stage.branch_weight);
    return task;
  }
  template <class Functional>
  void add_integral(Evaluation<D, Real> at, const Functional& functional, PendingIntegrals& pending,
                    Integrals& result) const {
    ReduceTask<D, Functional, Motion> task{region_, functional, {}, {}, {}};
    at.given = given_.origin();
    bind_fields(at, blend_, task);
    pending.start<P>(task, [&result](const auto& integrals) { result.add<Functional>(integrals); });
  }

  using List = ListOf<D, Real, TermOnMesh<Term, Motion>>;

  const char* name_;
  Region<D, Real> region_, matrix_region_;
  Term term_;
  Blend blend_;
  Instant instant_;
  GivenField<Real> given_;
};

// Outside of the class, so that a source which declares a piece `extern template` does not compile it again.
template <int D, int P, class Term, class Motion, class Real>
void PieceOf<D, P, Term, Motion, Real>::residual(const Evaluation<D, Real>& at) const {
  if (!idle(at)) assemble<P, false, List>(task(at, region_), at);
}

template <int D, int P, class Term, class Motion, class Real>
void PieceOf<D, P, Term, Motion, Real>::product(const Evaluation<D, Real>& at) const {
  if (!idle(at)) assemble<P, true, List>(task(at, region_), at);
}

template <int D, int P, class Term, class Motion, class Real>
void PieceOf<D, P, Term, Motion, Real>::jacobian(const Evaluation<D, Real>& at, const Stencil<D>& stencil,
                                                 const StencilValues& values) const {
  if (idle(at)) return;
  auto frozen = task(at, matrix_region_);
  frozen.memory = nullptr;  // a matrix may have other points, and a preconditioner needs no stress of branches
  assemble_jacobian<P>(frozen, stencil, values);
}

template <int D, int P, class Term, class Motion, class Real>
void PieceOf<D, P, Term, Motion, Real>::add_integrals([[maybe_unused]] const Evaluation<D, Real>& at,
                                                      [[maybe_unused]] PendingIntegrals& pending,
                                                      [[maybe_unused]] Integrals& result) const {
  if constexpr (std::is_same_v<Real, double>) {
    if constexpr (HasEnergy<Term>) add_integral(at, EnergyOf<Term>{term_}, pending, result);
    if constexpr (HasDissipation<Term>) add_integral(at, DissipationOf<Term>{term_}, pending, result);
  }
}

}  // namespace softwet
