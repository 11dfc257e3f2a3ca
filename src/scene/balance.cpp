#include "scene/balance.hpp"

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

/// Starts them; `take` gets them when they are finished. With Rate the rates at which the motion of the wall changes
/// them.
template <int P, class Motion, bool Rate = false, int D, class Functional, class Take>
void start(PendingIntegrals& pending, const Region<D>& region, const Functional& functional, const Evaluation<D>& at,
           const Blend& blend, const Take& take) {
  with_task_of<Motion>(region, functional, at, blend, [&](auto& task) {
    if constexpr (Rate) {
      for (int d = 0; d < D; ++d) task.motion.tangent[d] = task.motion.velocity[d];
      task.motion.scale = 1;
    }
    pending.start<P, Rate>(task, take);
  });
}

/// Starts them for the parts that the functional names.
template <int P, class Motion, int D, class Functional>
void start_parts(PendingIntegrals& pending, const Region<D>& region, const Functional& functional,
                 const Evaluation<D>& at, const Blend& blend, Integrals& result) {
  start<P, Motion>(pending, region, functional, at, blend,
                   [&result](const auto& integrals) { result.add<Functional>(integrals); });
}

}  // namespace

template <int D, int P>
Balance<D, P>::Balance(const Regions<D>& regions, const Coefficients<D>& coefficients, const Forces<D>& forces,
                       const Terms<D, P>& terms)
    : layout_(regions.layout()), regions_(regions), coefficients_(coefficients), forces_(forces), terms_(terms) {}

template <int D, int P>
template <class Motion>
void Balance<D, P>::fluid_integrals(const Evaluation<D>& at, PendingIntegrals& pending, Integrals& result) const {
  const NavierStokesKorteweg& fluid = coefficients_.fluid();
  const Coexistence& phases = coefficients_.coexistence();
  const FluidIntegrals integrals{fluid, {phases.density_vapour, phases.density_liquid}};
  start_parts<P, Motion>(pending, regions_.fluid(), integrals, at, regions_.blend(), result);
  GravityEnergy gravity;
  bool acts = false;
  for (int d = 0; d < D; ++d) {
    gravity.force[d] = fluid.force[d];
    acts = acts || gravity.force[d] != 0;
  }
  if (acts) start_parts<P, Motion>(pending, regions_.fluid(), gravity, at, regions_.blend(), result);
  if (!regions_.has_wall()) return;
  const WallCoefficients& wall = coefficients_.wall();
  if (wall.stretch_exponent > 0) {
    if constexpr (std::is_same_v<Motion, WallMotion<D>>)
      wall_integrals<Motion>(StretchedWallIntegrals{{{wall.energy}}, wall.stretch_exponent}, at, pending, result);
  } else if (wall.cosines.values.data()) {
    wall_integrals<Motion>(PaintedWallIntegrals{{wall.energy}}, at, pending, result);
  } else {
    wall_integrals<Motion>(WallIntegrals{wall.energy}, at, pending, result);
  }
}

template <int D, int P>
template <class Motion, class Functional>
void Balance<D, P>::wall_integrals(const Functional& functional, Evaluation<D> at, PendingIntegrals& pending,
                                   Integrals& result) const {
  at.given = coefficients_.wall().cosines.origin();
  start_parts<P, Motion>(pending, regions_.wall(), functional, at, regions_.blend(), result);
  if constexpr (std::is_same_v<Motion, WallMotion<D>>)
    if (coefficients_.wall().feeds)
      start<P, Motion, true>(pending, regions_.wall(), functional, at, regions_.blend(),
                             [&result](const auto& rates) { result.part(Functional::rate_column) += rates[0]; });
}

template <int D, int P>
void Balance<D, P>::solid_integrals(const Evaluation<D>& at, PendingIntegrals& pending, Integrals& result) const {
  const SolidMotion motion{coefficients_.solid().density()};
  start_parts<P, NoMotion>(pending, regions_.solid(), motion, at, regions_.blend(), result);
  const SolidGravity& gravity = forces_.gravity();
  const int count = layout_.solid_rows() * layout_.row_size;
  for (std::size_t d = 0; d < gravity.force.size(); ++d) {
    const int first = layout_.displacement_offset(static_cast<int>(d));
    pending.start_sum(
        layout_.space(), gravity.weight, part(at.stage.displacement, first, first + count),
        [&result, force = gravity.force[d]](double sum) { result.part(SolidGravity::energy_column) -= force * sum; });
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
void Balance<D, P>::branch_integrals(const Stage& stage, PendingIntegrals& pending, Integrals& result) const {
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
      start<P, NoMotion>(pending, regions_.solid(), shear, at, regions_.blend(),
                         [&result, column, factor](const auto& s) { result.part(column) += factor * s[0]; });
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
void Balance<D, P>::start_readings(const Stage& stage, PendingIntegrals& pending,
                                   std::vector<NeedleReading>& readings) const {
  forces_.needles().start_readings(layout_, stage, pending, readings);
  pending.then([this, &readings] {
    for (NeedleReading& reading : readings) {
      for (double* number : {&reading.energy, &reading.power, &reading.power_on_solid}) *number *= regions_.turn();
      for (double& force : reading.force) force *= regions_.turn();
      if (layout_.axisymmetric()) reading.force[0] = 0;  // what points away from the axis cancels
    }
  });
}

/// @param needles  which are handed out before
template <int D, int P>
void Balance<D, P>::start_integrals(const Stage& stage, PendingIntegrals& pending, Integrals& result,
                                    const std::vector<NeedleReading>& needles) const {
  const Evaluation<D> at{layout_, stage, {}, {}};
  for (const auto& entry : terms_.pieces().list) entry.piece->add_integrals(at, pending, result);
  if (layout_.has_solid) solid_integrals(at, pending, result);
  if (layout_.branches > 0) branch_integrals(stage, pending, result);
  if (layout_.has_fluid)
    layout_.has_solid ? fluid_integrals<WallMotion<D>>(at, pending, result)
                      : fluid_integrals<NoMotion>(at, pending, result);
  pending.then([this, &result, &needles] {
    if (layout_.axisymmetric()) result.turn(regions_.turn());
    for (const NeedleReading& needle : needles) result.part(Needles<D>::energy_column) += needle.energy;
  });
}

template <int D, int P>
void Balance<D, P>::start_load_power(double time, const ConstArray& unknown, PendingIntegrals& pending,
                                     double& power) const {
  forces_.start_load_power(time, unknown, pending, power);
  pending.then([this, &power] { power *= regions_.turn(); });
}

template <int D, int P>
void Balance<D, P>::start_row(const Stage& stage, PendingIntegrals& pending, Measured& found) const {
  start_load_power(stage.time, stage.unknown, pending, found.load_power);
  start_readings(stage, pending, found.needles);
  start_integrals(stage, pending, found.integrals, found.needles);
}

template <int D, int P>
Integrals Balance<D, P>::integrals(const Stage& stage) const {
  Integrals result;
  std::vector<NeedleReading> needles;
  PendingIntegrals pending;
  start_readings(stage, pending, needles);
  start_integrals(stage, pending, result, needles);
  pending.finish();
  return result;
}

template <int D, int P>
std::vector<NeedleReading> Balance<D, P>::needle_readings(const Stage& stage) const {
  std::vector<NeedleReading> readings;
  PendingIntegrals pending;
  start_readings(stage, pending, readings);
  pending.finish();
  return readings;
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

template <int D, int P>
double Balance<D, P>::load_power(double time, const ConstArray& unknown) const {
  double power = 0;
  PendingIntegrals pending;
  start_load_power(time, unknown, pending, power);
  pending.finish();
  return power;
}

template class Balance<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
