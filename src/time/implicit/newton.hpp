// Inexact Newton-Krylov with a lagged preconditioner.
#pragma once

#include <functional>
#include <string>
#include <variant>

#include "case/refusal.hpp"
#include "field/layout.hpp"
#include "solver/krylov/gmres.hpp"
#include "solver/preconditioner.hpp"
#include "time/implicit/convergence.hpp"
#include "time/implicit/solid_part.hpp"
#include "time/implicit/wear.hpp"
#include "time/step/solver_counts.hpp"

namespace softwet {

struct NewtonResult {
  bool converged = false;
  int iterations = 0, krylov = 0;
  double reduction = 1;
  Refusal refusal;  ///< why it failed
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
  /// How far a correction would move the solid from x, over what is accepted. Where there is none the residual alone
  /// decides.
  std::function<double(const Array& x, const Array& correction)> remaining = {};
};

/// A linear solve, and whether its solution is worth a step.
struct LinearStep {
  KrylovResult linear;
  bool moves;
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
  /// Makes the preconditioner that the memory describes. @param jacobian  the Jacobian of its build
  void build_again(const Jacobian& jacobian) { preconditioner_->build(jacobian); }

 private:
  /// The residual at x, and the norms of its fields.
  std::vector<double> residual(const NonlinearSystem&, const std::vector<FieldRange>&, const Array& x);
  /// Solves A step = residual as accurately as convergence needs, with a new preconditioner where one is due.
  LinearStep linear_step(const NonlinearSystem&, const Convergence&, const NewtonControl&, const Array& x);
  /// Solves A step = residual.
  KrylovResult linear_solve(const NonlinearSystem&, const RangeFactors& weights, const NewtonControl&, double forcing,
                            int limit, const Array& x);
  template <class Real>
  KrylovResult linear_solve_in(LinearSpace<Real>&, const NonlinearSystem&, const RangeFactors& weights,
                               const NewtonControl&, double forcing, int limit, const Array& x);
  void jacobian_product(const NonlinearSystem&, const NewtonControl&, const Array& x, const Array& z, const Array& out);
  void jacobian_product(const NonlinearSystem&, const NewtonControl&, const Array& x, const ArrayOf<float>& z,
                        const ArrayOf<float>& out);
  void build(const NonlinearSystem&);
  Refusal update(const NonlinearSystem&, const Array& x);
  /// What the preconditioner makes of the residual: about the correction that is still missing, in step_.
  void rough_correction(const NonlinearSystem&);
  /// Whether x is the solution: its residual is small, and a linear solve has been made and would not move the solid
  /// much more.
  /// @param moved  a linear solve has been made
  bool settled(const NonlinearSystem&, Convergence&, bool moved, const Array& x);

  VectorSpace space_;
  std::variant<LinearSpace<double>, LinearSpace<float>> linear_;
  std::unique_ptr<Preconditioner> preconditioner_;
  Array residual_, step_, probe_;
  Wear wear_;
  bool rebuild_ = true;
  double built_for_ = 1;  ///< size of the solid's part at the last build
  SolverCounts counts_;
};

}  // namespace softwet
