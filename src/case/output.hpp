// What a run writes.
#pragma once

#include <string>
#include <vector>

#include "case/choices.hpp"

namespace softwet {

/// A number of each row of history.csv: of a quantity at a point, on a line, a face or in a box of the undeformed
/// domain.
struct Probe {
  std::string name;           ///< of the column
  std::string quantity;       ///< one of probe_quantities() (observe/host/probe_quantity.hpp)
  std::vector<double> point;  ///< L0; empty: a box is given
  std::vector<double> lower,
      upper;  ///< corners, equal along an axis where the box has no extent; empty: a point is given
  ProbeOperation operation = ProbeOperation::value;

  const std::vector<double>& low() const { return point.empty() ? lower : point; }
  const std::vector<double>& high() const { return point.empty() ? upper : point; }
};

struct OutputControl {
  int history_every = 1;
  std::vector<double> track;  ///< 3D: horizontal direction along which droplets are followed; empty: x
  std::vector<double> field_times;
  double field_every = 0;                 ///< interval from t = 0 on; 0: none
  std::vector<std::string> field_select;  ///< names of fields (observe/host/field_table.hpp); empty: all
  double checkpoint_minutes = 10;
};

}  // namespace softwet
