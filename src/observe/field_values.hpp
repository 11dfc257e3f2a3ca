// The fields of the field table at the points of a grid.
#pragma once

#include <string>
#include <vector>

#include "model/model.hpp"
#include "observe/snapshot.hpp"

namespace softwet {

/// Fields of one material on a tensor grid of reference points. In 2D a tensor is that of plane strain or, in the
/// coordinates (r, z), of axial symmetry, the third axis around the axis.
template <int D, int P>
class FieldValues {
 public:
  using Grid = typename Snapshot<D>::Grid;

  /// @param in_fluid  the points are of the fluid, from the wall up; else of the solid, up to the wall
  FieldValues(const Model<D, P>& model, const Snapshot<D>& snapshot, const Grid& grid, bool in_fluid)
      : model_(model), snapshot_(snapshot), grid_(grid), in_fluid_(in_fluid) {}

  /// Of the field of that name, which this material has (observe/host/field_table.hpp); components fastest: 1, D, or 9
  /// of a tensor, row by row. Scales as in the table.
  std::vector<double> of(const std::string& field);

 private:
  std::vector<double> tensor(const std::string& field);
  std::array<double, 3> place(std::size_t point) const;
  const std::vector<Matrix<double, 3>>& gradients();

  const Model<D, P>& model_;
  const Snapshot<D>& snapshot_;
  const Grid& grid_;
  bool in_fluid_;
  std::vector<Matrix<double, 3>> gradients_;  ///< of the displacement of the solid; empty: not asked for so far
};

}  // namespace softwet
