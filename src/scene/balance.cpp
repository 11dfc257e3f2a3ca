#include "scene/balance.hpp"

#include <algorithm>

#include "field/vector.hpp"
#include "kernels/fluid/gravity.hpp"
#include "kernels/functional/fluid_integrals.hpp"
#include "kernels/functional/solid_integrals.hpp"
#include "kernels/functional/wall_integrals.hpp"
#include "operator/integrate.hpp"
#include "scene/branch_strains.hpp"
#include "scene/functional_task.hpp"

namespace softwet {
namespace {

/// The integrals of a functional in the coordinates of the scene.
template <int P, class Motion, int D, class Functional>
std::array<double, Functional::count> integrate(const Region<D>& region, const Functional& functional,
                                                const Evaluation<D>& at, const Blend& blend) {
  return with_task_of<Motion>(region, functional, at, blend, [&](auto& task) { return reduce<P>(task); });
}

}  // namespace

template <int D, int P>
Balance<D, P>::Balance(const Regions<D>& regions, const Coefficients<D>& coefficients, const Forces<D>& forces,
                       const Terms<D, P>& terms)
    : layout_(regions.layout()), regions_(regions), coefficients_(coefficients), forces_(forces) {
  for (const auto& entry : terms.pieces().list)
    parts_.push_back([&piece = *entry.piece](const Evaluation<D>& at, PendingIntegrals& pending, Measured& found) {
      piece.add_integrals(at, pending, found.integrals);
    });
  if (layout_.has_solid) {
    add<NoMotion>(regions_.solid(), SolidMotion{coefficients_.solid().density()});
    parts_.push_back([this](const auto& at, auto& pending, auto& found) { start_forces(at.stage, pending, found); });
  }
  if (layout_.branches > 0)
    parts_.push_back(
        [this](const auto& at, auto& pending, auto& found) { start_branches(at.stage, pending, found.integrals); });
  if (layout_.has_fluid) layout_.has_solid ? add_fluid<WallMotion<D>>() : add_fluid<NoMotion>();
}

template <int D, int P>
template <class Motion, bool Rate, class Functional>
void Balance<D, P>::add(const Region<D>& region, const Functional& functional, const double* given) {
  parts_.push_back([this, &region, functional, given](Evaluation<D> at, PendingIntegrals& pending, Measured& found) {
    at.given = given;
    with_task_of<Motion>(region, functional, at, regions_.blend(), [&](auto& task) {
      if constexpr (Rate) {
        for (int d = 0; d < D; ++d) task.motion.tangent[d] = task.motion.velocity[d];
        task.motion.scale = 1;
      }
      pending.start<P, Rate>(task, [&all = found.integrals](const auto& integrals) {
        if constexpr (Rate) all.part(Functional::rate_column) += integrals[0];
        if constexpr (!Rate) all.template add<Functional>(integrals);
      });
    });
  });
}

template <int D, int P>
template <class Motion>
void Balance<D, P>::add_fluid() {
  const NavierStokesKorteweg& fluid = coefficients_.fluid();
  const Coexistence& phases = coefficients_.coexistence();
  add<Motion>(regions_.fluid(), FluidIntegrals{fluid, {phases.density_vapour, phases.density_liquid}});
  GravityEnergy gravity;
  std::copy_n(fluid.force, D, gravity.force);
  if (std::any_of(fluid.force, fluid.force + D, [](double f) { return f != 0; }))
    add<Motion>(regions_.fluid(), gravity);
  if (!regions_.has_wall()) return;
  const WallCoefficients& wall = coefficients_.wall();
  if (wall.stretch_exponent > 0) {
    if constexpr (std::is_same_v<Motion, WallMotion<D>>)
      add_wall<Motion>(StretchedWallIntegrals{{{wall.energy}}, wall.stretch_exponent});
  } else if (wall.cosines.values.data()) {
    add_wall<Motion>(PaintedWallIntegrals{{wall.energy}});
  } else {
    add_wall<Motion>(WallIntegrals{wall.energy});
  }
}

template <int D, int P>
template <class Motion, class Functional>
void Balance<D, P>::add_wall(const Functional& functional) {
  const WallCoefficients& wall = coefficients_.wall();
  add<Motion>(regions_.wall(), functional, wall.cosines.origin());
  if constexpr (std::is_same_v<Motion, WallMotion<D>>)
    if (wall.feeds) add<Motion, true>(regions_.wall(), functional, wall.cosines.origin());
}

template <int D, int P>
void Balance<D, P>::start_forces(const Stage& stage, PendingIntegrals& pending, Measured& found) const {
  forces_.start_load_power(stage.time, stage.unknown, pending, found.load_power);
  forces_.needles().start_readings(layout_, stage, pending, found.needles);
  pending.then([&found] {
    for (const NeedleReading& needle : found.needles) found.integrals.part(Needles<D>::energy_column) += needle.energy;
  });
  const SolidGravity& gravity = forces_.gravity();
  const int count = layout_.solid_rows() * layout_.row_size;
  for (std::size_t d = 0; d < gravity.force.size(); ++d) {
    const int first = layout_.displacement_offset(static_cast<int>(d));
    pending.start_sum(layout_.space(), gravity.weight, part(stage.displacement, first, first + count),
                      [&found, force = gravity.force[d]](double sum) {
                        found.integrals.part(SolidGravity::energy_column) -= force * sum;
                      });
  }
}

template <int D, int P>
void Balance<D, P>::followed_by_branches(const Stage& stage, const Array& followed, const Array& rate) const {
  if (layout_.branches_at_points) {
    write_strains<P>(regions_, stage.displacement, followed);
    return write_strain_rates<P>(regions_, stage, rate);
  }
  Kokkos::deep_copy(Exec(), followed, stage.displacement);
  const int count = layout_.solid_rows() * layout_.row_size;
  for (int d = 0; d < D; ++d) {
    const int first = layout_.velocity_offset(d), to = layout_.displacement_offset(d);
    Kokkos::deep_copy(Exec(), Kokkos::subview(rate, Kokkos::make_pair(to, to + count)),
                      part(stage.unknown, first, first + count));
  }
}

template <int D, int P>
void Balance<D, P>::start_branches(const Stage& stage, PendingIntegrals& pending, Integrals& result) const {
  if (!stage.memory.data()) return;
  const Branches& branches = coefficients_.solid().branches;
  const int size = layout_.branch_size();
  const Array followed("integrals.followed", size), rate("integrals.rate", size);
  followed_by_branches(stage, followed, rate);
  Stage of_branch = stage;
  of_branch.lag = Array("integrals.lag", size);
  const Evaluation<D> at{layout_, of_branch, {}, {}};
  const auto add_square = [&](const char* column, double factor) {
    const auto of = [&](const auto& shear) {
      with_task_of<NoMotion>(regions_.solid(), shear, at, regions_.blend(), [&](const auto& task) {
        pending.start<P>(task, [&result, column, factor](const auto& s) { result.part(column) += factor * s[0]; });
      });
    };
    layout_.branches_at_points ? of(FiniteShearSquare{}) : of(ShearSquare{});
  };
  for (int i = 0; i < branches.count; ++i) {
    Kokkos::deep_copy(Exec(), of_branch.lag, followed);
    add_scaled(of_branch.lag, 0, -1, part(stage.memory, i * size, (i + 1) * size));
    add_square(ShearSquare::energy_column, branches.modulus[i]);
    const double moving = branches.share_of_velocity(i, stage.memory_shift);
    combine(of_branch.lag, 1 - moving, part(stage.memory_rate, i * size, (i + 1) * size), 0);
    add_scaled(of_branch.lag, 0, moving, rate);
    add_square(ShearSquare::dissipation_column, 2 * branches.modulus[i] * branches.time[i]);
  }
  pending.finish();  // before the arrays go
}

template <int D, int P>
void Balance<D, P>::start_row(const Stage& stage, PendingIntegrals& pending, Measured& found) const {
  const Evaluation<D> at{layout_, stage, {}, {}};
  for (const Part& part : parts_) part(at, pending, found);
  if (layout_.axisymmetric()) pending.then([this, &found] { found.turn(regions_.turn()); });
}

template <int D, int P>
Measured Balance<D, P>::measure(const Stage& stage) const {
  Measured found;
  PendingIntegrals pending;
  start_row(stage, pending, found);
  pending.finish();
  return found;
}

template <int D, int P>
template <class Functional>
std::array<double, Functional::count> Balance<D, P>::over_fluid(const Functional& functional,
                                                                const Stage& stage) const {
  const Evaluation<D> at{layout_, stage, {}, {}};
  return layout_.has_solid ? integrate<P, WallMotion<D>>(regions_.fluid(), functional, at, regions_.blend())
                           : integrate<P, NoMotion>(regions_.fluid(), functional, at, regions_.blend());
}

template <int D, int P>
Filling Balance<D, P>::filling(const Stage& stage) const {
  const auto sum = over_fluid(FluidContents{}, stage);
  return {sum[FluidContents::mass], sum[FluidContents::volume]};
}

template <int D, int P>
MeshFaults Balance<D, P>::faults(const Stage& stage) const {
  MeshFaults faults;
  if (!layout_.has_solid) return faults;  // nothing moves the mesh
  if (layout_.has_fluid) faults.folded = over_fluid(FluidContents{}, stage)[FluidContents::folded];
  const Evaluation<D> at{layout_, stage, {}, {}};
  faults.inverted = integrate<P, NoMotion>(regions_.solid(), InvertedSolid{}, at, regions_.blend())[0];
  return faults;
}

template class Balance<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
