// A fluid of one density at rest on a solid that is deformed by the same gradient everywhere.
#pragma once

#include "model/initial.hpp"
#include "observe/snapshot.hpp"
#include "time/generalized_alpha.hpp"
#include "unit/model/scenes.hpp"

namespace softwet::testing_tools {

struct Homogeneous {
  static constexpr double density = 0.7;

  Case data;
  Model<2, 2> model;
  State state;

  /// @param gradient  Grad u, rows by component; quadratic splines hold the linear u exactly
  Homogeneous(const Case& c, const Matrix<double, 2>& gradient)
      : data(c), model(c), state(empty_state(model.layout())) {
    const Layout<2>& l = model.layout();
    std::vector<double> x(l.size(), 0.0), u(l.solid_size(), 0.0);
    for (int i = 0; i < l.scalar_size(); ++i) {
      x[l.density_offset() + i] = density;
      x[l.potential_offset() + i] = model.fluid().gas.derivative(density);
    }
    for (int i = 0; i < l.solid_rows() * l.row_size; ++i)
      for (int d = 0; d < 2; ++d)
        u[l.displacement_offset(d) + i] =
            gradient(d, 0) * l.axis[0].greville(i % l.row_size) + gradient(d, 1) * l.axis[1].greville(i / l.row_size);
    state.unknown = to_device<Array>(x);
    state.displacement = to_device<Array>(u);
  }
  Stage stage() const { return stage_at(model.layout(), state); }
  Snapshot<2> snapshot() const { return {model.layout(), state}; }
};

}  // namespace softwet::testing_tools
