#include "time/step_bound.hpp"

#include <cmath>

namespace softwet {
namespace {

enum Mechanism { combined, sound, capillarity, viscosity, stabilisation, flow, elasticity, mechanisms };

/// Largest values of several numbers at once.
template <class Point>
struct LargestRates {
  using value_type = double[];
  unsigned value_count = mechanisms;
  Point point;

  KOKKOS_FUNCTION void init(double* best) const {
    for (int k = 0; k < mechanisms; ++k) best[k] = 0;
  }
  KOKKOS_FUNCTION void join(double* best, const double* other) const {
    for (int k = 0; k < mechanisms; ++k) best[k] = best[k] < other[k] ? other[k] : best[k];
  }
  KOKKOS_FUNCTION void operator()(int i, double* best) const {
    double found[mechanisms] = {};
    point(i, found);
    join(best, found);
  }
};

/// Derivative of a field along an axis at a control point, from its neighbour's control value.
KOKKOS_INLINE_FUNCTION double difference(const double* c, int i, int place, int extent, int stride,
                                         const ConstArray& greville) {
  const int from = place + 1 < extent ? place : place - 1, at = i + (from - place) * stride;
  return (c[at + stride] - c[at]) / (greville(from + 1) - greville(from));
}

template <int D>
struct FluidPoint {
  const double *velocity, *density;
  ConstArray moments, sums, stretch, blend, mask;
  Kokkos::View<const int*, Exec> near_end;
  NavierStokesKorteweg fluid;
  MassSymbols inside, end;
  StepFormula formula;
  int row_size, nodes, shift, axes;
  double length;

  KOKKOS_FUNCTION void operator()(int i, double* rate) const {
    if (mask(i) == 0) return;
    const bool ends = near_end(i) != 0;
    const auto of = [&](double MassSymbols::*symbol) { return ends ? end.*symbol : inside.*symbol; };
    const double inverse = stretch(i % row_size) / length, square = inverse * inverse;
    const double rho = Kokkos::max(density[i], fluid.gas.continuation), c2 = rho * fluid.gas.curvature(rho);
    const double g2 = fluid.capillarity * fluid.capillarity, many = axes;
    const double a = of(&MassSymbols::acoustic), c = of(&MassSymbols::capillary);
    const double c2_on = Kokkos::max(c2, 0.0);
    rate[sound] = Kokkos::sqrt(many * a * a * c2_on * square);
    rate[capillarity] = many * c * Kokkos::sqrt(g2 * rho) * square;
    const double wave = Kokkos::sqrt(rate[sound] * rate[sound] + rate[capillarity] * rate[capillarity]);
    const double inertia = Kokkos::max(moments(i) / sums(i), fluid.inertia_floor);
    const double k = many * of(&MassSymbols::viscous) * square;
    rate[viscosity] = 4.0 / 3 * fluid.viscosity / inertia * k;
    rate[stabilisation] = fluid.stabilisation * rho * rho * k * (c2_on / rho + g2 * k);
    double speed = 0;
    for (int d = 0; d < D; ++d) {
      const int at = d * nodes + shift + i, wall = d * nodes + shift + i % row_size;
      const double slip = velocity[at] - blend(i / row_size) * velocity[wall];
      speed += slip * slip;
    }
    rate[flow] = of(&MassSymbols::convective) * Kokkos::sqrt(many * speed) * inverse;
    rate[combined] = combine(wave, rate[viscosity], rate[stabilisation], rate[flow]);
  }

  KOKKOS_FUNCTION double combine(double w, double s, double e, double u) const {
    if (formula == StepFormula::runge_kutta) {
      const double turn = (w + u) / 1.73, decay = (s + e) / 2.51;
      return Kokkos::sqrt(turn * turn + decay * decay);
    }
    const double waves = 0.5 * (w + 0.6 * e + u);
    return formula == StepFormula::kick_drift ? Kokkos::max(waves + 0.25 * s, s) : waves;
  }
};

template <int D, class Material>
struct SolidPoint {
  Material material;
  const double* displacement;
  ConstArray greville[D];
  int extent[D];
  int nodes;
  double factor;  ///< frequency = factor sqrt(stiffness)
  double share;   ///< of the frequency in a rate of the scheme

  KOKKOS_FUNCTION void operator()(int i, double* rate) const {
    Matrix<double, D> gradient;
    int stride = 1;
    for (int d = 0; d < D; ++d) {
      for (int c = 0; c < D; ++c)
        gradient(c, d) =
            difference(displacement + c * nodes, i, i / stride % extent[d], extent[d], stride, greville[d]);
      stride *= extent[d];
    }
    double largest = 0;
    for (int axis = 0; axis < D; ++axis) {
      double sum[D] = {};
      for (int along = 0; along < D; ++along) {
        Matrix<Dual<double>, D> moved;
        for (int c = 0; c < D; ++c)
          for (int d = 0; d < D; ++d) moved(c, d) = Dual<double>(gradient(c, d), c == along && d == axis ? 1.0 : 0.0);
        const Matrix<Dual<double>, D> stress = material.first_piola(moved);
        for (int c = 0; c < D; ++c) sum[c] += Kokkos::abs(stress(c, axis).tangent);
      }
      for (int c = 0; c < D; ++c) largest = Kokkos::max(largest, sum[c]);
    }
    rate[elasticity] = factor * Kokkos::sqrt(largest);
    rate[combined] = share * rate[elasticity];
  }
};

/// stretch = 1 / the smallest singular value of F = I + (beta Grad d, slope d e_D) above a column, at the wall and on top.
template <int D>
struct StretchOfColumn {
  const double* displacement;  ///< of the wall's row
  ConstArray greville[D];
  Array stretch;
  int extent[D];
  int nodes;
  double slope;

  KOKKOS_FUNCTION void operator()(int i) const {
    double worst = 1;
    for (int wall = 0; wall < 2; ++wall) {
      Matrix<double, D> f;
      for (int c = 0; c < D; ++c) {
        int stride = 1;
        for (int d = 0; d + 1 < D; ++d) {
          f(c, d) = (c == d ? 1.0 : 0.0) + wall * difference(displacement + c * nodes, i, i / stride % extent[d],
                                                             extent[d], stride, greville[d]);
          stride *= extent[d];
        }
        f(c, D - 1) = (c == D - 1 ? 1.0 : 0.0) + slope * displacement[c * nodes + i];
      }
      const Matrix<double, D> cofactors = cofactor(f);
      const double volume = determinant(f, cofactors);
      // |F^{-1}|^2 is at most the largest row sum of F^{-1} F^{-T}.
      double largest = 0;
      for (int r = 0; r < D; ++r) {
        double sum = 0;
        for (int s = 0; s < D; ++s) {
          double entry = 0;
          for (int k = 0; k < D; ++k) entry += cofactors(k, r) * cofactors(k, s);
          sum += Kokkos::abs(entry);
        }
        largest = Kokkos::max(largest, sum);
      }
      worst = Kokkos::max(worst, Kokkos::sqrt(largest) / Kokkos::max(volume, 1e-3));
    }
    stretch(i) = worst;
  }
};

template <class Point>
StepRates largest_of(const Point& point, int items) {
  double found[mechanisms] = {};
  const Kokkos::View<double*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> result(found, mechanisms);
  LargestRates<Point> largest{mechanisms, point};
  Kokkos::parallel_reduce("softwet::step_rates", Items(0, items), largest, result);
  return {found[combined],      found[sound], found[capillarity], found[viscosity],
          found[stabilisation], found[flow],  found[elasticity]};
}

}  // namespace

template <int D, int P>
StepBound<D, P>::StepBound(const Model<D, P>& model, MassKind kind, StepFormula formula)
    : model_(model),
      formula_(formula),
      inside_(inside_symbols(P, kind)),
      end_(end_symbols(P, kind)),
      adds_axes_(kind == MassKind::consistent) {
  const Layout<D>& l = model.layout();
  length_ = l.axis[0].spacing();
  for (const Axis& axis : l.axis) length_ = std::min(length_, axis.spacing());
  std::vector<int> near(l.scalar_size(), 0);
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
  near_end_ = to_device<Kokkos::View<int*, Exec>>(near, "step_bound.near_end");
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
    blend.push_back(l.has_solid ? model.blend().value(l.axis[D - 1].greville(l.wall_row + row)) : 0.0);
  blend_ = to_device<Array>(blend, "step_bound.blend");
  stretch_ = Array("step_bound.stretch", l.row_size);
  Kokkos::deep_copy(stretch_, 1.0);
}

template <int D, int P>
StepRates StepBound<D, P>::rates(const ConstArray& unknown, const ConstArray& displacement, const ConstArray& moments,
                                 const ConstArray& sums) const {
  const Layout<D>& l = model_.layout();
  StepRates found;
  if (l.has_solid && l.has_fluid) {
    StretchOfColumn<D> column{
        displacement.data() + l.wall_shift(), {}, stretch_, {}, l.solid_rows() * l.row_size, model_.blend().slope()};
    for (int d = 0; d < D; ++d) {
      column.greville[d] = greville_[d];
      column.extent[d] = l.extent(d);
    }
    Kokkos::parallel_for("softwet::stretch", Items(0, l.row_size), column);
  }
  if (l.has_fluid) {
    const ConstArray mask = part(model_.mask(), l.density_offset(), l.potential_offset());
    const FluidPoint<D> point{unknown.data(),
                              unknown.data() + l.density_offset(),
                              moments,
                              sums,
                              stretch_,
                              blend_,
                              mask,
                              near_end_,
                              model_.fluid(),
                              inside_,
                              end_,
                              formula_,
                              l.row_size,
                              l.rows * l.row_size,
                              l.fluid_shift(),
                              adds_axes_ ? D : 1,
                              length_};
    found = largest_of(point, l.scalar_size());
  }
  if (l.has_solid)
    std::visit(
        [&](const auto& solid) {
          constexpr double margin = 1.05;  // waves along free and held sides are a little faster
          const double many = adds_axes_ ? D : 1, share = formula_ == StepFormula::runge_kutta ? 1 / 1.73 : 0.5;
          SolidPoint<D, std::decay_t<decltype(solid.material)>> point{
              solid.material,
              displacement.data(),
              {},
              {},
              l.solid_rows() * l.row_size,
              margin * end_.elastic * std::sqrt(many / solid.density) / length_,
              share};
          for (int d = 0; d < D; ++d) {
            point.greville[d] = greville_[d];
            point.extent[d] = d == D - 1 ? l.solid_rows() : l.extent(d);
          }
          const StepRates elastic = largest_of(point, l.solid_rows() * l.row_size);
          found.elasticity = elastic.elasticity;
          found.combined = std::max(found.combined, elastic.combined);
        },
        model_.solid());
  for (double StepRates::*rate :
       {&StepRates::combined, &StepRates::sound, &StepRates::capillarity, &StepRates::viscosity,
        &StepRates::stabilisation, &StepRates::flow, &StepRates::elasticity})
    found.*rate = ranks::largest(found.*rate);
  return found;
}

template class StepBound<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
