// From the choice of a case to a time scheme.
#pragma once

#include "time/explicit/explicit_scheme.hpp"
#include "time/implicit/implicit_scheme.hpp"

namespace softwet {

template <int D, int P>
std::unique_ptr<Scheme<D, P>> choose_scheme(const Scene<D, P>& scene, const Case& c, const Judge<D, P>& judge) {
  if (c.time.implicit()) return std::make_unique<ImplicitScheme<D, P>>(scene, c, judge);
  return std::make_unique<ExplicitScheme<D, P>>(scene, c, judge);
}

}  // namespace softwet
