// Which boxes of a level of Schwarz's method use the inverse of another box.
#pragma once

#include <vector>

#include "solver/schwarz/choose_inverse.hpp"
#include "solver/schwarz/patches.hpp"

namespace softwet {

/// A box b may use the inverse of a box c whose unknowns lie as its own do, if for x = A_c^-1 r and every field f
///   |A_c^-1 A_b x - x|_f < limit |x|_f.
/// The vectors r are random, as large in each row as the largest entry of A_b there. A box is compared with the
/// inverses that boxes nearby use, and takes the closest one. These lie before it along the second and the third axis
/// alone, so that the choice is the same on any number of processes, which cut the first one.
/// Tested: tests/unit/solver/schwarz/test_shared_inverses.cpp
class SharedInverses {
 public:
  /// @param limit  0: every box has an inverse of its own
  SharedInverses(const PatchTables&, int components, float limit);

  bool any() const { return limit_ > 0; }
  /// Boxes in the order in which they are built: boxes of one wave are compared with boxes of earlier waves, never with
  /// each other. A wave consists of whole rows of boxes along the first axis.
  const std::vector<std::vector<int>>& waves() const { return waves_; }
  int largest_wave() const;
  /// Finds the owners of boxes of a wave, given their matrices and the inverses of earlier waves: one kernel, and a
  /// copy of the answers for which the host waits.
  /// @param threads  that compare a box; 0: as many as suit the machine
  void choose(const int* boxes, int count, const DenseBlocks& matrices, const BoxInverses&, int threads = 0);
  /// The box whose inverse a box uses.
  int owner(int box) const { return owner_[box]; }
  /// All boxes, those with the same inverse one after another.
  std::vector<int> by_owner() const;

 private:
  using Numbers = ChooseInverse::Rows<int>;

  std::vector<int> candidates(int box) const;
  /// Tables for the kernel. Boxes of one kind have the fields of the first one.
  void allocate(const PatchTables&, const std::vector<int>& first_of_kind);

  float limit_;
  int row_, rows_, components_;
  std::vector<int> kind_;  ///< [box] equal where unknowns lie alike
  std::vector<std::vector<int>> waves_;
  std::vector<int> owner_;
  BlockSizes size_;  ///< as in ChooseInverse, as all below
  Numbers field_, question_;
  Numbers::host_mirror_type question_on_host_;
  ChooseInverse::Rows<float> probe_;
  Kokkos::View<int*, Exec> answer_;
  Kokkos::View<int*, Exec>::host_mirror_type answer_on_host_;
};

}  // namespace softwet
