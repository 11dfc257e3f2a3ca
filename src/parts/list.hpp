// The subjects that have a room of their own.
#pragma once

#include "parts/foundation/keys.hpp"

namespace softwet {

struct Parts {
  FoundationPart foundation;

  template <class Visit>
  void each(const Visit& visit) const {
    visit(foundation);
  }
};

}  // namespace softwet
