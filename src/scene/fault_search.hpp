// A search for places where a mesh is folded or a solid turned inside out, which the host does not wait for.
#pragma once

#include "scene/balance.hpp"

namespace softwet {

/// `Balance::faults` in two halves. A scene whose mesh does not move needs no kernels.
template <int D, int P>
class FaultSearch {
 public:
  explicit FaultSearch(const Regions<D>& regions);

  /// How many numbers kernels leave for the host.
  int numbers() const { return of_fluid_ + of_solid_; }
  /// Starts the kernels that write them.
  void ask(const Stage&, const Array& numbers) const;
  /// What they say, for numbers that lie in memory of the host.
  template <class Numbers>
  MeshFaults take(const Numbers& numbers) const {
    return faults(numbers.data());
  }

 private:
  MeshFaults faults(const double* numbers) const;

  const Regions<D>& regions_;
  int of_fluid_ = 0, of_solid_ = 0;
};

}  // namespace softwet
