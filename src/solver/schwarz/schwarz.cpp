#include "solver/schwarz/schwarz.hpp"

#include <optional>

#include "field/vector.hpp"
#include "solver/direct/device/dense_solver.hpp"
#include "solver/direct/host/block_lu.hpp"
#include "solver/replicated.hpp"
#include "solver/schwarz/boxes.hpp"
#include "solver/schwarz/coarse_image.hpp"

namespace softwet {

namespace {

/// Whether a coarse level is worth cutting among the processes: each has some columns.
bool can_be_cut(const Columns& c) {
  constexpr int least = 2;
  for (int r = 0; r < c.ranks; ++r)
    if (c.first_function[r + 1] - c.first_function[r] < least) return false;
  return true;
}

/// Part of the boxes' answer that is added when the residual has been computed anew after the coarse correction. All of
/// it would be too much: where several boxes hold an unknown, their sum overshoots.
constexpr float damping = 0.5f;

template <int D>
class Schwarz final : public StencilSolver<D> {
 public:
  Schwarz(const Layout<D>& layout, const ConstArray& mask, SchwarzControl control)
      : layout_(layout),
        multiplicative_(control.multiplicative),
        boxes_(layout, mask, control.width, control.stride, control.share) {
    if (!layout.whole()) r_ = Array("schwarz.r", layout.size());
    if (control.coarse) add_coarse(layout, mask, control);
  }

  void build(const StencilMatrix<D>& matrix) override {
    matrix.update_copies();
    boxes_.build(matrix);
    if (!space_) return;
    if (image_) image_->build(matrix);
    coarse_matrix_->fill([&](const StencilValues& values) { space_->galerkin(matrix, values); });
    coarse_->build(*coarse_matrix_);
  }

  void apply(const ConstArray& r, const Array& z) override {
    if (in_few_kernels()) return answer(r, z, {});
    const ConstArray all = layout_.whole() ? r : with_copies(r);
    if (!space_) {
      boxes_.multiply(all, NothingBeside());
      return boxes_.collect(NoStart(), 1, {}, z);
    }
    space_->restrict_to(all, coarse_r_);
    solve_below();
    space_->prolong(coarse_z_, z);
    if (!multiplicative_) return boxes_.add(all, z, 1);
    boxes_.add(what_is_left(r), z, damping);
  }
  void answer(const ConstArray& r, const Array& z, const RangeFactors& factors) override {
    in_few_kernels() ? add_up(r, z, factors) : RoughInverse::answer(r, z, factors);
  }
  void answer(const ConstArrayOf<float>& r, const ArrayOf<float>& z, const RangeFactors& factors) override {
    in_few_kernels() && !multiplicative_ ? add_up(r, z, factors) : RoughInverse::answer(r, z, factors);
  }

  std::string name() const override { return "schwarz"; }
  double build_cost() const override { return 100; }
  bool recordable() const override { return in_few_kernels() && layout_.whole() && coarse_->recordable(); }
  void visit_memory(StepMemory& memory) override {
    if (coarse_) coarse_->visit_memory(memory);
  }
  double bytes() const override {
    double total = boxes_.bytes();
    if (space_) total += coarse_matrix_->bytes() + coarse_->bytes() + space_->galerkin_bytes();
    if (image_) total += image_->bytes();
    return total;
  }

 private:
  static void update(const Layout<D>& layout, const Array& x) {
    if (!layout.whole()) update_columns<double>(layout.columns, *layout.exchange, x);
  }
  /// The residual with the copies of other processes' columns.
  template <class Real>
  ConstArray with_copies(const ConstArrayOf<Real>& r) const {
    convert(r_, r);
    update(layout_, r_);
    return r_;
  }

  void solve_below() {
    coarse_->apply(coarse_r_, coarse_z_);
    update(space_->layout(), coarse_z_);
  }
  /// The residual that the coarse correction leaves.
  ConstArray what_is_left(const ConstArray& r) const {
    image_->residual(r, coarse_z_, rest_);
    update(layout_, rest_);
    return rest_;
  }

  /// On a device a kernel computes the entries of the coarse correction that it needs, so that no other one writes
  /// them. On the host transfers along one axis after another are faster.
  bool in_few_kernels() const { return !host_algorithms && space_; }
  template <class Real>
  void add_up([[maybe_unused]] const ConstArrayOf<Real>& r, [[maybe_unused]] const ArrayOf<Real>& z,
              [[maybe_unused]] const RangeFactors& factors) {
    if constexpr (!host_algorithms) {
      layout_.whole() ? below_and_boxes(r) : below_and_boxes<double>(with_copies(r));
      boxes_.collect(space_->prolongation(coarse_z_), multiplicative_ ? damping : 1, factors, z);
    }
  }
  /// One kernel restricts the residual and multiplies with the boxes' inverses, unless these wait for the level below.
  template <class Real>
  void below_and_boxes(const ConstArrayOf<Real>& r) {
    if constexpr (std::is_same_v<Real, double>)
      if (multiplicative_) return below_then_boxes(r);
    boxes_.multiply(r, WriteEntries<SumAllAxes<D, Real>>{space_->restriction(r), coarse_r_});
    solve_below();
  }
  void below_then_boxes(const ConstArray& r) {
    space_->restrict_to(r, coarse_r_);
    solve_below();
    boxes_.multiply(what_is_left(r), NothingBeside());
  }

  void add_coarse(const Layout<D>& layout, const ConstArray& mask, const SchwarzControl& control) {
    space_.emplace(layout, mask, 4);
    if (!space_->exists()) return space_.reset();
    const Layout<D>&coarse = space_->layout(), all = coarse.whole_patch();
    const bool direct = all.size() <= control.direct_up_to;
    SchwarzControl below = control;
    below.multiplicative = true;
    const auto solver = [&](const Layout<D>& l, const ConstArray& m) {
      if (!direct) return make_schwarz<D>(l, m, below);
      return control.dense_bottom ? make_dense_solver<D>(l, m) : make_block_lu<D>(l, m);
    };
    if (coarse.whole() || (!direct && can_be_cut(coarse.columns))) {
      coarse_matrix_.emplace(coarse, space_->mask());
      coarse_ = solver(coarse, space_->mask());
    } else {
      const Array free = mask_of_patch(coarse, space_->mask());
      coarse_matrix_.emplace(coarse, space_->mask());
      coarse_ = std::make_unique<Replicated<D>>(coarse, free, solver(all, free));
    }
    coarse_r_ = Array("schwarz.coarse_r", coarse.size());
    coarse_z_ = Array("schwarz.coarse_z", coarse.size());
    if (!multiplicative_) return;
    image_.emplace(layout, mask, *space_);
    rest_ = Array("schwarz.rest", layout.size());
  }

  Layout<D> layout_;
  bool multiplicative_;
  Boxes<D> boxes_;
  std::optional<CoarseSpace<D>> space_;
  std::optional<CoarseImage<D>> image_;  ///< of the correction, where it is multiplicative
  std::optional<StencilMatrix<D>> coarse_matrix_;
  std::unique_ptr<StencilSolver<D>> coarse_;
  Array r_, coarse_r_, coarse_z_, rest_;
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
