// A preconditioner of the whole patch on every process.
#pragma once

#include "solver/preconditioner.hpp"

namespace softwet {

/// A vector of the whole patch, on every process.
template <int D>
Array of_patch(const Layout<D>& layout, const ConstArray& own) {
  const Array all("patch", static_cast<std::size_t>(entries_of_patch(layout, static_cast<double>(own.extent(0)))));
  gather_columns(layout.columns, own, all);
  return all;
}

/// Each process collects the matrix and the vector, and does the same with the same numbers. So the number of processes
/// does not change a bit of the result. What the whole one need not do for this process's columns it may leave out; all
/// else costs each process what it costs one.
template <int D>
class Replicated final : public Preconditioner {
 public:
  /// @param whole  for the layout of the whole patch
  Replicated(const Layout<D>& layout, std::unique_ptr<Preconditioner> whole)
      : layout_(layout),
        whole_(std::move(whole)),
        r_("replicated.r", layout.whole_patch().size()),
        z_("replicated.z", layout.whole_patch().size()) {}

  void build(const Jacobian& jacobian) override {
    if (own_.extent(0) == 0) own_ = StencilValues("replicated.own", Stencil<D>(layout_).size());
    jacobian(own_);
    whole_->build([&](const StencilValues& values) { gather_columns(layout_.columns, own_, values); });
  }
  void apply(const ConstArray& r, const Array& z) override {
    gather_columns(layout_.columns, r, r_);
    whole_->apply(r_, z_);
    take_columns(layout_.columns, z_, z);
  }
  std::string name() const override { return whole_->name(); }
  double bytes() const override { return whole_->bytes() + 4.0 * Stencil<D>(layout_).size(); }
  double build_cost() const override { return whole_->build_cost(); }

 private:
  Layout<D> layout_;
  std::unique_ptr<Preconditioner> whole_;
  StencilValues own_;
  Array r_, z_;
};

}  // namespace softwet
