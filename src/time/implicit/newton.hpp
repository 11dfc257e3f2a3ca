// Inexact Newton-Krylov with a lagged preconditioner.
#pragma once

#include <functional>
#include <string>
#include <variant>

#include "case/refusal.hpp"
#include "field/layout.hpp"
#include "solver/krylov/gmres.hpp"
#include "solver/preconditioner.hpp"
#include "time/implicit/solid_part.hpp"
#include "time/step/solver_counts.hpp"

namespace softwet {

enum class JacobianKind { exact, difference };

struct NewtonControl {
  double rtol = 1e-6;   ///< of the weighted residual, relative to the start of the step
  double atol = 1e-10;  ///< accepted error of velocity and density, sets a floor for the residual
  int max = 10;
  double krylov_rtol = 1e-2;  ///< tightest forcing term; early iterations ask for less
  int krylov_max = 200;
  JacobianKind jacobian = JacobianKind::exact;
};

struct NewtonResult {
  bool converged = false;
  int iterations = 0, krylov = 0;
  double reduction = 1;
  Refusal refusal;  ///< why it failed
};

/// How much a lagged preconditioner has wasted. Linear solves that together gain four digits, about those of a step, make a
/// window; one solve would be no measure, because those of a step differ. Waste are the iterations of a window above those of
/// the best one so far and a third more. When it reaches a quarter of the cost of a build a new preconditioner is due
/// (docs/solver_choices.md tells why). Where a new one is no better than the old one was at its end, it is kept twice as long,
/// up to four times.
class Wear {
 public:
  void renew();
  void add(const KrylovResult& linear);
  /// Whether a new preconditioner is due, where a build costs as much as so many iterations.
  bool due(double cost) const { return waste_ >= allowed(cost); }
  /// Iterations of a solve to `tolerance` at which one becomes due; the solve is given up then.
  int patience(double tolerance, double cost) const;
  void visit_memory(StepMemory&);

 private:
  double allowed(double cost) const { return 0.25 * times_ * cost; }

  double best_ = 0, last_ = 0;          ///< iterations per digit of windows; 0: none is complete
  double iterations_ = 0, digits_ = 0;  ///< of the window that is not
  double waste_ = 0;
  double before_ = 0;  ///< iterations per digit at the end of the preconditioner before; 0: there was none
  int times_ = 1;      ///< how long a preconditioner is kept, see above
};

/// GMRES and the vectors of a linear solve, in one precision.
template <class Real>
struct LinearSpace {
  LinearSpace(const VectorSpace& space, int size, int restart)
      : gmres(space, size, restart), step("newton.step", size) {
    if (!std::is_same_v<Real, double>) right = ArrayOf<Real>("newton.right", size);
  }
  GmresOf<Real> gmres;
  ArrayOf<Real> right, step;  ///< the residual, where it is of another precision; and the solution
};

/// The nonlinear system of one step, as Newton sees it.
struct NonlinearSystem {
  std::function<void(const Array& x, const Array& r)> residual;
  std::function<void(const Array& z, const Array& out)> product;  ///< out = A z, with the Jacobian A at the current x
  Jacobian jacobian;                                              ///< for the preconditioner
  /// Empty if x is admissible (finite, densities in their range); otherwise what is wrong with it.
  std::function<Refusal(const Array& x)> complaint;
  /// The product in single precision, for a Newton that solves its linear systems in single precision.
  std::function<void(const ArrayOf<float>& z, const ArrayOf<float>& out)> single_product = {};
  SolidPart solid = {};  ///< at this step
};

/// Fields are weighted so that each starts the step with the same share of the norm of the residual, or is at its floor.
/// A field whose residual is not much more than round-off has a smaller share, because no solve makes it smaller.
struct FieldRange {
  int first, last;
  double floor;
  double round_off = 0;  ///< norm of the round-off of the residual, where it is above the floor
};

enum class LinearSolves { full, single };

class Newton {
 public:
  /// @param linear  precision of the linear solves; `single` needs the product in single precision
  Newton(const VectorSpace&, int size, int restart, std::unique_ptr<Preconditioner> preconditioner,
         LinearSolves linear = LinearSolves::full);

  /// Improves x until the weighted residual has fallen by rtol.
  NewtonResult solve(const NonlinearSystem&, const std::vector<FieldRange>& fields, const NewtonControl&,
                     const Array& x);

  SolverCounts& counts() { return counts_; }
  const Preconditioner& preconditioner() const { return *preconditioner_; }
  void forget_preconditioner() { rebuild_ = true; }

  /// All but the factors of the preconditioner.
  void visit_memory(StepMemory&);
  /// Whether the next solve begins with the preconditioner that is there.
  bool keeps_preconditioner() const { return !rebuild_; }
  /// Makes the preconditioner that the memory tells of. @param jacobian  that of its build
  void build_again(const Jacobian& jacobian) { preconditioner_->build(jacobian); }

 private:
  /// The norm of all fields from those of each, with their weights.
  double weighted_norm(const std::vector<double>& sizes) const;
  double weighted_round_off(const std::vector<FieldRange>&) const;
  /// @param sizes  the norm of each field of the residual at the start of a step
  void set_weights(const std::vector<FieldRange>&, const std::vector<double>& sizes);
  /// Solves A step = residual.
  KrylovResult linear_solve(const NonlinearSystem&, const std::vector<FieldRange>&, const NewtonControl&,
                            double forcing, int limit, const Array& x);
  template <class Real>
  KrylovResult linear_solve_in(LinearSpace<Real>&, const NonlinearSystem&, const std::vector<FieldRange>&,
                               const NewtonControl&, double forcing, int limit, const Array& x);
  void jacobian_product(const NonlinearSystem&, const NewtonControl&, const Array& x, const Array& z, const Array& out);
  void jacobian_product(const NonlinearSystem&, const NewtonControl&, const Array& x, const ArrayOf<float>& z,
                        const ArrayOf<float>& out);
  void build(const NonlinearSystem&);
  Refusal update(const NonlinearSystem&, const Array& x);

  VectorSpace space_;
  std::variant<LinearSpace<double>, LinearSpace<float>> linear_;
  std::unique_ptr<Preconditioner> preconditioner_;
  Array residual_, step_, probe_;
  std::vector<double> weight_;  ///< of the norm of each field
  Wear wear_;
  bool rebuild_ = true;
  double built_for_ = 1;  ///< size of the solid's part at the last build
  SolverCounts counts_;
};

}  // namespace softwet
