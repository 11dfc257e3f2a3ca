// One node of a multifrontal LU: its elimination, its factors, and their products with vectors.
#pragma once

#include <vector>

#include "solver/direct/dissection.hpp"
#include "solver/direct/host/packed_block.hpp"

namespace softwet {

/// Unknowns that follow each other on the border of a node and in its parent, there all own ones or all on the border.
struct Run {
  int from, to, count;
};
std::vector<Run> find_runs(const std::vector<int>& border_in_parent, int own_of_parent);

/// The matrix of a node is its front ((A, B), (C, S)), own unknowns first, then its border. Stored are A^-1, A^-1 B and C, so
/// that applying the factors is nothing but products.
template <class Number>
class Front {
 public:
  using Work = typename PackedBlock<Number>::Work;
  using Matrix = DenseMatrix<Work>;

  void set_size(int own, int border);
  int own() const { return own_; }
  int border() const { return border_; }
  int size() const { return own_ + border_; }

  /// Numbers of the front, of the blocks that its elimination needs beside it, of the complement, and of vectors.
  std::size_t front_size() const { return std::size_t(size()) * size(); }
  std::size_t beside_size() const { return std::size_t(own_) * size(); }
  std::size_t complement_size() const { return std::size_t(border_) * border_; }
  std::size_t vector_size() const;
  std::size_t factor_bytes() const { return inverse_.bytes() + lower_.bytes() + upper_.bytes(); }

  /// Takes memory for the vectors and factors and moves the pointers past it.
  void place(Work*& vectors, std::byte*& factors);
  void place_complement(Work*& memory);

  Matrix view(Work* memory) const { return {memory, size(), size(), size()}; }
  /// S, which is the complement S - C A^-1 B after the elimination.
  Matrix complement_in(Work* memory) const { return view(memory).part(own_, own_, border_, border_); }
  Matrix kept_complement() const { return {complement_, border_, border_, border_}; }
  /// Copies the complement out of the front, for a parent that is eliminated when the front is gone.
  void keep_complement(Work* memory);
  void add_complement(const DenseMatrix<const Work>& complement, const Matrix& parent) const;
  void eliminate(const Matrix& front, Work* beside, Work* scratch);

  /// Solves with L: `head` has the right-hand side of the own unknowns; `below` are the children.
  void forward(Work* head, const std::vector<const Front*>& below, Work* scratch);
  /// Solves with U: `border` has the solution on the border. Then solution() has that of the own unknowns.
  void backward(const Work* border, Work* scratch);
  const Work* solution() const { return part_; }

  std::vector<Run> runs;  ///< the border in the parent

 private:
  int own_ = 0, border_ = 0;
  PackedBlock<Number> inverse_, lower_, upper_;  ///< A^-1, C, A^-1 B
  Work *part_ = nullptr, *tail_ = nullptr, *complement_ = nullptr;
};

}  // namespace softwet
