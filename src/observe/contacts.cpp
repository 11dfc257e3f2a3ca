#include "observe/contacts.hpp"

#include <cmath>
#include <memory>

#include "observe/host/places.hpp"

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
  for (int d : {0, 1, 2}) wall.displacement[d] = snapshot.displacement(grid, d, Medium::fluid);
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

/// The cells of one end of a footprint. @param end  what the columns call it
void set_end(const std::string& end, const std::optional<double>& angle, const LineShape& shape, TableRow& cells) {
  cells.set("angle_" + end, angle);
  cells.set("ridge_" + end, shape.ridge);
  cells.set("wall_angle_" + end + "_wet", shape.wall_wet);
  cells.set("wall_angle_" + end + "_dry", shape.wall_dry);
  cells.set("liquid_angle_" + end, shape.liquid);
}

}  // namespace

template <>
std::vector<Contact> find_contacts(const Snapshot<2>& snapshot, const Surface& surface, double capillarity,
                                   const Place&) {
  const Axis& axis = snapshot.layout().axis[0];
  std::vector<Contact> found;
  for (Footprint f : find_footprints(side_view(snapshot, surface), surface, capillarity)) {
    double centre = axis.periodic() ? in_first_turn(f.centre(), axis.length()) : f.centre();
    const double turn = f.centre() - centre;
    f.x_left -= turn, f.x_right -= turn;
    if (snapshot.layout().axisymmetric() && f.cut_left)
      f.x_left = -f.x_right, f.angle_left = f.angle_right, f.left = f.right, centre = 0;
    TableRow cells{{"x_left", f.x_left}, {"x_right", f.x_right}, {"x_centre", centre}, {"dimple", f.dimple}};
    set_end("left", f.angle_left, f.left, cells);
    set_end("right", f.angle_right, f.right, cells);
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
    TableRow cells{{"contact_area", region.area}, {"x_centre", region.centre[0]}, {"y_centre", region.centre[1]}};
    const std::optional<Footprint> section = along(snapshot, region, surface, capillarity, track);
    cells.set("track_rear", section ? TableRow::Cell(section->x_left) : std::nullopt);
    cells.set("track_front", section ? TableRow::Cell(section->x_right) : std::nullopt);
    const Footprint f = section.value_or(Footprint{});
    set_end("rear", f.angle_left, f.left, cells);
    set_end("front", f.angle_right, f.right, cells);
    cells.set("dimple", f.dimple);
    found.push_back({region.centre, cells, [wall, r](const Place& place) { return wall->region_at(place) == r; }});
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
