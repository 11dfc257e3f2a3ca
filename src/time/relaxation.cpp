#include "time/relaxation.hpp"

#include <cmath>

#include "case/error.hpp"
#include "case/text.hpp"
#include "field/vector.hpp"
#include "time/implicit_scheme.hpp"

namespace softwet {
namespace {

constexpr double rest = 1e-6;            ///< rate of change of a state at rest
constexpr double change_of_step = 0.02;  ///< of the fields, that a step aims at; a thin vapour may change by more
constexpr double longest = 200;          ///< step
constexpr int most_steps = 300;

/// Newton's method need not be accurate on the way, but its products must be: the steps are long.
Case loose(const Case& c) {
  Case loose = c;
  loose.time.scheme = implicit_scheme;
  loose.solver.jacobian = "exact";
  loose.solver.newton_rtol = std::max(c.solver.newton_rtol, 1e-4);
  return loose;
}

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
  Change(const Model<D, P>& model, const State& start)
      : model_(model),
        density_("relaxation.density", model.layout().scalar_size()),
        displacement_("relaxation.displacement", model.layout().solid_size()) {
    keep(start);
  }

  Changes from_last(const State& now) {
    const Layout<D>& l = model_.layout();
    Changes change;
    if (l.has_fluid) change = of_density(part(now.unknown, l.density_offset(), l.potential_offset()));
    if (l.has_solid) {
      combine(displacement_, 1, now.displacement, -1);
      const double height = l.has_fluid ? model_.wall_height() : l.axis[D - 1].length();
      const double root = std::sqrt(entries_of_patch(l, l.solid_size()) / D);
      change.fields = std::max(change.fields, norm(l.space(), displacement_) / root / height);
    }
    keep(now);
    return change;
  }

 private:
  Changes of_density(const ConstArray& now) {
    const double vapour = model_.state().density_vapour, liquid = model_.state().density_liquid;
    const VectorSpace space = model_.layout().space();
    const double root = std::sqrt(entries_of_patch(model_.layout(), model_.layout().scalar_size()));
    combine(density_, 1, now, -1);
    const double fields = norm(space, density_) / root / (liquid - vapour);
    // Four times: a small droplet has denser vapour around it than a large one (Kelvin).
    relative_in_vapour(density_, now, vapour, std::min(4 * vapour, 0.5 * (vapour + liquid)));
    return {fields, norm(space, density_) / root};
  }
  void keep(const State& now) {
    const Layout<D>& l = model_.layout();
    if (l.has_fluid) Kokkos::deep_copy(density_, part(now.unknown, l.density_offset(), l.potential_offset()));
    if (l.has_solid) Kokkos::deep_copy(displacement_, now.displacement);
  }

  const Model<D, P>& model_;
  Array density_, displacement_;
};

[[noreturn]] void give_up(const std::string& why) {
  throw Error(Exit::computation_failed,
              "the scene does not come to rest (time.start = \"equilibrium\"): " + why +
                  "; write time.start = \"initial\" to compute its motion from the state of the case file");
}

}  // namespace

template <int D, int P>
Relaxation relax(const Model<D, P>& model, const Case& c, State& state, double time,
                 const std::function<bool()>& interrupted, const std::function<void(const State&)>& watch) {
  const Case control = loose(c);
  const Judge<D, P> judge(model, control);
  ImplicitScheme<D, P> scheme(model, control, judge);
  Change<D, P> change(model, state);
  Relaxation done;
  const Array unused;
  for (double dt = c.time.dt_initial;;) {
    if (interrupted()) {
      done.interrupted = true;
      break;
    }
    if (done.steps == most_steps)
      give_up("after " + std::to_string(most_steps) + " steps its fields still change by " + short_text(done.rate, 2) +
              " of their range in a unit of time, where " + short_text(rest, 2) + " counts as rest");
    state.time = time - dt;  // a step ends no later than the first load begins
    scheme.initialise(state);
    const StepAttempt tried = scheme.attempt({state, unused, 0}, dt);
    if (!tried.refusal.empty()) {
      ++done.rejected;
      scheme.refuse(tried.refusal);
      dt *= 0.25;
      if (dt < c.time.dt_min)
        give_up(std::string(tried.refusal.text()) + ", even with the smallest step (time.dt_min)");
      continue;
    }
    scheme.accept(state);
    watch(state);
    const Changes size = change.from_last(state);
    ++done.steps;
    done.newton += tried.newton;
    done.krylov += tried.krylov;
    done.time += dt;
    done.rate = std::max(size.fields, size.vapour) / dt;
    if (done.rate < rest) break;
    dt = std::min(longest, dt * std::clamp(change_of_step / size.fields, 0.5, tried.laborious ? 1.0 : 2.0));
  }
  state.time = time;
  return done;
}

template Relaxation relax(const Model<SOFTWET_DIMENSION, SOFTWET_DEGREE>&, const Case&, State&, double,
                          const std::function<bool()>&, const std::function<void(const State&)>&);

}  // namespace softwet
