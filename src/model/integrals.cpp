// Integrals of the state: the part of Model that history.csv is made of.
#include "field/vector.hpp"
#include "kernels/fluid/gravity.hpp"
#include "kernels/functional/liquid_volume.hpp"
#include "model/coordinates.hpp"
#include "model/liquid_volume.hpp"
#include "model/model.hpp"
#include "operator/integrate.hpp"

namespace softwet {
namespace {

/// The integrals of a functional in the coordinates of the scene; with Rate the rates at which the motion of the wall changes them.
template <int P, class Motion, bool Rate = false, int D, class Functional>
std::array<double, Functional::count> integrate(const Region<D>& region, const Functional& functional,
                                                const Evaluation<D>& at, const Blend& blend) {
  return in_coordinates_of(at.layout, functional, [&](const auto& integrand) {
    ReduceTask<D, std::remove_cvref_t<decltype(integrand)>, Motion> task{region, integrand, {}, {}, {}};
    bind_fields(at, blend, task);
    if constexpr (Rate) {
      for (int d = 0; d < D; ++d) task.motion.tangent[d] = task.motion.velocity[d];
      task.motion.scale = 1;
    }
    return reduce<P, Rate>(task);
  });
}

}  // namespace

template <int D, int P>
template <class Motion>
void Model<D, P>::fluid_integrals(const Evaluation<D>& at, Integrals& result) const {
  result.add<FluidIntegrals>(integrate<P, Motion>(fluid_region_, FluidIntegrals{fluid_}, at, blend_));
  if (has_gravity_) {
    GravityEnergy gravity;
    for (int d = 0; d < D; ++d) gravity.force[d] = fluid_.force[d];
    result.add<GravityEnergy>(integrate<P, Motion>(fluid_region_, gravity, at, blend_));
  }
  if (!has_wall_) return;
  if (wall_stretch_exponent_ > 0) {
    if constexpr (std::is_same_v<Motion, WallMotion<D>>)
      wall_integrals<Motion>(StretchedWallIntegrals{{{wall_}}, wall_stretch_exponent_}, at, result);
  } else if (painted_.values.data()) {
    wall_integrals<Motion>(PaintedWallIntegrals{{wall_}}, at, result);
  } else {
    wall_integrals<Motion>(WallIntegrals{wall_}, at, result);
  }
}

template <int D, int P>
template <class Motion, class Functional>
void Model<D, P>::wall_integrals(const Functional& functional, Evaluation<D> at, Integrals& result) const {
  at.given = painted_.origin();
  result.add<Functional>(integrate<P, Motion>(wall_region_, functional, at, blend_));
  if constexpr (std::is_same_v<Motion, WallMotion<D>>)
    if (wall_feeds_)
      result.part(Functional::rate_column) += integrate<P, Motion, true>(wall_region_, functional, at, blend_)[0];
}

template <int D, int P>
void Model<D, P>::solid_integrals(const Evaluation<D>& at, Integrals& result) const {
  const double density = std::visit([](const auto& solid) { return solid.density; }, solid_);
  result.add<SolidMotion>(integrate<P, NoMotion>(solid_region_, SolidMotion{density}, at, blend_));
  const int count = layout_.solid_rows() * layout_.row_size;
  for (std::size_t d = 0; d < gravity_.force.size(); ++d) {
    const int first = layout_.displacement_offset(static_cast<int>(d));
    result.part(SolidGravity::energy_column) -=
        gravity_.force[d] * dot(layout_.space(), gravity_.weight, part(at.stage.displacement, first, first + count));
  }
}

template <int D, int P>
void Model<D, P>::branch_integrals(const Stage& stage, Integrals& result) const {
  if (!stage.memory.data()) return;
  const int size = layout_.solid_size();
  Stage of_branch = stage;
  of_branch.lag = Array("integrals.lag", size);
  const Evaluation<D> at{layout_, of_branch, {}, {}};
  const auto square = [&] { return integrate<P, NoMotion>(solid_region_, ShearSquare{}, at, blend_)[0]; };
  for (int i = 0; i < branches_.count; ++i) {
    Kokkos::deep_copy(Exec(), of_branch.lag, stage.displacement);
    add_scaled(of_branch.lag, 0, -1, part(stage.memory, i * size, (i + 1) * size));
    result.part(ShearSquare::energy_column) += branches_.modulus[i] * square();
    const double moving = branches_.share_of_velocity(i, stage.memory_shift);
    combine(of_branch.lag, 1 - moving, part(stage.memory_rate, i * size, (i + 1) * size), 0);
    for (int d = 0; d < D; ++d)
      add_scaled(of_branch.lag, layout_.displacement_offset(d), moving,
                 part(stage.unknown, layout_.velocity_offset(d), layout_.velocity_offset(d) + size / D));
    result.part(ShearSquare::dissipation_column) += 2 * branches_.modulus[i] * branches_.time[i] * square();
  }
}

template <int D, int P>
std::vector<NeedleReading> Model<D, P>::needle_readings(const Stage& stage) const {
  std::vector<NeedleReading> readings = needles_.readings(layout_, stage);
  for (NeedleReading& reading : readings) {
    for (double* number : {&reading.energy, &reading.power, &reading.power_on_solid}) *number *= turn();
    for (double& force : reading.force) force *= turn();
    if (layout_.axisymmetric) reading.force[0] = 0;  // what points away from the axis cancels
  }
  return readings;
}

template <int D, int P>
Integrals Model<D, P>::integrals(const Stage& stage) const {
  Integrals result;
  const Evaluation<D> at{layout_, stage, {}, {}};
  for (const auto& entry : pieces_.list) entry.piece->add_integrals(at, result);
  if (layout_.has_solid) solid_integrals(at, result);
  if (branches_.count > 0) branch_integrals(stage, result);
  if (layout_.has_fluid)
    layout_.has_solid ? fluid_integrals<WallMotion<D>>(at, result) : fluid_integrals<NoMotion>(at, result);
  if (layout_.axisymmetric) result.turn(turn());
  for (const NeedleReading& reading : needle_readings(stage)) result.part(Needles<D>::energy_column) += reading.energy;
  return result;
}

template <int D, int P>
std::array<double, FluidContents::count> Model<D, P>::fluid_contents(const Stage& stage) const {
  const Evaluation<D> at{layout_, stage, {}, {}};
  return layout_.has_solid ? integrate<P, WallMotion<D>>(fluid_region_, FluidContents{}, at, blend_)
                           : integrate<P, NoMotion>(fluid_region_, FluidContents{}, at, blend_);
}

template <int D, int P>
Filling Model<D, P>::filling(const Stage& stage) const {
  const auto sum = fluid_contents(stage);
  return {sum[FluidContents::mass], sum[FluidContents::volume]};
}

template <int D, int P>
MeshFaults Model<D, P>::faults(const Stage& stage) const {
  MeshFaults faults;
  if (!layout_.has_solid) return faults;  // nothing moves the mesh
  if (layout_.has_fluid) faults.folded = fluid_contents(stage)[FluidContents::folded];
  const Evaluation<D> at{layout_, stage, {}, {}};
  faults.inverted = integrate<P, NoMotion>(solid_region_, InvertedSolid{}, at, blend_)[0];
  return faults;
}

template <int D, int P>
double liquid_volume(const Model<D, P>& model, const Stage& stage) {
  if (!model.layout().has_fluid) return 0;
  const LiquidVolume liquid{model.state().density_vapour, model.state().density_liquid};
  const Evaluation<D> at{model.layout(), stage, {}, {}};
  const auto sum = model.layout().has_solid
                       ? integrate<P, WallMotion<D>>(model.fluid_region(), liquid, at, model.blend())
                       : integrate<P, NoMotion>(model.fluid_region(), liquid, at, model.blend());
  return model.turn() * sum[0];
}

template <int D, int P>
double Model<D, P>::load_power(double time, const ConstArray& unknown) const {
  double power = 0;
  for (const LoadVector<D>& load : loads_) {
    const std::vector<double> force = load.force(time);
    const ConstArray weight = load.weight(layout_, time);
    const int count = static_cast<int>(weight.extent(0));
    for (int d = 0; d < D; ++d) {
      const int first = layout_.velocity_offset(d);
      if (force[d] != 0) power += force[d] * dot(layout_.space(), weight, part(unknown, first, first + count));
    }
  }
  return turn() * power;
}

template Integrals Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::integrals(const Stage&) const;
template std::vector<NeedleReading> Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::needle_readings(const Stage&) const;
template double liquid_volume(const Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>&, const Stage&);
template Filling Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::filling(const Stage&) const;
template MeshFaults Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::faults(const Stage&) const;
template double Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::load_power(double, const ConstArray&) const;

}  // namespace softwet
