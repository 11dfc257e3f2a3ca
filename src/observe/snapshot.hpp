// A host copy of the state of the whole patch that can be evaluated anywhere.
#pragma once

#include "field/stage.hpp"
#include "spline/evaluate.hpp"
#include "spline/region.hpp"

namespace softwet {

/// Fields of a state on tensor grids of reference points. 2D: plane strain.
template <int D>
class Snapshot {
 public:
  /// Collects the state of all processes, on each of them.
  Snapshot(const Layout<D>& layout, const State& state);

  using Grid = std::array<std::vector<double>, D>;  ///< reference coordinates per axis

  /// Velocity component d at points of the fluid (from the wall up) or of the solid (up to the wall).
  std::vector<double> velocity(const Grid&, int d, bool in_fluid) const;
  std::vector<double> density(const Grid&, int derivative = -1) const;
  std::vector<double> chemical_potential(const Grid&) const;
  /// Displacement of the material in the solid, of the mesh in the fluid (blended from the wall).
  std::vector<double> displacement(const Grid&, int d, bool in_fluid) const;
  /// du_d/dX_axis of the solid; at the wall the one from below.
  std::vector<double> displacement_gradient(const Grid&, int d, int axis) const;

  const Layout<D>& layout() const { return layout_; }  ///< of the whole patch
  double wall_height() const { return layout_.axis[D - 1].lower(layout_.solid_elements); }
  double density_min() const { return extreme(layout_.density_offset(), layout_.scalar_size(), -1); }
  double density_max() const { return extreme(layout_.density_offset(), layout_.scalar_size(), 1); }
  /// Largest |control value| of the velocity on the rows of the fluid (wall included) or of the solid.
  double speed_max(bool in_fluid) const;
  /// The same of control points whose density is above a level.
  double speed_max_above(double density) const;

 private:
  std::vector<double> component(const double* box, int rows, const Grid&, int shift, int lowest, int highest,
                                int derivative = -1) const;
  double extreme(int first, int count, int sign) const;

  Layout<D> layout_;
  std::vector<double> unknown_, displacement_;
};

}  // namespace softwet
