// The format of what a preconditioner remembers.
#pragma once

#include <string>

#include "memory/array.hpp"
#include "solver/direct/host/packed_block.hpp"

namespace softwet {

/// How this program computes a preconditioner: another program computes other bits.
inline std::string preconditioner_format() {
  return "algorithms of a " + std::string(host_algorithms ? "processor" : "device") + ", factors of " +
         std::to_string(sizeof(FactorNumber)) + " bytes";
}

}  // namespace softwet
