#include "solver/block_lu.hpp"

#define EIGEN_DONT_PARALLELIZE  // levels of the tree are parallel, fronts are not
#include <Eigen/Dense>
#include <atomic>
#include <cmath>
#include <new>

namespace softwet {

namespace {

using Dense = Eigen::MatrixXf;
using Column = Eigen::VectorXf;

/// Factors of one node: own block P L U, and the two blocks that couple it to its border.
struct Front {
  Eigen::PartialPivLU<Dense> own;
  Dense upper;       ///< L^-1 P F12, shape (own, border)
  Dense lower;       ///< F21 U^-1, shape (border, own)
  Dense complement;  ///< F22 - F21 F11^-1 F12, until the parent has taken it
  Column part;       ///< right-hand side of own and border during a solve
};

/// Throws std::bad_alloc after the loop where a body did: no exception may leave a parallel region.
template <class Body>
void for_level(const std::vector<int>& level, const Body& body) {
  using Host = Kokkos::DefaultHostExecutionSpace;
  std::atomic<bool> out_of_memory = false;
  Kokkos::parallel_for("softwet::fronts",
                       Kokkos::RangePolicy<Host, Kokkos::Schedule<Kokkos::Dynamic>>(0, level.size()).set_chunk_size(1),
                       [&](int i) {
                         try {
                           body(level[i]);
                         } catch (const std::bad_alloc&) {
                           out_of_memory = true;
                         }
                       });
  if (out_of_memory) throw std::bad_alloc();
}

template <int D>
class BlockLu final : public StencilSolver<D> {
 public:
  BlockLu(const Layout<D>& layout, const ConstArray& mask)
      : table_(layout, to_host(mask)),
        tree_(dissect(layout, table_, D == 2 ? 40 : 64)),
        fronts_(tree_.nodes.size()),
        row_scale_(layout.size()),
        column_scale_(layout.size()),
        values_(layout.size()) {
    const std::size_t enough = 4 * Kokkos::DefaultHostExecutionSpace().concurrency();
    int depth = 0;
    while (depth + 1 < static_cast<int>(tree_.levels.size()) && tree_.levels[depth].size() < enough) ++depth;
    for (int n = 0; n < static_cast<int>(tree_.nodes.size()); ++n)
      if (tree_.nodes[n].depth <= depth) (tree_.nodes[n].depth == depth ? subtrees_ : top_).push_back(n);
  }

  void build(const StencilMatrix<D>& matrix) override {
    entries_ = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), matrix.values());
    equilibrate();
    for (auto level = tree_.levels.rbegin(); level != tree_.levels.rend(); ++level)
      for_level(*level, [&](int n) { factorise(n); });
    entries_ = {};
  }

  void apply(const ConstArray& r, const Array& z) override {
    Kokkos::View<double*, Kokkos::HostSpace, Kokkos::MemoryTraits<Kokkos::Unmanaged>> host(values_.data(),
                                                                                           values_.size());
    Kokkos::deep_copy(host, r);
    // Whole subtrees in parallel, the few nodes above them one after another: two launches in all.
    for_level(subtrees_, [&](int root) {
      for (int n = tree_.nodes[root].first; n <= root; ++n) forward(n);
    });
    for (int n : top_) forward(n);
    for (auto n = top_.rbegin(); n != top_.rend(); ++n) backward(*n);
    for_level(subtrees_, [&](int root) {
      for (int n = root; n >= tree_.nodes[root].first; --n) backward(n);
    });
    Kokkos::deep_copy(z, host);
  }

  std::string name() const override { return "lu"; }

  double build_cost() const override { return D == 2 ? 25 : 60; }  // chosen by the time of whole runs
  double bytes() const override {
    double places = 0;
    for (const DissectionNode& node : tree_.nodes) places += node.entries.size();
    return 4 * (factor_entries(tree_) + transient_entries()) + sizeof(DissectionNode::Entry) * places;
  }

 private:
  /// Most entries beside the factors during a build: what the level below leaves, what this one leaves, and the fronts
  /// that threads work on, each with a copy.
  double transient_entries() const {
    std::vector<double> left(tree_.levels.size() + 1, 0.0), widest(tree_.levels.size(), 0.0);
    for (const DissectionNode& node : tree_.nodes) {
      const double own = node.own.size(), border = node.border.size();
      left[node.depth] += border * border;
      widest[node.depth] = std::max(widest[node.depth], (own + border) * (own + border));
    }
    double most = 0;
    for (std::size_t d = 0; d < tree_.levels.size(); ++d) {
      const double threads =
          std::min<double>(tree_.levels[d].size(), Kokkos::DefaultHostExecutionSpace().concurrency());
      most = std::max(most, left[d + 1] + left[d] + 2 * threads * widest[d]);
    }
    return most;
  }

  /// Row and column factors that bring the largest entry of each to one.
  void equilibrate() {
    std::vector<double> largest(row_scale_.size(), 0.0);
    const auto visit = [&](const auto& body) {
      for (const DissectionNode& node : tree_.nodes)
        for (const DissectionNode::Entry& e : node.entries)
          body(unknown(node, e.row), unknown(node, e.column), std::abs(entries_(e.value)));
    };
    visit([&](int row, int, double size) { largest[row] = std::max(largest[row], size); });
    for (std::size_t i = 0; i < largest.size(); ++i) row_scale_[i] = largest[i] > 0 ? 1 / largest[i] : 1;
    std::fill(largest.begin(), largest.end(), 0.0);
    visit(
        [&](int row, int column, double size) { largest[column] = std::max(largest[column], size * row_scale_[row]); });
    for (std::size_t i = 0; i < largest.size(); ++i) column_scale_[i] = largest[i] > 0 ? 1 / largest[i] : 1;
  }

  static int unknown(const DissectionNode& node, int local) {
    const int own = static_cast<int>(node.own.size());
    return local < own ? node.own[local] : node.border[local - own];
  }

  void factorise(int n) {
    const DissectionNode& node = tree_.nodes[n];
    Front& front = fronts_[n];
    const int own = static_cast<int>(node.own.size()), border = static_cast<int>(node.border.size());
    Dense f = Dense::Zero(own + border, own + border);
    for (const DissectionNode::Entry& e : node.entries)  // += : around a short periodic axis offsets coincide
      f(e.row, e.column) += static_cast<float>(entries_(e.value) * row_scale_[unknown(node, e.row)] *
                                               column_scale_[unknown(node, e.column)]);
    for (int child : node.children) {
      const std::vector<int>& to = tree_.nodes[child].border_in_parent;
      Dense& s = fronts_[child].complement;
      for (std::size_t j = 0; j < to.size(); ++j)
        for (std::size_t i = 0; i < to.size(); ++i) f(to[i], to[j]) += s(i, j);
      s.resize(0, 0);
    }
    front.part.resize(own + border);
    if (own == 0) {
      front.complement = std::move(f);
      return;
    }
    front.own.compute(f.topLeftCorner(own, own));
    const auto& lu = front.own.matrixLU();
    front.upper = front.own.permutationP() * f.topRightCorner(own, border);
    front.lower = f.bottomLeftCorner(border, own);
    if (border == 0) return;  // the root; Eigen would refer to an entry of an empty matrix
    lu.template triangularView<Eigen::UnitLower>().solveInPlace(front.upper);
    lu.template triangularView<Eigen::Upper>().template solveInPlace<Eigen::OnTheRight>(front.lower);
    front.complement = f.bottomRightCorner(border, border);
    front.complement.noalias() -= front.lower * front.upper;
  }

  void forward(int n) {
    const DissectionNode& node = tree_.nodes[n];
    Front& front = fronts_[n];
    const int own = static_cast<int>(node.own.size()), border = static_cast<int>(node.border.size());
    Column& part = front.part;
    part.setZero();
    for (int i = 0; i < own; ++i) part[i] = static_cast<float>(values_[node.own[i]] * row_scale_[node.own[i]]);
    for (int child : node.children) {
      const std::vector<int>& to = tree_.nodes[child].border_in_parent;
      const Front& below = fronts_[child];
      const int skip = static_cast<int>(tree_.nodes[child].own.size());
      for (std::size_t i = 0; i < to.size(); ++i) part[to[i]] += below.part[skip + i];
    }
    if (own == 0) return;
    part.head(own) = front.own.permutationP() * part.head(own).eval();
    auto head = part.head(own);
    front.own.matrixLU().template triangularView<Eigen::UnitLower>().solveInPlace(head);
    part.tail(border).noalias() -= front.lower * head;
  }

  void backward(int n) {
    const DissectionNode& node = tree_.nodes[n];
    Front& front = fronts_[n];
    const int own = static_cast<int>(node.own.size()), border = static_cast<int>(node.border.size());
    if (own == 0) return;
    auto head = front.part.head(own);
    auto tail = front.part.tail(border);
    for (int i = 0; i < border; ++i)
      tail[i] = static_cast<float>(values_[node.border[i]] / column_scale_[node.border[i]]);
    head.noalias() -= front.upper * tail;
    front.own.matrixLU().template triangularView<Eigen::Upper>().solveInPlace(head);
    for (int i = 0; i < own; ++i) values_[node.own[i]] = head[i] * column_scale_[node.own[i]];
  }

  UnknownTable<D> table_;
  Kokkos::View<const float*, Kokkos::HostSpace> entries_;  ///< of the matrix, during a build
  Dissection tree_;
  std::vector<Front> fronts_;
  std::vector<int> subtrees_, top_;  ///< roots of subtrees that are solved in parallel, and the nodes above them
  std::vector<double> row_scale_, column_scale_, values_;
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
std::unique_ptr<StencilSolver<D>> make_block_lu(const Layout<D>& layout, const ConstArray& mask) {
  return std::make_unique<BlockLu<D>>(layout, mask);
}

template std::unique_ptr<StencilSolver<2>> make_block_lu<2>(const Layout<2>&, const ConstArray&);
template std::unique_ptr<StencilSolver<3>> make_block_lu<3>(const Layout<3>&, const ConstArray&);

}  // namespace softwet
