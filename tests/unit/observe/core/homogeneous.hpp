// A fluid of one density at rest on a solid that is deformed by the same gradient everywhere.
#pragma once

#include "observe/snapshot.hpp"
#include "scene/initial.hpp"
#include "time/implicit/generalized_alpha.hpp"
#include "unit/scene/scenes.hpp"

namespace softwet::testing_tools {

struct Homogeneous {
  static constexpr double density = 0.7;

  Case data;
  Matrix<double, 2> gradient;
  Scene<2, 2> scene;
  State state;

  /// @param gradient  Grad u, rows by component; quadratic splines hold the linear u exactly
  Homogeneous(const Case& c, const Matrix<double, 2>& grad_u)
      : data(c), gradient(grad_u), scene(c), state(empty_state(scene.layout())) {
    const Layout<2>& l = scene.layout();
    std::vector<double> x(l.size(), 0.0), u(l.solid_size(), 0.0);
    for (int i = 0; i < l.scalar_size(); ++i) {
      x[l.density_offset() + i] = density;
      x[l.potential_offset() + i] = scene.coefficients().fluid().gas.derivative(density);
    }
    for (int i = 0; i < l.solid_rows() * l.row_size; ++i)
      for (int d = 0; d < 2; ++d)
        u[l.displacement_offset(d) + i] =
            gradient(d, 0) * l.axis[0].greville(i % l.row_size) + gradient(d, 1) * l.axis[1].greville(i / l.row_size);
    state.unknown = to_device<Array>(x);
    state.displacement = to_device<Array>(u);
  }
  /// Another density of the fluid.
  void fill(double of_fluid) {
    const int first = scene.layout().density_offset();
    std::vector<double> values = to_host(state.unknown);
    for (int i = 0; i < scene.layout().scalar_size(); ++i) values[first + i] = of_fluid;
    state.unknown = to_device<Array>(values);
  }
  /// Another slope du_y/dY above a height, which is the joint of the solid.
  void kink(double height, double slope) {
    const Layout<2>& l = scene.layout();
    std::vector<double> values = to_host(state.displacement);
    for (int i = 0; i < l.solid_rows() * l.row_size; ++i) {
      const double above = std::max(0.0, l.axis[1].greville(i / l.row_size) - height);
      values[l.displacement_offset(1) + i] += (slope - gradient(1, 1)) * above;
    }
    state.displacement = to_device<Array>(values);
  }
  Stage stage() const { return stage_at(scene.layout(), state); }
  Snapshot<2> snapshot() const { return {scene.layout(), state}; }
};

/// A column of two materials, the upper one a hundred times stiffer, under the same stress: both are pushed together
/// along y, by `below` and by a hundredth of it above the joint, the end of so many of its six rows.
struct Joined : Homogeneous {
  static constexpr double height = 0.8, below = -1e-2, above = -1e-4, modulus_below = 3.5;  ///< lambda + 2 G

  double joint;

  explicit Joined(int row) : Homogeneous(joined(row), {{{0, 0}, {0, below}}}), joint(height * row / 6) {
    kink(joint, above);
  }

 private:
  /// At the joint the formula has the value of one side, as a user writes it.
  struct Jump : Formula {
    double joint;
    explicit Jump(double y) : joint(y) {}
    double at(const std::array<double, 3>& x, double) const override { return x[1] <= joint ? 2 : 200; }
  };
  static Case joined(int row) {
    Case c = small_case(SceneKind::solid);
    c.substrate->strain = Strain::small;
    c.substrate->joint = height * row / 6;
    Profile& young = c.substrate->young;
    young.text = "jump", young.formula = std::make_shared<Jump>(c.substrate->joint), young.lowest = 2,
    young.highest = 200;
    return c;
  }
};

}  // namespace softwet::testing_tools
