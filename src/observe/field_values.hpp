// The fields of the field table at the points of a grid.
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "observe/snapshot.hpp"
#include "scene/coefficients.hpp"

namespace softwet {

/// Adds values behind those that are there.
inline void append(const std::vector<double>& more, std::vector<double>& to) {
  to.insert(to.end(), more.begin(), more.end());
}

/// Fields of one material on a tensor grid of reference points. In 2D a tensor describes plane strain or, in the
/// coordinates (r, z), axial symmetry, where the third axis goes around the axis.
template <int D>
class FieldValues {
 public:
  using Grid = typename Snapshot<D>::Grid;

  /// @param rows  the elements that the points lie in: of the fluid, from the wall up, or of one part of the solid.
  ///   What jumps at their ends is read from inside of them.
  FieldValues(const Case& c, const Coefficients<D>& coefficients, const Snapshot<D>& snapshot, const Grid& grid,
              ElementRows rows)
      : case_(c),
        coefficients_(coefficients),
        snapshot_(snapshot),
        grid_(grid),
        rows_(rows),
        medium_(rows.first >= snapshot.layout().solid_elements ? Medium::fluid : Medium::solid) {}

  /// Values of the field with this name, which this material has (observe/host/field_table.hpp); components fastest: 1,
  /// D, or 9 of a tensor, row by row. Scales as in the table.
  std::vector<double> of(const std::string& field);

 private:
  std::vector<double> tensor(const std::string& field);
  const std::vector<Matrix<double, 3>>& gradients();

  const Case& case_;
  const Coefficients<D>& coefficients_;
  const Snapshot<D>& snapshot_;
  const Grid& grid_;
  ElementRows rows_;
  Medium medium_;
  std::vector<Matrix<double, 3>> gradients_;  ///< of the displacement of the solid; empty: not asked for so far
};

}  // namespace softwet
