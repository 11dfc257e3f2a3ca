#include "time/rest/growth.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "field/ghosts.hpp"
#include "scene/greville_points.hpp"
#include "scene/initial.hpp"
#include "solver/krylov/gram_schmidt.hpp"
#include "solver/krylov/ritz.hpp"
#include "time/rest/rest_control.hpp"
#include "time/rest/still_steps.hpp"

namespace softwet {
namespace {

constexpr double steps[] = {200, 50,
                            12};  ///< of backward Euler; a shorter one where linear solves fail or no mode stands out
constexpr int most_directions = 40;   ///< of Arnoldi's method
constexpr int least_directions = 10;  ///< before it counts that no other mode has a factor that counts
constexpr std::size_t wanted = 2;     ///< modes
constexpr double smallest = 0.01;     ///< factor of a mode that counts
constexpr double digits = 0.01;       ///< of a rate
constexpr double least_error = 1e-7;  ///< of a rate, where that is larger than its digits
constexpr double amplitude = 1e-5;    ///< of the disturbance, root of its mean square, over the ranges of the fields

/// A function of position that no mirror maps onto itself.
double without_symmetry(const std::array<double, 3>& x, const std::vector<double>& size, int own) {
  double value = 1;
  for (std::size_t d = 0; d < size.size(); ++d)
    value *= std::cos((1.7 + 0.6 * d) * x[d] / size[d] + 0.5 + 0.3 * own) + 0.4 * std::sin(5.1 * x[d] / size[d] + own);
  return value;
}

/// A rate, and how far it may be off.
struct Rate {
  std::complex<double> value;
  double error;
};

/// The rates of the modes that the projection of backward Euler has, the largest real part first.
std::vector<Rate> rates_of(const std::vector<std::vector<double>>& columns, double step) {
  std::vector<Rate> rates;
  for (const RitzValue& r : ritz_values(columns)) {
    const double size = std::abs(r.value);
    if (size > smallest) rates.push_back({(1.0 - 1.0 / r.value) / step, r.error / (size * size * step)});
  }
  std::sort(rates.begin(), rates.end(), [](const Rate& a, const Rate& b) { return a.value.real() > b.value.real(); });
  return rates;
}

/// The first rates, as many as are wanted, up to one that is not accurate yet.
std::vector<std::complex<double>> found(const std::vector<Rate>& rates) {
  std::vector<std::complex<double>> values;
  for (const Rate& r : rates) {
    if (values.size() == wanted || r.error > std::max(digits * std::abs(r.value.real()), least_error)) break;
    values.push_back(r.value);
  }
  return values;
}

/// Small disturbances of a state of rest: velocities and density, and behind them the displacement.
template <int D, int P>
class Disturbances {
 public:
  Disturbances(const Scene<D, P>& scene, const Case& c, const State& rest, double step)
      : scene_(scene),
        layout_(scene.layout()),
        judge_(scene, c),
        scheme_(scene, c, judge_),
        rest_(rest),
        step_(step),
        near_(empty_state(layout_)),
        right_("growth.right", layout_.size()),
        work_("growth.work", layout_.size()),
        uniform_("growth.uniform", layout_.scalar_size()),
        volume_(layout_.has_fluid ? scene.balance().filling(stage_at(layout_, rest)).volume : 0) {
    Kokkos::deep_copy(uniform_, 1.0);
  }

  int flow() const { return layout_.potential_offset(); }  ///< values of velocities and density
  int size() const { return flow() + layout_.solid_size(); }

  /// Weights of the squares in norms: a change by the range of a field counts the same in each field, and a velocity as
  /// much as the displacement after a unit of time.
  RangeFactors weights() const {
    RangeFactors w;
    const double height = layout_.axis[D - 1].length();
    w.add(0, layout_.density_offset(), 1 / (height * height));
    const Coexistence& phases = scene_.coefficients().coexistence();
    if (layout_.has_fluid)
      w.add(layout_.density_offset(), flow(), std::pow(phases.density_liquid - phases.density_vapour, -2));
    if (layout_.has_solid) w.add(flow(), size(), 1 / (height * height));
    return w;
  }

  /// One that all modes have a part in.
  void start(const Case& c, const Array& z) {
    const Layout<D>& l = layout_;
    std::vector<double> values(size(), 0.0);
    for (int k = 0; k <= D; ++k) {
      if (k == D && !l.has_fluid) break;
      const int first = k < D ? 0 : l.wall_row, offset = k < D ? l.velocity_offset(k) : l.density_offset();
      const std::vector<double> of_field = control_values(
          l, [&](const std::array<double, 3>& x) { return without_symmetry(x, c.domain.size, k); }, first,
          k < D ? l.rows : l.fluid_rows());
      std::copy(of_field.begin(), of_field.end(), values.begin() + offset);
    }
    Kokkos::deep_copy(z, to_device<Array>(values, "growth.start"));
    multiply(Kokkos::subview(z, Kokkos::make_pair(0, l.velocity_size())), part(scene_.mask(), 0, l.velocity_size()));
  }

  /// out = B z, less the mass of z: that alone would stay for ever. @return false: a linear solve failed
  bool carry(const Array& z, const Array& out) {
    const double size = amplitude * std::sqrt(entries_of_patch(layout_, flow()));
    const double mass = missing(z, size, right_) - missing(z, -size, work_);
    combine(right_, -0.5 / size, work_, 0.5 / size);
    const NewtonResult solved = scheme_.respond(rest_, step_, right_, work_);
    krylov += solved.krylov;
    const Layout<D>& l = layout_;
    Kokkos::deep_copy(Exec(), out, z);
    Kokkos::deep_copy(Exec(), Kokkos::subview(out, Kokkos::make_pair(0, flow())), part(work_, 0, flow()));
    const int count = l.solid_rows() * l.row_size;
    for (int d = 0; d < D && l.has_solid; ++d)
      add_scaled(out, flow() + l.displacement_offset(d), step_,
                 part(work_, l.velocity_offset(d), l.velocity_offset(d) + count));
    if (l.has_fluid) add_scaled(out, l.density_offset(), -0.5 * mass / size / volume_, uniform_);
    return solved.converged;
  }

  long krylov = 0;

 private:
  /// near_ = rest + factor z
  void disturb(const Array& z, double factor) {
    Kokkos::deep_copy(Exec(), near_.unknown, rest_.unknown);
    add_scaled(near_.unknown, 0, factor, part(z, 0, flow()));
    Kokkos::deep_copy(Exec(), near_.displacement, rest_.displacement);
    add_scaled(near_.displacement, 0, factor, part(z, flow(), size()));
    near_.time = rest_.time;
  }
  /// What a step from rest + factor z that ends at rest leaves of its equations. @return the mass that it starts with
  double missing(const Array& z, double factor, const Array& out) {
    disturb(z, factor);
    scheme_.initialise(near_);
    scheme_.integrator().begin_still(near_, step_);
    scheme_.integrator().residual(rest_.unknown, out);
    return layout_.has_fluid ? total(layout_.space(), near_.moment) : 0;
  }

  const Scene<D, P>& scene_;
  const Layout<D>& layout_;
  Judge<D, P> judge_;
  StillSteps<D, P> scheme_;
  const State& rest_;
  double step_;
  State near_;
  Array right_, work_, uniform_;
  double volume_;  ///< of the fluid
};

/// The rates from steps of one length; none where a linear solve fails, or where all modes oscillate or decay so fast
/// that none stands out.
template <int D, int P>
std::optional<Growth> growth_by(double step, const Scene<D, P>& scene, const Case& control, const State& rest,
                                const std::function<bool()>& interrupted) {
  Disturbances<D, P> disturbances(scene, control, rest, step);
  GramSchmidt<double> basis("growth.basis", scene.layout().space(), disturbances.size(), most_directions + 1);
  basis.set_weights(disturbances.weights());
  Array first("growth.first", disturbances.size());
  disturbances.start(control, first);
  basis.begin(first, basis.length_of(first));
  Growth growth;
  std::vector<std::vector<double>> columns;
  for (int j = 0; j < most_directions; ++j) {
    if (interrupted()) {
      growth.rates.clear();
      growth.why = "the search was stopped";
      return growth;
    }
    if (!disturbances.carry(basis[j], basis[j + 1])) return {};
    ++growth.steps;
    growth.krylov = disturbances.krylov;
    basis.add();
    if (basis.waits()) basis.finish();
    columns.push_back(basis.column(j));
    const std::vector<Rate> rates = rates_of(columns, step);
    growth.rates = found(rates);
    if (j >= least_directions && rates.empty()) return {};
    const bool no_other = j >= least_directions && !rates.empty() && growth.rates.size() == rates.size();
    if (columns[j][j + 1] == 0 || growth.rates.size() == wanted || no_other) break;
  }
  if (growth.rates.empty())
    growth.why = "its fastest mode was not found in " + std::to_string(growth.steps) + " steps of a disturbance";
  return growth;
}

}  // namespace

template <int D, int P>
Growth growth_at_rest(const Scene<D, P>& scene, const Case& c, const State& rest,
                      const std::function<bool()>& interrupted) {
  const Case control = rest_control(c);
  for (const double step : steps)
    if (const std::optional<Growth> growth = growth_by<D, P>(step, scene, control, rest, interrupted)) return *growth;
  Growth none;
  none.why = "linear solves failed, or no mode stands out in steps of 12 units of time";
  return none;
}

template Growth growth_at_rest(const Scene<SOFTWET_DIMENSION, SOFTWET_DEGREE>&, const Case&, const State&,
                               const std::function<bool()>&);

}  // namespace softwet
