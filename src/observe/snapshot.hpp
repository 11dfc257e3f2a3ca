// A host copy of the state of the whole patch that can be evaluated at any point.
#pragma once

#include "field/stage.hpp"
#include "spline/evaluate.hpp"
#include "spline/region.hpp"

namespace softwet {

/// Rows of elements [first, last) along the vertical axis. A point on a line of elements at their end is taken from
/// their side.
struct ElementRows {
  int first, last;
};

/// On which side of the wall a point lies: on the wall both are possible.
enum class Medium { fluid, solid };

/// What a snapshot holds of a state.
/// Without velocities it lacks what branches of a solid remember too.
enum class SnapshotOf { all_fields, all_but_velocity };

/// Copies of a state in memory of the host to which a device copies by itself, while it and the host go on.
template <int D>
class SnapshotCopies {
 public:
  /// Starts them. A start before is forgotten; its memory is used again.
  void start(const Layout<D>& layout, const State& state, SnapshotOf parts);

 private:
  template <int>
  friend class Snapshot;

  class Copy {
   public:
    void start(const ConstArray&);
    std::vector<double> take();

   private:
    ConstArray array_;  ///< source of the copy
    HostArray room_;
  };
  Copy velocity_, scalars_, displacement_, memory_;
};

/// Fields of a state on tensor grids of reference points. 2D: plane strain. Among several processes the first one has
/// the fields, and it alone can evaluate them.
template <int D>
class Snapshot {
 public:
  /// Collects the state of all processes on the first one: all have to call it.
  Snapshot(const Layout<D>& layout, const State& state, SnapshotOf parts = SnapshotOf::all_fields);
  /// Takes started copies that have arrived: the host has waited for the execution space since.
  Snapshot(const Layout<D>& layout, SnapshotCopies<D>& copies);

  using Grid = std::array<std::vector<double>, D>;  ///< reference coordinates per axis

  /// Velocity component d at points of the fluid (from the wall up) or of the solid (up to the wall).
  std::vector<double> velocity(const Grid&, int d, Medium) const;
  std::vector<double> density(const Grid&, int derivative = -1) const;
  std::vector<double> chemical_potential(const Grid&) const;
  /// Displacement of the material in the solid, of the mesh in the fluid (blended from the wall).
  std::vector<double> displacement(const Grid&, int d, Medium) const;
  /// du_d/dX_axis of the solid. It jumps at a joint, where it follows from the rows of one part.
  std::vector<double> displacement_gradient(const Grid&, int d, int axis, ElementRows) const;
  /// Gradient of the velocity of the solid, likewise.
  std::vector<double> velocity_gradient(const Grid&, int d, int axis, ElementRows) const;
  /// Gradient of the displacement that branch number `branch` remembers, under small strains.
  std::vector<double> branch_gradient(const Grid&, int branch, int d, int axis, ElementRows) const;
  std::vector<double> branch_displacement(const Grid&, int branch, int d) const;
  /// The displacement of the solid sampled in other ways than at points, such as by means over elements.
  std::vector<double> displacement(const std::array<AxisSamples, D>&, int d) const;
  /// What the branches of the solid remember (State::memory); empty without branches.
  const std::vector<double>& memory() const { return memory_; }

  const Layout<D>& layout() const { return layout_; }  ///< of the whole patch
  ElementRows fluid_rows() const { return {layout_.solid_elements, layout_.axis[D - 1].elements()}; }
  ElementRows solid_rows() const { return {0, layout_.solid_elements}; }
  /// The solid in the parts below and above its joint; without one it is one part.
  std::vector<ElementRows> solid_parts() const;
  double wall_height() const { return layout_.axis[D - 1].lower(layout_.solid_elements); }

 private:
  /// @param first  of the component's control values among `values`
  /// @throws std::logic_error  where these are not here
  std::vector<double> component(const std::vector<double>& values, int first, int rows, const Grid&, int shift,
                                int lowest, int highest, int derivative = -1) const;

  Layout<D> layout_;
  std::vector<double> velocity_, scalars_, displacement_, memory_;  ///< scalars: density and chemical potential
};

}  // namespace softwet
