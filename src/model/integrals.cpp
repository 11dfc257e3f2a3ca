// Integrals of the state: the part of Model that history.csv is made of.
#include "field/vector.hpp"
#include "kernels/fluid/gravity.hpp"
#include "kernels/fluid/painted_wall.hpp"
#include "model/model.hpp"
#include "operator/integrate.hpp"

namespace softwet {

template <int D, int P>
template <class Motion>
void Model<D, P>::fluid_integrals(const Evaluation<D>& at, Integrals& result) const {
  using Volume = ReduceTask<D, FluidIntegrals, Motion>;
  Volume volume{fluid_region_, {fluid_}, {}, {}, {}};
  bind_fields(at, blend_, volume);
  const auto sum = reduce<P>(volume);
  result.mass = sum[FluidIntegrals::mass];
  result.energy_kinetic += sum[FluidIntegrals::kinetic];
  result.energy_bulk = sum[FluidIntegrals::bulk];
  result.energy_gradient = sum[FluidIntegrals::gradient];
  result.viscous = sum[FluidIntegrals::viscous];
  result.stabilisation = sum[FluidIntegrals::stabilisation];
  for (int d = 0; d < 3; ++d) result.momentum[d] += sum[FluidIntegrals::momentum + d];
  if (has_gravity_) {
    GravityEnergy gravity;
    for (int d = 0; d < D; ++d) gravity.force[d] = fluid_.force[d];
    ReduceTask<D, GravityEnergy, Motion> task{fluid_region_, gravity, {}, {}, {}};
    bind_fields(at, blend_, task);
    result.energy_gravity += reduce<P>(task)[0];
  }
  if (!has_wall_) return;
  if (painted_.values.data()) {
    wall_integrals<Motion>(PaintedWallIntegrals{wall_}, at, result);
  } else {
    wall_integrals<Motion>(WallIntegrals{wall_}, at, result);
  }
}

template <int D, int P>
template <class Motion, class Functional>
void Model<D, P>::wall_integrals(const Functional& functional, Evaluation<D> at, Integrals& result) const {
  ReduceTask<D, Functional, Motion> face{wall_region_, functional, {}, {}, {}};
  at.given = painted_.origin();
  bind_fields(at, blend_, face);
  result.energy_wall = reduce<P>(face)[0];
  if constexpr (std::is_same_v<Motion, WallMotion<D>>) {
    if (!wall_feeds_) return;
    for (int d = 0; d < D; ++d) face.motion.tangent[d] = face.motion.velocity[d];
    face.motion.scale = 1;
    result.wall_stretch = reduce<P, true>(face)[0];
  }
}

template <int D, int P>
void Model<D, P>::solid_integrals(const Evaluation<D>& at, Integrals& result) const {
  const double density = std::visit([](const auto& solid) { return solid.density; }, solid_);
  ReduceTask<D, SolidMotion, NoMotion> task{solid_region_, {density}, {}, {}, {}};
  bind_fields(at, blend_, task);
  const auto sum = reduce<P>(task);
  result.energy_kinetic += sum[SolidMotion::kinetic];
  for (int d = 0; d < 3; ++d) result.momentum[d] += sum[SolidMotion::momentum + d];
  const int count = layout_.solid_rows() * layout_.row_size;
  for (std::size_t d = 0; d < gravity_.force.size(); ++d) {
    const int first = layout_.displacement_offset(static_cast<int>(d));
    result.energy_gravity -=
        gravity_.force[d] * dot(layout_.space(), gravity_.weight, part(at.stage.displacement, first, first + count));
  }
}

template <int D, int P>
Integrals Model<D, P>::integrals(const Stage& stage) const {
  Integrals result;
  const Evaluation<D> at{layout_, stage, {}, {}};
  for (const auto& entry : pieces_.list) entry.piece->add_integrals(at, result);
  if (layout_.has_solid) solid_integrals(at, result);
  if (!layout_.has_fluid) return result;
  if (layout_.has_solid) {
    fluid_integrals<WallMotion<D>>(at, result);
  } else {
    fluid_integrals<NoMotion>(at, result);
  }
  return result;
}

template <int D, int P>
std::array<double, FluidContents::count> Model<D, P>::fluid_contents(const Stage& stage) const {
  const Evaluation<D> at{layout_, stage, {}, {}};
  const auto over = [&](auto motion) {
    ReduceTask<D, FluidContents, decltype(motion)> task{fluid_region_, {}, motion, {}, {}};
    bind_fields(at, blend_, task);
    return reduce<P>(task);
  };
  return layout_.has_solid ? over(WallMotion<D>{}) : over(NoMotion{});
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
  ReduceTask<D, InvertedSolid, NoMotion> task{solid_region_, {}, {}, {}, {}};
  bind_fields(Evaluation<D>{layout_, stage, {}, {}}, blend_, task);
  faults.inverted = reduce<P>(task)[0];
  return faults;
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
  return power;
}

template Integrals Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::integrals(const Stage&) const;
template Filling Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::filling(const Stage&) const;
template MeshFaults Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::faults(const Stage&) const;
template double Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>::load_power(double, const ConstArray&) const;

}  // namespace softwet
