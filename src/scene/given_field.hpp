// A number of the equations that is given at each point.
#pragma once

#include <type_traits>

#include "field/vector.hpp"
#include "memory/array.hpp"

namespace softwet {

/// A field that is known before the run, as control values on some rows of the patch, such as the stiffness on the rows
/// of the solid.
template <class Real>
struct GivenField {
  ArrayOf<Real> values;
  int shift = 0;  ///< control values of the rows below its first one

  /// Control value (0, 0, 0) of the patch; null where there is no such field.
  const Real* origin() const { return values.data() ? values.data() - shift : nullptr; }
};

/// The field in the precision Real.
template <class Real>
GivenField<Real> rounded(const GivenField<double>& field) {
  if constexpr (std::is_same_v<Real, double>) {
    return field;
  } else {
    GivenField<Real> r{{}, field.shift};
    if (!field.values.data()) return r;
    r.values = ArrayOf<Real>("given", field.values.extent(0));
    convert(r.values, field.values);
    return r;
  }
}

}  // namespace softwet
