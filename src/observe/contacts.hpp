// Where the droplets, bubbles and films of a case meet the wall, from row to row of history.csv.
#pragma once

#include <functional>

#include "io/table_row.hpp"
#include "observe/contact_line.hpp"
#include "observe/host/history_memory.hpp"

namespace softwet {

/// A footprint as a row shows it.
struct Contact {
  Place centre;
  TableRow cells;                           ///< all of contact_names but the velocity
  std::function<bool(const Place&)> holds;  ///< whether a place of the wall is under it
};

/// All footprints. In 3D, area and centroid belong to the wetted part of the deformed wall, inside the domain (to the
/// dry part under a bubble). Contact points and angles are taken from the vertical section through the centroid along
/// the track, as in 2D; positions count along the track from the middle of the domain. A droplet that a side cuts next
/// to its centroid is half of a droplet with the side as its plane of symmetry, so its section goes along that side.
/// @param track  unit vector
template <int D>
std::vector<Contact> find_contacts(const Snapshot<D>&, const Surface&, double capillarity, const Place& track);

/// Which contact belongs to which droplet (-1: none). Among several droplets under one footprint, the first keeps it
/// and counts as new on the wall; the others are merged.
std::vector<int> assign_contacts(const std::vector<Contact>&, std::vector<DropletTrack>&);

/// How far `to` lies from `from` along the track, the shorter way round a periodic axis.
template <int D>
double advance(const Layout<D>&, const Place& from, const Place& to, const Place& track);

}  // namespace softwet
