// A search for places where a mesh is folded or a solid turned inside out, which the host does not wait for.
#pragma once

#include "scene/balance.hpp"
#include "scene/slope_bound.hpp"

namespace softwet {

/// `Balance::faults` in two halves. The kernel of the first half bounds the slopes of the motion. Only where the bound
/// does not exclude faults, the second half searches the Gauss points. A scene whose mesh does not move needs neither.
/// Tested: tests/unit/scene/test_fault_search.cpp
template <int D, int P>
class FaultSearch {
 public:
  FaultSearch(const Regions<D>& regions, const Balance<D, P>& balance)
      : moves_(regions.layout().has_solid), balance_(balance), bound_(regions) {}

  /// How many numbers the kernel leaves for the host.
  int numbers() const { return moves_ ? bound_.numbers : 0; }
  /// Starts the kernel that writes them.
  void ask(const Stage& stage, const Array& numbers) const {
    if (moves_) bound_.ask(stage, numbers);
  }
  /// The faults of that stage, for numbers that lie in memory of the host.
  MeshFaults take(const Stage& stage, const double* numbers) const {
    return !moves_ || bound_.excludes_faults(numbers) ? MeshFaults{} : balance_.faults(stage);
  }

 private:
  bool moves_;
  const Balance<D, P>& balance_;
  SlopeBound<D, P> bound_;
};

}  // namespace softwet
