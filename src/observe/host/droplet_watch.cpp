#include "observe/host/droplet_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace softwet {
namespace {

/// A connected set of points inside.
struct Region {
  int deepest;           ///< the point that is the most steps away from the points outside
  unsigned touched = 0;  ///< as in Body
};

/// The connected regions of a grid: points are neighbours along the axes, also across a periodic end.
class Regions {
 public:
  explicit Regions(const PhaseSamples& samples) : samples_(samples), label_(samples.depth.size(), -1) {
    for (int d = 0; d < samples_.dimension; ++d)
      for (int i = 0; i < samples_.points[d]; ++i) beyond_fine_.at(d).push_back(fine_ends_at(d, i));
    for (std::size_t p = 0; p < label_.size(); ++p)
      if (samples_.inside(p) && label_[p] < 0) flood(static_cast<int>(p));
    find_deepest();
  }

  const std::vector<Region>& all() const { return regions_; }
  unsigned wall_bit() const { return samples_.periodic[vertical()] ? 0U : 1U << (2 * vertical()); }

  std::array<double, 3> place(int point) const {
    const std::array<int, 3> index = index_of(point);
    std::array<double, 3> x{};
    for (int d = 0; d < samples_.dimension; ++d) x[d] = samples_.origin[d] + samples_.step[d] * index[d];
    return x;
  }

  /// The region at the point closest to a position; -1: none.
  int at(const std::array<double, 3>& x) const {
    int point = 0;
    for (int d = samples_.dimension - 1; d >= 0; --d) {
      const int n = samples_.points[d];
      const int i = static_cast<int>(std::lround((x[d] - samples_.origin[d]) / samples_.step[d]));
      point = point * n + (samples_.periodic[d] ? (i % n + n) % n : std::min(std::max(i, 0), n - 1));
    }
    return label_[point];
  }

  /// The centres of all regions, as `centres_of` has them.
  std::vector<std::array<double, 3>> centres() const {
    struct Sums {
      double weight = 0;
      std::array<double, 3> first{}, sine{};
    };
    std::vector<Sums> sums(regions_.size());
    for (std::size_t p = 0; p < label_.size(); ++p) {
      if (label_[p] < 0) continue;
      Sums& of = sums[label_[p]];
      const std::array<double, 3> x = place(static_cast<int>(p));
      const double w = samples_.depth[p] * (samples_.rings.empty() ? 1 : samples_.rings[p % samples_.points[0]]);
      of.weight += w;
      for (int d = 0; d < samples_.dimension; ++d) {
        of.first[d] += w * (samples_.periodic[d] ? std::cos(x[d] / radian(d)) : x[d]);
        of.sine[d] += samples_.periodic[d] ? w * std::sin(x[d] / radian(d)) : 0;
      }
    }
    std::vector<std::array<double, 3>> middles(sums.size());
    for (std::size_t r = 0; r < sums.size(); ++r)
      for (int d = 0; d < samples_.dimension && sums[r].weight > 0; ++d) {
        const double first = sums[r].first[d], sine = sums[r].sine[d], weight = sums[r].weight;
        if (!samples_.rings.empty() && d == 0) continue;  // on the axis
        const bool all_round = samples_.periodic[d] && std::hypot(first, sine) < 1e-6 * weight;
        if (!all_round) middles[r][d] = samples_.periodic[d] ? radian(d) * std::atan2(sine, first) : first / weight;
      }
    return middles;
  }

  /// The region closest to a position that is not taken; -1: none.
  int nearest(const std::array<double, 3>& x, const std::vector<bool>& taken) const {
    double least = std::numeric_limits<double>::infinity();
    int found = -1;
    for (std::size_t p = 0; p < label_.size(); ++p) {
      if (label_[p] < 0 || taken[label_[p]]) continue;
      const std::array<double, 3> y = place(static_cast<int>(p));
      double square = 0;
      for (int d = 0; d < samples_.dimension; ++d) {
        const double away = y[d] - x[d], length = samples_.step[d] * samples_.points[d];
        square += std::pow(samples_.periodic[d] ? std::remainder(away, length) : away, 2);
      }
      if (square < least) least = square, found = label_[p];
    }
    return found;
  }

 private:
  int vertical() const { return samples_.dimension - 1; }
  /// Length of a periodic axis that is one radian.
  double radian(int axis) const { return samples_.step[axis] * samples_.points[axis] / 6.283185307179586; }

  std::array<int, 3> index_of(int point) const {
    const auto& n = samples_.points;
    return {point % n[0], point / n[0] % n[1], point / n[0] / n[1]};
  }

  /// Calls visit(axis, end, neighbour) for each direction; neighbour -1: the point lies on that side of the domain.
  template <class Visit>
  void each_neighbour(int point, const Visit& visit) const {
    const std::array<int, 3> index = index_of(point);
    int stride = 1;
    for (int d = 0; d < samples_.dimension; stride *= samples_.points[d], ++d)
      for (int end : {0, 1}) {
        const int n = samples_.points[d], next = index[d] + (end == 0 ? -1 : 1);
        const int around = next < 0 ? n - 1 : next < n ? next : 0;
        visit(d, end, around == next || samples_.periodic[d] ? point + (around - index[d]) * stride : -1);
      }
  }

  /// A position on a periodic axis, shifted by whole periods as close to the middle of the fine elements as possible.
  double nearest_to_fine_part(int d, double x) const {
    const double middle = 0.5 * (samples_.low[d] + samples_.high[d]);
    return std::isfinite(middle) ? middle + std::remainder(x - middle, samples_.step[d] * samples_.points[d]) : x;
  }

  /// The ends of the fine elements that a place along an axis lies beyond, as bits of `Body::touched`.
  unsigned fine_ends_at(int d, int index) const {
    const double x = samples_.origin[d] + samples_.step[d] * index;
    const double at = samples_.periodic[d] ? nearest_to_fine_part(d, x) : x;
    return (at < samples_.low[d] ? 1U << (first_bit_of_fine_ends + 2 * d) : 0U) |
           (at > samples_.high[d] ? 1U << (first_bit_of_fine_ends + 2 * d + 1) : 0U);
  }

  void flood(int start) {
    const int label = static_cast<int>(regions_.size());
    regions_.push_back({.deepest = start});
    std::vector<int> open{start};
    label_[start] = label;
    while (!open.empty()) {
      const int point = open.back();
      open.pop_back();
      const std::array<int, 3> index = index_of(point);
      for (int d = 0; d < samples_.dimension; ++d) regions_[label].touched |= beyond_fine_[d][index[d]];
      each_neighbour(point, [&](int axis, int end, int next) {
        if (next < 0) {
          regions_[label].touched |= 1U << (2 * axis + end);
        } else if (!samples_.inside(next)) {
          shore_.push_back(next);
        } else if (label_[next] < 0) {
          label_[next] = label;
          open.push_back(next);
        }
      });
    }
  }

  /// Goes inwards from all points outside that have a neighbour inside, at once; the last point reached of a region is
  /// its deepest.
  void find_deepest() {
    std::vector<char> reached(label_.size());
    std::sort(shore_.begin(), shore_.end());
    shore_.erase(std::unique(shore_.begin(), shore_.end()), shore_.end());
    std::vector<int> front = shore_;
    for (std::size_t k = 0; k < front.size(); ++k)
      each_neighbour(front[k], [&](int, int, int next) {
        if (next < 0 || label_[next] < 0 || reached[next]) return;
        reached[next] = true;
        regions_[label_[next]].deepest = next;
        front.push_back(next);
      });
  }

  const PhaseSamples& samples_;
  std::vector<int> label_;                            ///< the region of each point; -1: outside
  std::vector<int> shore_;                            ///< points outside with a neighbour inside
  std::array<std::vector<unsigned>, 3> beyond_fine_;  ///< of each place along each axis: `fine_ends_at`
  std::vector<Region> regions_;
};

/// The region of each body; -1: it has none, or it is gone.
std::vector<int> find_bodies(const std::vector<Body>& bodies, const Regions& regions) {
  std::vector<int> region_of(bodies.size(), -1);
  std::vector<bool> taken(regions.all().size(), false);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (!bodies[k].gone) region_of[k] = regions.at(bodies[k].place);
    if (region_of[k] >= 0) taken[region_of[k]] = true;
  }
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].gone || region_of[k] >= 0) continue;
    region_of[k] = regions.nearest(bodies[k].place, taken);
    if (region_of[k] >= 0) taken[region_of[k]] = true;
  }
  return region_of;
}

std::string vanished(const std::string& name, bool nothing_left, bool bubbles) {
  if (!nothing_left) return name + " vanished";
  return name + (bubbles ? " vanished: no vapour is left, and the run goes on with liquid alone"
                         : " vanished: no liquid is left, and the run goes on with vapour alone");
}

std::string side_name(int axis, int end, int dimension) {
  if (axis == dimension - 1) return end == 0 ? "the wall" : "the top";
  const char* const names[2][2] = {{"left", "right"}, {"front", "back"}};
  return std::string("the ") + names[axis][end] + " side";
}

/// Reports the sides that a body has met since the last state.
void meet_sides(Body& body, const Region& region, const std::string& name, int dimension, unsigned wall_bit,
                std::vector<std::string>& said) {
  const unsigned fresh = region.touched & ~body.touched;
  for (int side = 0; side < 2 * dimension; ++side)
    if (body.seen && (fresh & 1U << side) != 0)
      said.push_back(name + " reached " + side_name(side / 2, side % 2, dimension));
  for (int end = 0; end < 2 * dimension; ++end)
    if (body.seen && (fresh & 1U << (first_bit_of_fine_ends + end)) != 0)
      said.push_back(name + " came near the end of the fine elements, towards " +
                     side_name(end / 2, end % 2, dimension) +
                     ": longer elements within its interface would drive it; write a larger domain.grading.box");
  body.touched |= region.touched;
  const bool on_wall = (region.touched & wall_bit) != 0;
  if (body.on_wall && !on_wall && !body.left_wall) {
    said.push_back(name + " lost its contact line: it no longer touches the wall");
    body.left_wall = true;
  }
  body.on_wall = on_wall;
}

}  // namespace

std::vector<std::string> follow(std::vector<Body>& bodies, const PhaseSamples& samples,
                                const std::vector<std::string>& names) {
  const Regions regions(samples);
  const std::vector<int> region_of = find_bodies(bodies, regions);
  std::vector<std::string> said;
  std::vector<int> owner(regions.all().size(), -1);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    Body& body = bodies[k];
    if (body.gone) continue;
    const int r = region_of[k];
    if (r < 0) {
      body.gone = true;
      said.push_back(vanished(names[k], regions.all().empty(), samples.bubbles));
    } else if (owner[r] >= 0) {
      body.gone = true;
      said.push_back(names[owner[r]] + " and " + names[k] + (body.seen ? " merged" : " are one from the start"));
      bodies[owner[r]].touched |= body.touched;
    } else {
      owner[r] = static_cast<int>(k);
    }
  }
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].gone) continue;
    const Region& region = regions.all()[region_of[k]];
    meet_sides(bodies[k], region, names[k], samples.dimension, regions.wall_bit(), said);
    bodies[k].place = regions.place(region.deepest);
    bodies[k].seen = true;
  }
  return said;
}

std::vector<Centre> centres_of(const std::vector<Body>& bodies, const PhaseSamples& samples) {
  const Regions regions(samples);
  const std::vector<std::array<double, 3>> of_regions = regions.centres();
  std::vector<Centre> centres;
  for (const Body& body : bodies) {
    const int region = body.gone ? -1 : regions.at(body.place);
    centres.push_back(region < 0 ? Centre() : of_regions[region]);
  }
  return centres;
}

std::vector<std::optional<double>> distances(const std::vector<Centre>& from, const std::vector<Centre>& to,
                                             const PhaseSamples& samples) {
  std::vector<std::optional<double>> moved(to.size());
  for (std::size_t k = 0; k < to.size(); ++k) {
    if (!from[k] || !to[k]) continue;
    double square = 0;
    for (int d = 0; d < samples.dimension; ++d) {
      const double away = (*to[k])[d] - (*from[k])[d], length = samples.step[d] * samples.points[d];
      square += std::pow(samples.periodic[d] ? std::remainder(away, length) : away, 2);
    }
    moved[k] = std::sqrt(square);
  }
  return moved;
}

}  // namespace softwet
