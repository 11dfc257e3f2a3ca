// Multifrontal LU of the Jacobian: its fronts are eliminated from the leaves of a nested dissection to the root.
#pragma once

#include <algorithm>
#include <atomic>

#include "solver/direct/host/front.hpp"
#include "solver/direct/host/point_pairs.hpp"
#include "solver/direct/host/work_split.hpp"
#include "solver/matrix/equilibration.hpp"
#include "solver/preconditioner.hpp"

namespace softwet {

/// Runs body(slot, item) for all items. One thread works on a slot at a time, so that slots can have memory of their own.
template <class Body>
void for_items(int slots, int items, const Body& body) {
  std::atomic<int> next = 0;
  const auto work = [&](int slot) {
    for (int item = next++; item < items; item = next++) body(slot, item);
  };
  Kokkos::parallel_for("softwet::fronts",
                       Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace, Kokkos::Schedule<Kokkos::Dynamic>>(
                           0, std::min(slots, items))
                           .set_chunk_size(1),
                       work);
}

/// Stencil solver by factors in the precision Number; see make_block_lu. It works on the host.
template <int D, class Number>
class BlockLu final : public StencilSolver<D> {
 public:
  BlockLu(const Layout<D>& layout, const ConstArray& mask)
      : stencil_(layout),
        table_(layout, to_host(mask)),
        tree_(dissect(layout, table_, D == 2 ? 24 : 64)),
        pairs_(find_point_pairs(tree_, layout, table_)),
        equilibrator_(layout, table_),
        scale_{std::vector<float>(layout.size()), std::vector<float>(layout.size())},
        fronts_(tree_.nodes.size()),
        below_(tree_.nodes.size()) {
    for (std::size_t n = 0; n < fronts_.size(); ++n) {
      const DissectionNode& node = tree_.nodes[n];
      fronts_[n].set_size(static_cast<int>(node.own.size()), static_cast<int>(node.border.size()));
      largest_ = std::max(largest_, fronts_[n].size());
      for (int child : node.children) {
        fronts_[child].runs = find_runs(tree_.nodes[child].border_in_parent, fronts_[n].own());
        below_[n].push_back(&fronts_[child]);
      }
    }
    for (int i = 0; i < layout.size(); ++i)
      if (table_.component(i) < 0) held_.push_back(i);
    split_ = split_work(tree_, Host().concurrency());
    slots_ = std::min<int>(Host().concurrency(), split_.subtrees.size());
  }

  void build(const StencilMatrix<D>& matrix) override {
    if (factors_.extent(0) == 0) allocate();
    if constexpr (on_host) {
      entries_ = matrix.values();
    } else {
      if (copy_.extent(0) == 0) copy_ = buffer<float>("lu.entries", matrix.values().extent(0));
      Kokkos::deep_copy(copy_, matrix.values());
      entries_ = copy_;
    }
    equilibrator_.compute(entries_, scale_);
    for_items(slots_, split_.subtrees.size(), [&](int slot, int item) {
      const int n = split_.subtrees[item];
      eliminate_subtree(n, fronts_memory_.data() + slot * subtree_size_, scratch(slot));
      fronts_[n].keep_complement(fronts_memory_.data() + slot * subtree_size_);
    });
    for (auto level = split_.top.rbegin(); level != split_.top.rend(); ++level)
      for_items(slots_, level->size(), [&](int slot, int item) {
        Work* memory = fronts_memory_.data();
        for (int i = 0; i < item; ++i) memory += top_size(fronts_[(*level)[i]]);
        eliminate_top((*level)[item], memory, scratch(slot));
      });
    entries_ = {};
  }

  void apply(const ConstArray& r, const Array& z) override {
    Kokkos::deep_copy(right_, r);
    for_items(slots_, split_.subtrees.size(), [&](int slot, int item) {
      const int root = split_.subtrees[item];
      for (int n = tree_.nodes[root].first; n <= root; ++n) forward(n, scratch(slot));
    });
    for (auto level = split_.top.rbegin(); level != split_.top.rend(); ++level)
      for (int n : *level) forward(n, scratch(0));
    for (const std::vector<int>& level : split_.top)
      for (int n : level) backward(n, scratch(0));
    for_items(slots_, split_.subtrees.size(), [&](int slot, int item) {
      const int root = split_.subtrees[item];
      for (int n = root; n >= tree_.nodes[root].first; --n) backward(n, scratch(slot));
    });
    for (int i : held_) solution_[i] = right_[i];
    Kokkos::deep_copy(z, solution_);
  }

  std::string name() const override { return "lu"; }
  double build_cost() const override { return D == 2 ? 35 : 90; }
  const Equilibration& scale() const { return scale_; }
  double bytes() const override {
    double total = 0;
    for (const auto& of_node : pairs_) total += sizeof(PointPair) * of_node.size();
    const Sizes sizes = count();
    return total + sizes.factors +
           double(sizeof(Work)) * (sizes.vectors + sizes.complements + sizes.fronts + slots_ * scratch_size());
  }

 private:
  using Work = typename Front<Number>::Work;
  using Matrix = typename Front<Number>::Matrix;
  using Host = Kokkos::DefaultHostExecutionSpace;
  template <class T>
  using Buffer = Kokkos::View<T*, Kokkos::HostSpace>;

  template <class T>
  static Buffer<T> buffer(const char* label, std::size_t size) {
    return Buffer<T>(Kokkos::view_alloc(std::string(label), Kokkos::WithoutInitializing), size);
  }

  /// Bytes of the factors, and numbers in other buffers.
  struct Sizes {
    std::size_t factors = 0, vectors = 0, complements = 0, fronts = 0, subtree = 0;
  };

  static int padded(int size) { return PackedBlock<Number>::padded(size); }
  static std::size_t top_size(const Front<Number>& front) { return front.front_size() + front.beside_size(); }

  /// Numbers that the elimination of a subtree needs: the fronts on the way down, and what is beside the last one.
  std::size_t subtree_size(int n) const {
    std::size_t below = fronts_[n].beside_size();
    for (int child : tree_.nodes[n].children) below = std::max(below, subtree_size(child));
    return fronts_[n].front_size() + below;
  }
  std::size_t scratch_size() const { return std::max<std::size_t>(inversion_scratch(largest_), 2 * padded(largest_)); }
  Sizes count() const {
    Sizes s;
    for (const Front<Number>& front : fronts_) {
      s.factors += front.factor_bytes();
      s.vectors += front.vector_size();
    }
    for (int n : split_.subtrees) {
      s.subtree = std::max(s.subtree, subtree_size(n));
      s.complements += fronts_[n].complement_size();
    }
    s.fronts = s.subtree * slots_;
    for (const std::vector<int>& level : split_.top) {
      std::size_t together = 0;
      for (int n : level) {
        together += top_size(fronts_[n]);
        s.complements += fronts_[n].complement_size();
      }
      s.fronts = std::max(s.fronts, together);
    }
    return s;
  }

  void allocate() {
    const Sizes sizes = count();
    subtree_size_ = sizes.subtree;
    fronts_memory_ = buffer<Work>("lu.fronts", sizes.fronts);
    scratch_ = buffer<Work>("lu.scratch", slots_ * scratch_size());
    complements_ = buffer<Work>("lu.complements", sizes.complements);
    vectors_ = buffer<Work>("lu.vectors", sizes.vectors);
    right_ = buffer<double>("lu.right", scale_.row.size());
    solution_ = buffer<double>("lu.solution", scale_.row.size());
    scaled_.resize(scale_.row.size());
    factors_ = buffer<std::byte>("lu.factors", sizes.factors);
    std::byte* factors = factors_.data();
    Work *vectors = vectors_.data(), *complements = complements_.data();
    for (Front<Number>& front : fronts_) front.place(vectors, factors);
    for (int n : split_.subtrees) fronts_[n].place_complement(complements);
    for (const std::vector<int>& level : split_.top)
      for (int n : level) fronts_[n].place_complement(complements);
  }

  Work* scratch(int slot) const { return scratch_.data() + slot * scratch_size(); }

  /// Leaves the complement in the front at the begin of the memory.
  void eliminate_subtree(int n, Work* memory, Work* scratch) {
    const Matrix front = fronts_[n].view(memory);
    Work* below = memory + fronts_[n].front_size();
    assemble(n, front);
    for (int child : tree_.nodes[n].children) {
      eliminate_subtree(child, below, scratch);
      fronts_[child].add_complement(fronts_[child].complement_in(below), front);
    }
    fronts_[n].eliminate(front, below, scratch);
  }
  void eliminate_top(int n, Work* memory, Work* scratch) {
    const Matrix front = fronts_[n].view(memory);
    assemble(n, front);
    for (const Front<Number>* child : below_[n]) child->add_complement(child->kept_complement(), front);
    fronts_[n].eliminate(front, memory + fronts_[n].front_size(), scratch);
    fronts_[n].keep_complement(memory);
  }

  /// The matrix entries of a node, scaled.
  void assemble(int n, const Matrix& front) const {
    const DissectionNode& node = tree_.nodes[n];
    std::fill(front.data, front.data + std::ptrdiff_t(front.stride) * front.columns, Work(0));
    const auto unknown = [&](int local) {
      const int own = static_cast<int>(node.own.size());
      return local < own ? node.own[local] : node.border[local - own];
    };
    const int fields = stencil_.components;
    const std::int64_t block = std::int64_t(stencil_.offsets) * stencil_.points;
    for (const PointPair& pair : pairs_[n]) {
      const float* entries = entries_.data() + pair.place;
      int column = pair.column;
      for (int u = 0; u < fields; ++u) {
        if (!(pair.column_fields >> u & 1)) continue;
        const float column_scale = scale_.column[unknown(column)];
        int row = pair.row;
        for (int a = 0; a < fields; ++a) {
          if (!(pair.row_fields >> a & 1)) continue;
          // += : around a short periodic axis offsets coincide
          if (stencil_.couples(a, u))
            front.column(column)[row] +=
                Work(entries[stencil_.pair(a, u) * block]) * scale_.row[unknown(row)] * column_scale;
          ++row;
        }
        ++column;
      }
    }
  }

  void forward(int n, Work* scratch) {
    const std::vector<int>& own = tree_.nodes[n].own;
    for (std::size_t i = 0; i < own.size(); ++i) scratch[i] = static_cast<Work>(right_[own[i]] * scale_.row[own[i]]);
    fronts_[n].forward(scratch, below_[n], scratch + padded(largest_));
  }

  void backward(int n, Work* scratch) {
    const std::vector<int>&own = tree_.nodes[n].own, &border = tree_.nodes[n].border;
    for (std::size_t i = 0; i < border.size(); ++i) scratch[i] = scaled_[border[i]];
    fronts_[n].backward(scratch, scratch + padded(largest_));
    const Work* solution = fronts_[n].solution();
    for (std::size_t i = 0; i < own.size(); ++i) {
      scaled_[own[i]] = solution[i];
      solution_[own[i]] = double(solution[i]) * scale_.column[own[i]];
    }
  }

  Stencil<D> stencil_;
  UnknownTable<D> table_;
  Dissection tree_;
  std::vector<std::vector<PointPair>> pairs_;  ///< [node]
  Equilibrator<D> equilibrator_;
  Equilibration scale_;
  std::vector<Front<Number>> fronts_;
  std::vector<std::vector<const Front<Number>*>> below_;  ///< children
  std::vector<int> held_;                                 ///< prescribed values and ghosts
  WorkSplit split_;
  int slots_ = 1, largest_ = 0;
  std::size_t subtree_size_ = 0;
  Buffer<const float> entries_;  ///< of the matrix, during a build
  Buffer<float> copy_;           ///< of them, where they are in other memory
  Buffer<Work> fronts_memory_, scratch_, complements_, vectors_;
  Buffer<std::byte> factors_;
  Buffer<double> right_, solution_;
  std::vector<Work> scaled_;  ///< the solution of the scaled matrix
};

}  // namespace softwet
