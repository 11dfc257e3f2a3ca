// A preconditioner of the whole patch on every process.
#pragma once

#include "field/window.hpp"
#include "solver/preconditioner.hpp"

namespace softwet {

/// A vector of the whole patch, on every process.
template <int D>
Array of_patch(const Layout<D>& layout, const ConstArray& own) {
  const Array all("patch", static_cast<std::size_t>(entries_of_patch(layout, static_cast<double>(own.extent(0)))));
  gather_columns(layout.columns, own, all);
  return all;
}

/// Each process collects the matrix and the vector, or the window of them that its own columns depend on, and does with
/// the same numbers what a single process does. So the number of processes does not change a bit of the result.
template <int D>
class Replicated final : public Preconditioner {
 public:
  /// @param whole   for the layout of the whole patch
  /// @param beside  columns beside its own that a process needs; -1: all
  Replicated(const Layout<D>& layout, std::unique_ptr<Preconditioner> whole, int beside)
      : layout_(layout),
        whole_(std::move(whole)),
        r_("replicated.r", layout.whole_patch().size()),
        z_("replicated.z", layout.whole_patch().size()) {
    if (beside >= 0) window_ = plan_window(layout.axis[0], layout.columns, beside);
  }

  void build(const Jacobian& jacobian) override {
    if (own_.extent(0) == 0) own_ = StencilValues("replicated.own", Stencil<D>(layout_).size());
    jacobian(own_);
    whole_->build([&](const StencilValues& values) { collect<float>(own_, values); });
  }
  void apply(const ConstArray& r, const Array& z) override {
    collect<double>(r, r_);
    whole_->apply(r_, z_);
    take_columns(layout_.columns, z_, z);
  }
  std::string name() const override { return whole_->name(); }
  double bytes() const override { return whole_->bytes() + 4.0 * Stencil<D>(layout_).size(); }
  double build_cost() const override { return whole_->build_cost(); }

 private:
  template <class Real>
  void collect(const ConstArrayOf<Real>& own, const ArrayOf<Real>& all) const {
    if (window_) {
      fill_window<Real>(layout_.columns, *window_, own, all);
    } else {
      gather_columns(layout_.columns, own, all);
    }
  }

  Layout<D> layout_;
  std::unique_ptr<Preconditioner> whole_;
  std::shared_ptr<const ColumnExchange> window_;
  StencilValues own_;
  Array r_, z_;
};

}  // namespace softwet
