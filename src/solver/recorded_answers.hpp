// A preconditioner whose kernels are recorded as graphs of a device.
#pragma once

#include <utility>

#include "solver/preconditioner.hpp"
#include "solver/recording.hpp"

namespace softwet {

/// Gives the answers of another preconditioner. For each pair of vectors its kernels start one by one the first time,
/// and are recorded the second time. From then on they start as one (solver/recording.hpp), until the next build. GMRES
/// comes back to the same pairs of vectors in each solve. Factors of an answer change with the time step, so that they
/// are not recorded: they take a kernel of their own.   Tested: tests/unit/solver/test_recorded_answers.cpp
class RecordedAnswers final : public Preconditioner {
 public:
  /// @param of  one that can be recorded
  explicit RecordedAnswers(std::unique_ptr<Preconditioner> of) : of_(std::move(of)) {}

  void build(const Jacobian& jacobian) override {
    recordings_.forget();
    of_->build(jacobian);
  }
  void apply(const ConstArray& r, const Array& z) override { of_->apply(r, z); }
  void answer(const ConstArray& r, const Array& z, const RangeFactors& factors) override { replay(r, z, factors); }
  void answer(const ConstArrayOf<float>& r, const ArrayOf<float>& z, const RangeFactors& factors) override {
    replay(r, z, factors);
  }
  std::string name() const override { return of_->name(); }
  double bytes() const override { return of_->bytes(); }
  double build_cost() const override { return of_->build_cost(); }
  bool recordable() const override { return true; }
  void visit_memory(StepMemory& memory) override { of_->visit_memory(memory); }

  /// Pairs of vectors whose kernels are recorded now.
  int recordings() const { return recordings_.count(); }

 private:
  template <class Real>
  void replay(const ConstArrayOf<Real>& r, const ArrayOf<Real>& z, const RangeFactors& factors) {
    const std::pair<const void*, void*> vectors{r.data(), z.data()};
    if (!recordings_.ready(vectors)) return of_->answer(r, z, factors);
    recordings_.start(vectors, [of = of_.get(), r, z] { of->answer(r, z, {}); });
    if (factors.count > 0) ScaleFields<Real, Real>{z, z, factors}.run();
  }

  std::unique_ptr<Preconditioner> of_;
  Recordings<std::pair<const void*, void*>> recordings_;
};

/// A preconditioner whose answers are recorded, or the same one where they cannot be.
inline std::unique_ptr<Preconditioner> record_answers(std::unique_ptr<Preconditioner> of) {
  if (!of->recordable()) return of;
  return std::make_unique<RecordedAnswers>(std::move(of));
}

}  // namespace softwet
