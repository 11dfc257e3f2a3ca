// Rough inverses of the Jacobian, behind one interface.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "field/step_memory.hpp"
#include "field/vector.hpp"
#include "solver/matrix/stencil_matrix.hpp"
#include "solver/scale_fields.hpp"

namespace softwet {

/// What preconditioners and the solvers behind them have in common.
class RoughInverse {
 public:
  virtual ~RoughInverse() = default;
  /// z = approximately A^-1 r.
  virtual void apply(const ConstArray& r, const Array& z) = 0;
  /// Factors times that, for vectors of either precision. Where nothing better is known, what is beside `apply` takes
  /// kernels and vectors of its own.
  virtual void answer(const ConstArray& r, const Array& z, const RangeFactors& factors) {
    apply(r, z);
    if (factors.count > 0) ScaleFields<double, double>{z, z, factors}.run();
  }
  virtual void answer(const ConstArrayOf<float>& r, const ArrayOf<float>& z, const RangeFactors& factors) {
    if (r_.extent(0) != r.extent(0)) {
      r_ = Array("answer.r", r.extent(0));
      z_ = Array("answer.z", r.extent(0));
    }
    convert(r_, r);
    apply(r_, z_);
    ScaleFields<float, double>{z, z_, factors}.run();
  }
  virtual std::string name() const = 0;
  /// Without the matrix that a solver is given.
  virtual double bytes() const = 0;
  /// The measured cost of a build, in Krylov iterations (a product and an application each). It decides how long Newton
  /// keeps a lagged preconditioner (Wear).
  virtual double build_cost() const = 0;
  /// Whether between two builds `answer` starts the same kernels each time, does nothing on the host, and waits for
  /// nothing (solver/recording.hpp). Its first call may allocate vectors.
  virtual bool recordable() const { return false; }
  /// What the next builds need of the last ones. Where nothing is visited a build follows from its matrix alone.
  virtual void visit_memory(StepMemory&) {}

 private:
  Array r_, z_;  ///< in double precision
};

class Preconditioner : public RoughInverse {
 public:
  /// Rebuilds from the Jacobian at the current point.
  virtual void build(const Jacobian& jacobian) = 0;
};

/// z = r. Only for tests and comparisons.
class NoPreconditioner final : public Preconditioner {
 public:
  void build(const Jacobian&) override {}
  void apply(const ConstArray& r, const Array& z) override { Kokkos::deep_copy(Exec(), z, r); }
  std::string name() const override { return "none"; }
  double bytes() const override { return 0; }
  double build_cost() const override { return 0; }
};

/// A rough inverse of a given matrix: of the Jacobian, or of a coarse one under it.
template <int D>
class StencilSolver : public RoughInverse {
 public:
  /// Keeps a reference to the matrix.
  virtual void build(const StencilMatrix<D>& matrix) = 0;
};

/// The assembled Jacobian and a solver for it.
template <int D>
class Assembled final : public Preconditioner {
 public:
  Assembled(const Layout<D>& layout, const ConstArray& mask, std::unique_ptr<StencilSolver<D>> solver)
      : matrix_(layout, mask), solver_(std::move(solver)) {}
  void build(const Jacobian& jacobian) override {
    matrix_.fill(jacobian);
    solver_->build(matrix_);
  }
  void apply(const ConstArray& r, const Array& z) override { solver_->apply(r, z); }
  void answer(const ConstArray& r, const Array& z, const RangeFactors& factors) override {
    solver_->answer(r, z, factors);
  }
  void answer(const ConstArrayOf<float>& r, const ArrayOf<float>& z, const RangeFactors& factors) override {
    solver_->answer(r, z, factors);
  }
  std::string name() const override { return solver_->name(); }
  double bytes() const override { return matrix_.bytes() + solver_->bytes(); }
  double build_cost() const override { return solver_->build_cost(); }
  bool recordable() const override { return solver_->recordable(); }
  void visit_memory(StepMemory& memory) override { solver_->visit_memory(memory); }

 private:
  StencilMatrix<D> matrix_;
  std::unique_ptr<StencilSolver<D>> solver_;
};

}  // namespace softwet
