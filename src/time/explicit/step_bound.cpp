#include "time/explicit/step_bound.hpp"

#include <cmath>
#include <limits>

#include "memory/start_teams.hpp"
#include "time/explicit/largest_rates.hpp"

namespace softwet {
namespace {

using namespace step_points;

using Worst = Kokkos::MaxLoc<double, int>::value_type;

/// The largest combined rate and its item.
template <class Point>
Worst worst_of(const Point& point, int items) {
  Worst worst;
  Kokkos::parallel_reduce("softwet::step_place", SmallBlocks(0, items), LargestPlace<Point>{point},
                          Kokkos::MaxLoc<double, int>(worst));
  return worst;
}

/// The fewest elements along an axis with ends, as end_symbols takes them.
template <int D>
int fewest_elements(const Layout<D>& l) {
  std::vector<int> all{l.solid_elements, l.axis[D - 1].elements() - l.solid_elements};
  for (int d = 0; d + 1 < D; ++d)
    if (!l.axis[d].periodic()) all.push_back(l.axis[d].elements());
  return fewest_that_matter(all);
}

template <int D>
JoinedElements joined_elements(const Layout<D>& l) {
  const int joint = l.axis[D - 1].joint();
  return joint == 0 ? JoinedElements{} : JoinedElements{joint, l.solid_elements - joint};
}

template <int D>
MassSymbols symbols_of_ends(const Layout<D>& l, int degree, MassKind kind) {
  const Coordinates coordinates = l.axisymmetric() ? Coordinates::axisymmetric : Coordinates::plane;
  return with_joint(end_symbols(degree, kind, fewest_elements(l), coordinates), degree, kind, joined_elements(l));
}

/// Whether nothing holds the velocity at some control point at an end of an axis.
template <int D>
bool has_free_end(const Layout<D>& l, const std::vector<double>& mask, int axis) {
  const int nodes = l.rows * l.row_size, last = l.axis[axis].functions() - 1;
  int stride = 1;
  for (int d = 0; d < axis; ++d) stride *= l.extent(d);
  bool found = false;
  for (int i = 0; i < nodes && !l.axis[axis].periodic(); ++i) {
    const int function = l.function(i / stride % l.extent(axis), axis);
    bool held = function != 0 && function != last;
    for (int c = 0; c < D; ++c) held = held || mask[c * nodes + i] == 0;
    found = found || !held;
  }
  return ranks::largest(found ? 1.0 : 0.0) > 0;
}

}  // namespace

template <int D, int P>
StepBound<D, P>::StepBound(const Regions<D>& regions, const Coefficients<D>& coefficients, MassKind kind,
                           StepFormula formula)
    : regions_(regions),
      coefficients_(coefficients),
      formula_(formula),
      inside_(inside_symbols(P, kind)),
      end_(symbols_of_ends<D>(regions.layout(), P, kind)),
      adds_axes_(kind == MassKind::consistent),
      found_("step_bound.found", found_numbers) {
  const Layout<D>& l = regions.layout();
  length_ = l.shortest();
  std::vector<double> near(l.scalar_size(), 0.0);
  constexpr int reach = P + 1;
  for (int i = 0; i < l.scalar_size(); ++i) {
    int rest = i;
    for (int d = 0; d < D; ++d) {
      const int extent = d == D - 1 ? l.fluid_rows() : l.extent(d), place = rest % extent;
      const int function = d == D - 1 ? place : l.function(place, d);
      const int last = (d == D - 1 ? extent : l.axis[d].functions()) - 1;
      rest /= extent;
      if (!l.axis[d].periodic() && (function < reach || function > last - reach)) near[i] = 1;
    }
  }
  if (!l.has_fluid) {
    const std::vector<double> mask = to_host(regions.mask());
    for (int d = 0; d < D; ++d) free_axis_[d] = has_free_end(l, mask, d);
  }
  near_end_ = to_device<Array>(near, "step_bound.near_end");
  for (int d = 0; d < D; ++d) {
    std::vector<double> places;
    for (int i = 0; i < l.extent(d); ++i) {
      double place = l.axis[d].greville(l.function(i, d));
      while (i > 0 && place <= places.back()) place += l.axis[d].length();  // a copy across a periodic side
      places.push_back(place);
    }
    greville_[d] = to_device<Array>(places, "step_bound.greville");
  }
  std::vector<double> blend;
  for (int row = 0; row < l.fluid_rows(); ++row)
    blend.push_back(l.has_solid ? regions.blend().value(l.axis[D - 1].greville(l.wall_row + row)) : 0.0);
  blend_ = to_device<Array>(blend, "step_bound.blend");
  stretch_ = Array("step_bound.stretch", l.row_size);
  Kokkos::deep_copy(stretch_, 1.0);
}

template <int D, int P>
template <bool Axial, class Solid>
auto StepBound<D, P>::solid_point(const Solid& solid, const ConstArray& displacement) const {
  const Layout<D>& l = regions_.layout();
  using Bound = SolidBound<D, std::decay_t<decltype(solid.material)>, Axial>;
  SolidPoint<D, Bound> point{.bound = Bound(solid, coefficients_.solid().fibres, formula_, coefficients_.solid().rates,
                                            end_, adds_axes_ ? D : 1, length_, free_axis_),
                             .displacement = displacement.data(),
                             .greville = {},
                             .extent = {},
                             .nodes = l.solid_rows() * l.row_size,
                             .row_size = l.row_size};
  point.bound.prestretch = coefficients_.solid().prestretch;
  for (int d = 0; d < D; ++d) {
    point.greville[d] = greville_[d];
    point.extent[d] = d == D - 1 ? l.solid_rows() : l.extent(d);
  }
  return point;
}

template <int D, int P>
template <class Visit>
void StepBound<D, P>::visit_points(const BoundState& s, const Visit& visit) const {
  const Layout<D>& l = regions_.layout();
  StretchOfColumn<D> column{.displacement = nullptr,
                            .greville = {},
                            .stretch = stretch_,
                            .extent = {},
                            .nodes = l.solid_rows() * l.row_size,
                            .slope = regions_.blend().slope()};
  if (l.has_solid && l.has_fluid) {
    column.displacement = s.displacement.data() + l.wall_shift();
    for (int d = 0; d < D; ++d) {
      column.greville[d] = greville_[d];
      column.extent[d] = l.extent(d);
    }
    if constexpr (host_algorithms) Kokkos::parallel_for("softwet::stretch", Items(0, l.row_size), column);
  }
  const auto with_fluid = [&](const auto& solid) {
    if (!l.has_fluid) return visit(NoPoint{}, solid);
    const FluidPoint<D> fluid{.velocity = s.unknown.data(),
                              .density = s.unknown.data() + l.density_offset(),
                              .moments = s.moments,
                              .sums = s.sums,
                              .column = column,
                              .blend = blend_,
                              .mask = part(regions_.mask(), l.density_offset(), l.potential_offset()),
                              .near_end = near_end_,
                              .fluid = coefficients_.fluid(),
                              .inside = inside_,
                              .end = end_,
                              .formula = formula_,
                              .row_size = l.row_size,
                              .nodes = l.rows * l.row_size,
                              .shift = l.fluid_shift(),
                              .axes = adds_axes_ ? D : 1,
                              .length = length_};
    visit(fluid, solid);
  };
  if (!l.has_solid) return with_fluid(NoPoint{});
  std::visit(
      [&](const auto& solid) {
        if constexpr (D == 2)
          if (l.axisymmetric()) return with_fluid(solid_point<true>(solid, s.displacement));
        with_fluid(solid_point<false>(solid, s.displacement));
      },
      coefficients_.solid().law);
}

template <int D, int P>
int StepBound<D, P>::numbers() {
  return found_numbers;
}

template <int D, int P>
void StepBound<D, P>::ask(const BoundState& state, const HostNumbers& found) const {
  const Layout<D>& l = regions_.layout();
  const VectorSpace space = l.space();
  const int width = space.end - space.begin;
  const ValuePoint values{.unknown = state.unknown.data(),
                          .stored = space.stored,
                          .begin = space.begin,
                          .width = width,
                          .first_density = l.density_offset(),
                          .last_density = l.potential_offset()};
  visit_points(state, [&](const auto& fluid, const auto& solid) {
    const LargestRates<std::decay_t<decltype(fluid)>, std::decay_t<decltype(solid)>> largest{
        .fluid = fluid,
        .solid = solid,
        .value = values,
        .fluid_points = l.scalar_size(),
        .solid_points = l.solid_rows() * l.row_size,
        .values = l.size() / space.stored * width};
    Kokkos::parallel_reduce("softwet::step_rates", SmallBlocks(0, largest.items()), largest, found.device);
  });
}

template <int D, int P>
StepRates StepBound<D, P>::rates(const HostNumbers& found) {
  std::array<double, mechanisms> all;
  std::copy_n(found.host.data(), int(mechanisms), all.begin());
  ranks::largest(all.data(), mechanisms);
  return {.combined = all[combined],
          .sound = all[sound],
          .capillarity = all[capillarity],
          .viscosity = all[viscosity],
          .stabilisation = all[stabilisation],
          .flow = all[flow],
          .elasticity = all[elasticity]};
}

template <int D, int P>
ValueRanges StepBound<D, P>::ranges(const HostNumbers& found) {
  double all[] = {found.host(not_finite), found.host(least_density), found.host(most_density)};
  ranks::largest(all, 3);
  return {all[0] == 0, -all[1], all[2]};
}

template <int D, int P>
StepRates StepBound<D, P>::rates(const BoundState& state) const {
  ask(state, found_);
  found_.ask();
  HostNumbers::wait();
  return rates(found_);
}

template <int D, int P>
std::array<double, D> StepBound<D, P>::place_of_largest(const BoundState& state) const {
  const Layout<D>& l = regions_.layout();
  std::array<double, D> place{};
  double largest = -1;
  const auto look = [&](const auto& point, int items, int first_row) {
    const Worst worst = worst_of(point, items);
    if (!(worst.val > largest)) return;
    largest = worst.val;
    for (int d = 0, rest = worst.loc; d < D; ++d) {
      const int extent = d == D - 1 ? items : l.extent(d);
      const double x = l.axis[d].greville(d == D - 1 ? first_row + rest : l.function(rest % extent, d)),
                   side = l.axis[d].length();
      place[d] = l.axis[d].periodic() ? std::fmod(x + side, side) : x;
      rest /= extent;
    }
  };
  visit_points(state, [&](const auto& fluid, const auto& solid) {
    if (l.has_fluid) look(fluid, l.scalar_size(), l.wall_row);
    if (l.has_solid) look(solid, l.solid_rows() * l.row_size, 0);
  });
  const bool here = ranks::largest(largest) == largest;
  for (double& x : place) x = ranks::largest(here ? x : -std::numeric_limits<double>::max());
  return place;
}

template class StepBound<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
