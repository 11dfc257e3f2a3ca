// Memory of Kokkos for teams on a device.
#pragma once

#include "memory/array.hpp"

namespace softwet {

struct NoWork {
  KOKKOS_FUNCTION void operator()(const Teams<>::member_type&) const {}
};

/// Lets Kokkos have memory for teams, once after its start. While it has none it asks a device for memory whenever
/// teams start, even where they need none. That takes time, and is forbidden while launches are recorded
/// (solver/recording.hpp).
inline void reserve_team_scratch() {
  if constexpr (!on_host) {
    Kokkos::parallel_for("softwet::reserve_team_scratch", Teams<>(1, 1).set_scratch_size(1, Kokkos::PerTeam(64)),
                         NoWork());
    Kokkos::fence("softwet::reserve_team_scratch");
  }
}

}  // namespace softwet
