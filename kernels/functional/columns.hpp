// The columns of history.csv to which several integrals of the momentum belong.
#pragma once

namespace softwet {

inline constexpr const char* momentum_columns[] = {"momentum_x", "momentum_y", "momentum_z"};

}  // namespace softwet
