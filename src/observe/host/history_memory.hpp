// What a row of history.csv needs to know of the rows before. Plain data.
#pragma once

#include "observe/host/bodies.hpp"
#include "observe/host/energy_balance.hpp"

namespace softwet {

using Place = std::array<double, 2>;  ///< a point or direction in the plane of the wall, (x, y); 2D: y = 0

/// The contact with the wall of one droplet, bubble or film of the case, from row to row.
struct DropletTrack {
  Place centre{};        ///< of the footprint when last seen; before that, of the droplet or film in the case
  bool on_wall = false;  ///< it had a footprint in the last row
  bool merged = false;   ///< taken over by another droplet of the case; stays so
};

/// A part of the checkpoint.
struct HistoryMemory {
  long step = 0;                       ///< of the last row that follows output.history.every
  double time = 0;                     ///< of that row, on the clock of the computation
  double mass_start = 0;               ///< at step 0
  std::vector<DropletTrack> droplets;  ///< of each body
  std::vector<Body> bodies;
  std::vector<Event> events;  ///< of the whole run
  EnergyBalance energy;
};

}  // namespace softwet
