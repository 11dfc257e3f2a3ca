#include "time/rest/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/text.hpp"
#include "field/vector.hpp"
#include "time/rest/rest_control.hpp"
#include "time/rest/still_steps.hpp"

namespace softwet {
namespace {

constexpr double rest = 1e-6;           ///< rate of change that counts as rest where Newton's method gets no farther
constexpr double change_of_step = 0.1;  ///< of the fields, that a step aims at; a thin vapour may change by more
constexpr double still = 1e-5;          ///< change of the fields in a step that brings nothing
constexpr double slow = 1e-6;           ///< mean speed, root of its square: above it a steady state flows
constexpr double endless = 1e12;        ///< step
constexpr int most_idle = 12;           ///< steps and refusals in a row, at rest, that bring nothing
constexpr int most_steps = 200;

/// That a steady state is none of rest; empty where nothing moves.
template <int D>
std::string flow_text(const Layout<D>& l, const State& state) {
  const int size = l.velocity_size();
  const double speed = norm(l.space(), part(state.unknown, 0, size)) / std::sqrt(entries_of_patch(l, size) / D);
  if (speed < slow) return "";
  return "its fields do not change, but it flows, with a mean speed of " + short_text(speed, 2);
}

/// How long steps are.
struct StepLength {
  double dt;                    ///< of the next step
  double aim = change_of_step;  ///< change of the fields in a step
  double rate = 0;              ///< of change of the fields in the last step

  void accept(const StepAttempt& step, double change) {
    const double of_effort = step.newton <= 4 ? 10 : step.newton <= 6 ? 3 : step.newton <= 9 ? 1.5 : 1;
    rate = change / dt;
    dt = std::min(endless, dt * std::clamp(aim / change, 0.5, of_effort));
    aim = std::min(change_of_step, 1.2 * aim);
  }
  /// A droplet that creeps is followed by steps in which it moves by half of what was too far.
  void refuse() {
    if (rate * dt > still) aim = std::min(aim, std::max(0.5 * rate * dt, 10 * still));
    dt *= 0.25;
  }
};

/// x(i) /= density(i) where the density is below `most`, that is in the vapour, and 0 elsewhere.
void relative_in_vapour(const Array& x, const ConstArray& density, double least, double most) {
  Kokkos::parallel_for(
      "softwet::relative_in_vapour", Items(0, x.extent(0)), KOKKOS_LAMBDA(int i) {
        const double rho = density(i) < least ? least : density(i);
        x(i) = rho < most ? x(i) / rho : 0.0;
      });
}

/// Changes from one state to the next, relative.
struct Changes {
  double fields = 0;  ///< of the density and the displacement, to their range
  double vapour = 0;  ///< of the density of the vapour, to itself
};

template <int D, int P>
class Change {
 public:
  Change(const Scene<D, P>& scene, const State& start)
      : scene_(scene),
        density_("relaxation.density", scene.layout().scalar_size()),
        displacement_("relaxation.displacement", scene.layout().solid_size()) {
    keep(start);
  }

  Changes from_last(const State& now) {
    const Layout<D>& l = scene_.layout();
    Changes change;
    if (l.has_fluid) change = of_density(part(now.unknown, l.density_offset(), l.potential_offset()));
    if (l.has_solid) {
      combine(displacement_, 1, now.displacement, -1);
      const double height = l.has_fluid ? scene_.regions().wall_height() : l.axis[D - 1].length();
      const double root = std::sqrt(entries_of_patch(l, l.solid_size()) / D);
      change.fields = std::max(change.fields, norm(l.space(), displacement_) / root / height);
    }
    keep(now);
    return change;
  }

 private:
  Changes of_density(const ConstArray& now) {
    const Coexistence& phases = scene_.coefficients().coexistence();
    const double vapour = phases.density_vapour, liquid = phases.density_liquid;
    const VectorSpace space = scene_.layout().space();
    const double root = std::sqrt(entries_of_patch(scene_.layout(), scene_.layout().scalar_size()));
    combine(density_, 1, now, -1);
    const double fields = norm(space, density_) / root / (liquid - vapour);
    // Four times: a small droplet has denser vapour around it than a large one (Kelvin).
    relative_in_vapour(density_, now, vapour, std::min(4 * vapour, 0.5 * (vapour + liquid)));
    return {fields, norm(space, density_) / root};
  }
  void keep(const State& now) {
    const Layout<D>& l = scene_.layout();
    if (l.has_fluid) Kokkos::deep_copy(density_, part(now.unknown, l.density_offset(), l.potential_offset()));
    if (l.has_solid) Kokkos::deep_copy(displacement_, now.displacement);
  }

  const Scene<D, P>& scene_;
  Array density_, displacement_;
};

}  // namespace

template <int D, int P>
Relaxation relax(const Scene<D, P>& scene, const Case& c, State& state, const std::function<bool()>& interrupted,
                 const std::function<void(const State&, const Relaxation&)>& watch) {
  const Case control = rest_control(c);
  const Judge<D, P> judge(scene, control);
  StillSteps<D, P> scheme(scene, control, judge);
  Change<D, P> change(scene, state);
  Relaxation done;
  const auto ended = [&] {
    done.why = flow_text(scene.layout(), state);
    return done;
  };
  scheme.initialise(state);
  StepLength length{c.time.dt_initial};
  double least = std::numeric_limits<double>::infinity();
  for (int idle = 0; done.steps < most_steps;) {
    done.interrupted = interrupted();
    if (done.interrupted) return done;
    if (idle >= most_idle && done.rate < rest) return ended();
    const double dt = length.dt;
    const Settling tried = scheme.settle(state, dt);
    done.refusal = tried.step.refusal;
    if (!done.refusal.empty()) {
      ++done.rejected;
      idle += done.steps > 0 && done.rate < rest ? 1 : 0;
      length.refuse();
      if (length.dt >= c.time.dt_min) continue;
      done.why = std::string(done.refusal.text()) + ", even with the smallest step (time.dt_min)";
      return done;
    }
    scheme.accept(state);
    const Changes size = change.from_last(state);
    ++done.steps;
    done.newton += tried.step.newton;
    done.krylov += tried.step.krylov;
    done.time += dt;
    done.rate = std::max(size.fields, size.vapour) / dt;
    done.excess = tried.excess;
    watch(state, done);
    const bool solved = tried.excess < digits_of_rest, long_step = !scene.layout().has_solid || dt >= moderate_step;
    if (solved && tried.still && long_step) return ended();
    idle = tried.excess < 0.5 * least || done.rate >= rest || size.fields > still ? 0 : idle + 1;
    least = std::min(least, tried.excess);
    length.accept(tried.step, size.fields);
    if (solved) length.dt = std::max(length.dt, moderate_step);
  }
  if (done.rate < rest) return ended();
  done.why = "after " + std::to_string(most_steps) + " steps its fields still change by " + short_text(done.rate, 2) +
             " of their range in a unit of time, where less than " + short_text(rest, 2) + " counts as rest";
  return done;
}

template Relaxation relax(const Scene<SOFTWET_DIMENSION, SOFTWET_DEGREE>&, const Case&, State&,
                          const std::function<bool()>&, const std::function<void(const State&, const Relaxation&)>&);

}  // namespace softwet
