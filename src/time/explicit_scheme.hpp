// Runge-Kutta schemes on a scene: largest stable step, states and moments.
#pragma once

#include "time/judge.hpp"
#include "time/runge_kutta.hpp"
#include "time/semi_discrete.hpp"

namespace softwet {

/// The spectral radius of the linearised rates limits the step. It is measured by power iteration on differences of rates,
/// kept for a number of steps, and measured anew after a refused step.
template <int D, int P>
class ExplicitScheme final : public Scheme<D, P> {
 public:
  ExplicitScheme(const Model<D, P>&, const Case&, const Judge<D, P>&);

  void initialise(State& state) override { system_.set_moments(state); }
  StepAttempt attempt(const StepHistory&, double dt) override;
  void accept(State& state) override;
  void refuse() override { known_rates_ = false, age_ = most_age; }
  double largest_step(const State&) override;
  SolverCounts& counts() override { return counts_; }

 private:
  static constexpr int most_age = 10;  ///< steps after which the spectral radius is measured again

  std::string rates(double t, const Array& y, const Array& out);
  /// Fills y and its rates from a state, unless they are those of the last accepted step.
  std::string begin(const State&);
  void measure_radius(double t);
  /// One power iteration: the direction becomes its product with the Jacobian of the rates, over its length.
  /// @return that length; 0 where there is none
  double grow_direction(double t);

  const Judge<D, P>& judge_;
  SemiDiscrete<D, P> system_;
  std::unique_ptr<RungeKutta> scheme_;
  Array y_, rates_, next_, next_rates_, probe_, direction_;
  double end_ = 0, radius_ = 0;
  bool known_rates_ = false;
  int age_ = most_age;
  SolverCounts counts_;
};

}  // namespace softwet
