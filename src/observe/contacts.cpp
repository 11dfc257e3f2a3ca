#include "observe/contacts.hpp"

#include <cmath>
#include <memory>

#include "observe/host/table_columns.hpp"

namespace softwet {
namespace {

/// The wall, four samples per element and axis as along a contact line in 2D.
WallSamples sample_wall(const Snapshot<3>& snapshot, const Surface& surface) {
  const std::vector<Axis>& axis = snapshot.layout().axis;
  WallSamples wall{};
  Snapshot<3>::Grid grid;
  for (int d : {0, 1}) {
    wall.length[d] = axis[d].length();
    wall.cells[d] = 4 * axis[d].equal_parts();
    wall.periodic[d] = axis[d].periodic();
    grid[d] = equidistant(0, axis[d].length(), wall.cells[d]);
    grid[d].resize(wall.points(d));
  }
  grid[2] = {snapshot.wall_height()};
  wall.depth = surface.depth(snapshot.density(grid));
  for (int d : {0, 1, 2}) wall.displacement[d] = snapshot.displacement(grid, d, true);
  return wall;
}

/// The footprint of a region in the section along the track.
std::optional<Footprint> along(const Snapshot<3>& snapshot, const WettedRegion& region, const Surface& surface,
                               double capillarity, const Place& track) {
  Place through = region.reference_centre;
  for (int d : {0, 1})
    if (region.cut[d] != 0) through[d] = region.cut[d] < 0 ? 0 : snapshot.layout().axis[d].length();
  const Section<3> section = side_view(snapshot, through, track);
  const double inside = section.current(along_track(snapshot.layout(), through, track), snapshot.wall_height())[0];
  for (const Footprint& f : find_footprints(section, surface, capillarity))
    if (f.holds(inside)) return f;
  return std::nullopt;
}

/// The columns that tell the shape beside the contact lines.
std::vector<std::optional<double>> shape_cells(const Footprint& f) {
  return {f.left.ridge,     f.right.ridge,    f.left.wall_wet, f.left.wall_dry, f.left.liquid,
          f.right.wall_wet, f.right.wall_dry, f.right.liquid,  f.dimple};
}

}  // namespace

template <>
std::vector<Contact> find_contacts(const Snapshot<2>& snapshot, const Surface& surface, double capillarity,
                                   const Place&) {
  const Axis& axis = snapshot.layout().axis[0];
  std::vector<Contact> found;
  for (Footprint f : find_footprints(side_view(snapshot, surface), surface, capillarity)) {
    const double turn = axis.periodic() ? axis.length() * std::floor(f.centre() / axis.length()) : 0;
    f.x_left -= turn, f.x_right -= turn;
    if (snapshot.layout().axisymmetric && f.x_left == 0)
      f.x_left = -f.x_right, f.angle_left = f.angle_right, f.left = f.right;
    std::vector<std::optional<double>> cells{f.x_left,     f.x_right,    f.centre(),
                                             std::nullopt, f.angle_left, f.angle_right};
    for (const std::optional<double>& cell : shape_cells(f)) cells.push_back(cell);
    found.push_back({{f.centre(), 0}, cells, [f, axis](const Place& place) {
                       const double away = place[0] - f.centre();
                       return f.holds(f.centre() + (axis.periodic() ? std::remainder(away, axis.length()) : away));
                     }});
  }
  return found;
}

template <>
std::vector<Contact> find_contacts(const Snapshot<3>& snapshot, const Surface& surface, double capillarity,
                                   const Place& track) {
  const auto wall = std::make_shared<const WettedWall>(sample_wall(snapshot, surface));
  std::vector<Contact> found;
  for (int r = 0; r < static_cast<int>(wall->regions().size()); ++r) {
    const WettedRegion& region = wall->regions()[r];
    Contact contact{region.centre,
                    {region.area, region.centre[0], region.centre[1], std::nullopt},
                    [wall, r](const Place& place) { return wall->region_at(place) == r; }};
    contact.cells.resize(contact_names(3).size());
    if (const auto f = along(snapshot, region, surface, capillarity, track)) {
      std::vector<std::optional<double>> seen{f->x_left, f->x_right, f->angle_left, f->angle_right};
      for (const std::optional<double>& cell : shape_cells(*f)) seen.push_back(cell);
      std::copy(seen.begin(), seen.end(), contact.cells.begin() + velocity_column + 1);
    }
    found.push_back(contact);
  }
  return found;
}

std::vector<int> assign_contacts(const std::vector<Contact>& found, std::vector<DropletTrack>& droplets) {
  std::vector<int> of_droplet(droplets.size(), -1);
  std::vector<int> grown;
  for (std::size_t f = 0; f < found.size(); ++f) {
    int owner = -1;
    for (std::size_t k = 0; k < droplets.size(); ++k) {
      if (droplets[k].merged || !found[f].holds(droplets[k].centre)) continue;
      if (owner < 0 || (droplets[k].on_wall && !droplets[owner].on_wall)) {
        owner = static_cast<int>(k);
      } else if (droplets[k].on_wall) {
        droplets[k].merged = true;
        grown.push_back(owner);
      }
    }
    if (owner >= 0) of_droplet[owner] = static_cast<int>(f);
  }
  for (int owner : grown) droplets[owner].on_wall = false;
  return of_droplet;
}

template <int D>
double advance(const Layout<D>& layout, const Place& from, const Place& to, const Place& track) {
  double sum = 0;
  for (int d = 0; d < D - 1; ++d) {
    const double away = to[d] - from[d];
    sum += track[d] * (layout.axis[d].periodic() ? std::remainder(away, layout.axis[d].length()) : away);
  }
  return sum;
}

template double advance(const Layout<2>&, const Place&, const Place&, const Place&);
template double advance(const Layout<3>&, const Place&, const Place&, const Place&);

}  // namespace softwet
