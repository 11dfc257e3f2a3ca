#include "solver/schwarz.hpp"

#include <numeric>
#include <optional>

#include "field/vector.hpp"
#include "solver/block_lu.hpp"
#include "solver/boxes.hpp"
#include "solver/coarse_space.hpp"

namespace softwet {

namespace {

/// The columns of the first coarse level whose residual and matrix follow from a process's own columns.
Columns coarse_part(const Columns& fine, const Axis& fine_axis, const Axis& coarse_axis) {
  const int ratio = fine_axis.elements() / coarse_axis.elements();
  Columns c;
  c.rank = fine.rank;
  c.ranks = fine.ranks;
  c.function.resize(coarse_axis.functions());
  std::iota(c.function.begin(), c.function.end(), 0);
  for (int first : fine.first_function) c.first_function.push_back(first / ratio);
  c.first_function.back() = coarse_axis.functions();
  c.begin = c.first_function[c.rank];
  c.end = c.first_function[c.rank + 1];
  return c;
}

/// Part of the boxes' answer that is added when the residual has been computed anew after the coarse correction. All of it
/// would be too much: where several boxes hold an unknown, their sum overshoots.
constexpr float damping = 0.5f;

template <int D>
class Schwarz final : public StencilSolver<D> {
 public:
  Schwarz(const Layout<D>& layout, const ConstArray& mask, SchwarzControl control)
      : multiplicative_(control.multiplicative), boxes_(layout, mask, control.width, control.stride, control.wanted) {
    if (control.coarse) add_coarse(layout, mask, control);
  }

  void build(const StencilMatrix<D>& matrix) override {
    matrix_ = &matrix;
    boxes_.build(matrix);
    if (!space_) return;
    coarse_matrix_->fill([&](const StencilValues& values) {
      space_->galerkin(matrix, values);
      if (part_.ranks > 1) gather_columns(part_, values, values);
    });
    coarse_->build(*coarse_matrix_);
  }

  void apply(const ConstArray& r, const Array& z) override {
    Kokkos::deep_copy(Exec(), z, 0.0);
    if (space_) {
      space_->restrict_to(r, coarse_r_);
      if (part_.ranks > 1) gather_columns(part_, coarse_r_, coarse_r_);
      coarse_->apply(coarse_r_, coarse_z_);
      space_->prolong(coarse_z_, z);
    }
    if (!space_ || !multiplicative_) return boxes_.add(r, z, 1);
    matrix_->multiply(z, rest_);
    combine(rest_, -1, rest_, 0);
    add_scaled(rest_, 0, 1, r);
    boxes_.add(rest_, z, damping);
  }

  std::string name() const override { return "schwarz"; }
  double build_cost() const override { return D == 2 ? 25 : 50; }
  double bytes() const override {
    double total = boxes_.bytes();
    if (space_) total += coarse_matrix_->bytes() + coarse_->bytes() + space_->galerkin_bytes();
    return total;
  }

 private:
  void add_coarse(const Layout<D>& layout, const ConstArray& mask, const SchwarzControl& control) {
    space_.emplace(layout, mask, 4);
    if (!space_->exists()) return space_.reset();
    const Layout<D>& coarse = space_->layout();
    const bool direct = coarse.size() <= control.direct_up_to;
    coarse_matrix_.emplace(coarse, space_->mask(), direct ? Products::single : Products::sixteen_bits);
    SchwarzControl below = control;
    below.multiplicative = true;
    below.wanted = {};
    below.part = {};
    if (control.part.ranks > 1) part_ = coarse_part(control.part, layout.axis[0], coarse.axis[0]);
    coarse_ = direct ? make_block_lu<D>(coarse, space_->mask()) : make_schwarz<D>(coarse, space_->mask(), below);
    coarse_r_ = Array("schwarz.coarse_r", coarse.size());
    coarse_z_ = Array("schwarz.coarse_z", coarse.size());
    if (multiplicative_) rest_ = Array("schwarz.rest", layout.size());
  }

  bool multiplicative_;
  Columns part_;  ///< of the coarse level that this process knows
  Boxes<D> boxes_;
  const StencilMatrix<D>* matrix_ = nullptr;
  std::optional<CoarseSpace<D>> space_;
  std::optional<StencilMatrix<D>> coarse_matrix_;
  std::unique_ptr<StencilSolver<D>> coarse_;
  Array coarse_r_, coarse_z_, rest_;
};

}  // namespace

template <int D>
std::unique_ptr<StencilSolver<D>> make_schwarz(const Layout<D>& layout, const ConstArray& mask,
                                               SchwarzControl control) {
  return std::make_unique<Schwarz<D>>(layout, mask, control);
}

template std::unique_ptr<StencilSolver<2>> make_schwarz<2>(const Layout<2>&, const ConstArray&, SchwarzControl);
template std::unique_ptr<StencilSolver<3>> make_schwarz<3>(const Layout<3>&, const ConstArray&, SchwarzControl);

}  // namespace softwet
