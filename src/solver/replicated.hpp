// A solver of the whole patch on every process.
#pragma once

#include "solver/preconditioner.hpp"

namespace softwet {

/// A mask of the whole patch, on every process. Ghosts are not free, also where copies of them are.
template <int D>
Array mask_of_patch(const Layout<D>& layout, const ConstArray& own) {
  std::vector<double> all = to_host_of_patch(layout, own);
  const Axis& axis = layout.axis[0];
  for (std::size_t i = 0; i < all.size(); ++i)
    if (static_cast<int>(i % axis.functions()) >= axis.owned()) all[i] = 0;
  return to_device<Array>(all, "mask");
}

/// All processes collect the matrix and the vector, and each does with the same numbers what a single process does. So
/// the number of processes does not change a bit of the result.
template <int D>
class Replicated final : public StencilSolver<D> {
 public:
  /// @param layout  what this process stores; `mask` and `solver` are for the whole patch
  Replicated(const Layout<D>& layout, const ConstArray& mask, std::unique_ptr<StencilSolver<D>> solver)
      : layout_(layout),
        matrix_(layout.whole_patch(), mask),
        solver_(std::move(solver)),
        r_("replicated.r", matrix_.layout().size()),
        z_("replicated.z", matrix_.layout().size()) {}

  void build(const StencilMatrix<D>& matrix) override {
    const auto own = Kokkos::subview(matrix.values(), Kokkos::make_pair(std::int64_t(0), matrix.stencil().size()));
    matrix_.fill([&](const StencilValues& values) { gather_columns(layout_.columns, own, values); });
    solver_->build(matrix_);
  }
  void apply(const ConstArray& r, const Array& z) override {
    gather_columns(layout_.columns, r, r_);
    solver_->apply(r_, z_);
    take_columns(layout_.columns, z_, z);
  }
  std::string name() const override { return solver_->name(); }
  double bytes() const override { return matrix_.bytes() + solver_->bytes(); }
  double build_cost() const override { return solver_->build_cost(); }
  void visit_memory(StepMemory& memory) override { solver_->visit_memory(memory); }

 private:
  Layout<D> layout_;
  StencilMatrix<D> matrix_;
  std::unique_ptr<StencilSolver<D>> solver_;
  Array r_, z_;
};

}  // namespace softwet
