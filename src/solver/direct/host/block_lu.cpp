#include "solver/direct/host/block_lu.hpp"

#include "solver/direct/host/multifrontal_lu.hpp"
#include "solver/matrix/factor_defect.hpp"

namespace softwet {

namespace {

/// Factors in half precision as long as they are good enough, in single precision from then on, and in double precision of
/// each matrix for which single precision is not good enough.
template <int D>
class SufficientLu final : public StencilSolver<D> {
 public:
  SufficientLu(const Layout<D>& layout, const ConstArray& mask) : layout_(layout), mask_(mask), defect_(mask) {
    if constexpr (std::is_same_v<FactorNumber, Half>)
      half_ = std::make_unique<BlockLu<D, FactorNumber>>(layout, mask);
    else
      go_on_in_single();
  }

  void build(const StencilMatrix<D>& matrix) override {
    if (half_ && !is_good(*half_, matrix)) go_on_in_single();
    if (single_ && !is_good(*single_, matrix)) {
      if (!double_) double_ = std::make_unique<BlockLu<D, double>>(layout_, mask_);
      double_->build(matrix);
    } else {
      double_.reset();
    }
  }
  void apply(const ConstArray& r, const Array& z) override { solver().apply(r, z); }
  std::string name() const override { return solver().name(); }
  double bytes() const override { return solver().bytes() + (double_ ? single_->bytes() : 0); }
  double build_cost() const override { return solver().build_cost(); }
  void visit_memory(StepMemory& memory) override {
    bool single = half_ == nullptr;
    memory.flag("lu/single", single);
    if (single && half_) go_on_in_single();
  }

 private:
  static constexpr double most = 0.2;  ///< defect: matrices that are nearly singular lose the digits of the factors

  StencilSolver<D>& solver() const {
    if (double_) return *double_;
    if (single_) return *single_;
    return *half_;
  }
  template <class Number>
  bool is_good(BlockLu<D, Number>& lu, const StencilMatrix<D>& matrix) {
    lu.build(matrix);
    return defect_.measure(lu, matrix, lu.scale().row) < most;
  }
  void go_on_in_single() {
    half_.reset();
    single_ = std::make_unique<BlockLu<D, float>>(layout_, mask_);
  }

  Layout<D> layout_;
  ConstArray mask_;
  FactorDefect<D> defect_;
  std::unique_ptr<BlockLu<D, FactorNumber>> half_;
  std::unique_ptr<BlockLu<D, float>> single_;   ///< where half precision was not enough
  std::unique_ptr<BlockLu<D, double>> double_;  ///< of the last matrix, where single precision was not enough for it
};

}  // namespace

double factor_entries(const Dissection& tree) {
  double entries = 0;
  for (const DissectionNode& node : tree.nodes) {
    const double own = node.own.size(), border = node.border.size();
    entries += own * (own + 2 * border);
  }
  return entries;
}

template <int D>
std::unique_ptr<StencilSolver<D>> make_block_lu(const Layout<D>& layout, const ConstArray& mask,
                                                FactorPrecision precision) {
  if (precision == FactorPrecision::sufficient) return std::make_unique<SufficientLu<D>>(layout, mask);
  if (precision == FactorPrecision::full) return std::make_unique<BlockLu<D, double>>(layout, mask);
  if constexpr (std::is_same_v<FactorNumber, Half>)
    if (precision == FactorPrecision::half) return std::make_unique<BlockLu<D, Half>>(layout, mask);
  return std::make_unique<BlockLu<D, float>>(layout, mask);
}

template std::unique_ptr<StencilSolver<2>> make_block_lu<2>(const Layout<2>&, const ConstArray&, FactorPrecision);
template std::unique_ptr<StencilSolver<3>> make_block_lu<3>(const Layout<3>&, const ConstArray&, FactorPrecision);

}  // namespace softwet
