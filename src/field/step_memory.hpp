// What a program remembers from one time step to the next in addition to its state, as a checkpoint sees it.
#pragma once

#include "memory/array.hpp"

namespace softwet {

/// Visits, under names, what decides about the bits of later steps and does not follow from the state. The same visit
/// writes a checkpoint and reads one, so that nothing can be forgotten in one of the two. Vectors are lines of columns
/// of the patch; each of several processes has its own columns of them. All processes make the same visits in the same
/// order.
class StepMemory {
 public:
  virtual ~StepMemory() = default;

  /// Whether the visit puts values back. Else it looks at them.
  virtual bool restores() const = 0;
  virtual void number(const std::string& name, double& value) = 0;  ///< finite
  virtual void count(const std::string& name, int& value) = 0;      ///< 0 or more
  virtual void vector(const std::string& name, const Array& values) = 0;
  virtual void vector(const std::string& name, const ArrayOf<float>& values) = 0;

  void flag(const std::string& name, bool& value) {
    int number = value ? 1 : 0;
    count(name, number);
    value = number != 0;
  }
};

}  // namespace softwet
