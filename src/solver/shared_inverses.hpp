// Which boxes of a level of Schwarz's method use the inverse of another box.
#pragma once

#include "solver/box_inverses.hpp"
#include "solver/gauss_jordan.hpp"
#include "solver/patches.hpp"

namespace softwet {

/// A box b may use the inverse of a box c whose unknowns lie as its own do, if for x = A_c^-1 r and every field f
///   |A_c^-1 A_b x - x|_f < limit |x|_f.
/// The vectors r are random, as large in each row as the largest entry of A_b there. A box is compared with the inverses
/// that boxes nearby use, and takes the closest one. These lie before it along the second and the third axis alone, so
/// that the choice is the same on any number of processes, which cut the first one.
/// Tested: tests/unit/solver/test_shared_inverses.cpp
class SharedInverses {
 public:
  /// @param limit  0: every box has an inverse of its own
  SharedInverses(const PatchTables&, int components, float limit);

  bool any() const { return limit_ > 0; }
  /// Boxes in the order in which they are built: those of one wave are compared with those of earlier ones, never with each
  /// other. A wave consists of whole rows of boxes along the first axis.
  const std::vector<std::vector<int>>& waves() const { return waves_; }
  /// Finds the owners of boxes of a wave, given their matrices and the inverses of earlier waves. For the host.
  void choose(const int* boxes, int count, const DenseBlocks& matrices, const BoxInverses&);
  /// The box whose inverse a box uses.
  int owner(int box) const { return owner_[box]; }
  /// All boxes, those with the same inverse one after another.
  std::vector<int> by_owner() const;

 private:
  /// The matrix of a box, and the largest entry of each row.
  struct Matrix {
    const float* entry;
    std::size_t stride;
    std::vector<float> size_of_row;

    const float* row(int i) const { return entry + i * stride; }
  };

  std::vector<int> candidates(int box) const;
  /// The closest inverse below the limit, else the box itself.
  int closest(int box, const Matrix&, const BoxInverses&) const;
  /// Largest |A_c^-1 A_b x - x|_f / |x|_f; not a number where the inverse has entries that are none.
  float distance(const Matrix&, int candidate, int kind, const BoxInverses&) const;

  float limit_;
  int row_, rows_, components_;
  std::vector<int> kind_;                    ///< [box] equal where unknowns lie alike
  std::vector<std::vector<int>> component_;  ///< [kind][unknown of the box]
  std::vector<float> probe_[2];              ///< random signs
  std::vector<std::vector<int>> waves_;
  std::vector<int> owner_;
};

}  // namespace softwet
