#include "casefile/checks/fine_box.hpp"

#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "case/cap.hpp"
#include "case/mesh.hpp"

namespace softwet {
namespace {

constexpr double margin = 4, margin_above = 2.2;  ///< in capillarities: along the wall, and above droplets on it
constexpr int fine_rows_below = 4;                ///< of the solid below the wall that stay fine
constexpr double part_of_way = 0.8;               ///< to a load that a droplet may go: that of the paper goes 0.76
/// Below it a load may not hold its droplet: at 0.15 it crosses (docs/validation.md).
constexpr double least_poisson_that_holds = 0.25;

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  void take(double from, double to) {
    low = std::min(low, from);
    high = std::max(high, to);
  }
};

double largest_radius(const Droplet& droplet) {
  double largest = 1;
  for (const double stretch : droplet.stretch) largest = std::max(largest, stretch);
  return largest * droplet.radius;
}

/// Largest distance of a droplet's surface from its axis.
double half_width(const Case& c, const Droplet& droplet) {
  const double radius = largest_radius(droplet);
  if (!sits_on_wall(c, droplet)) return radius;
  const double cosine = cap_cosine(c, droplet);
  return cosine > 0 ? radius * std::sqrt(1 - cosine * cosine) : radius;
}

/// Whether droplets will leave where they are, in ways that the box does not follow.
bool goes_anywhere(const Case& c) {
  if (!c.fluid || c.initial || !c.waves.empty() || (c.droplets.empty() && c.films.empty()) || !c.needles.empty())
    return true;
  for (const Load& load : c.loads)
    if (!load.path.empty()) return true;
  for (const Droplet& droplet : c.droplets) {
    for (const double v : droplet.velocity)
      if (v != 0) return true;
    const double gap = droplet.centre.back() - largest_radius(droplet) - c.wall_height();
    if (!sits_on_wall(c, droplet) && gap < margin * c.fluid->capillarity) return true;  // it spreads
  }
  return false;
}

/// Whether something drives droplets along an axis wherever they are.
bool is_driven(const Case& c, std::size_t axis) {
  const auto& gravity = c.fluid->gravity;
  if (axis < gravity.size() && gravity[axis] != 0) {
    if (axis + 1 < c.domain.size.size()) return true;
    for (const Droplet& droplet : c.droplets)
      if (!sits_on_wall(c, droplet)) return true;
  }
  const bool along_wall = axis + 1 < c.domain.size.size();
  return along_wall && (c.fluid->contact_angle.varies() ||
                        (c.substrate && (c.substrate->young.varies() || c.substrate->fibre.stiffness > 0)));
}

double gap_to(const Droplet& droplet, const Load& load) {
  double square = 0;
  for (std::size_t d = 0; d + 1 < droplet.centre.size(); ++d)
    square += std::pow(std::max({load.lower[d] - droplet.centre[d], droplet.centre[d] - load.upper[d], 0.0}), 2);
  return std::sqrt(square);
}

/// How far a load may draw a droplet that is at x.
double way_to(const Case& c, std::size_t axis, const Load& load, double x) {
  const double to = x < load.lower[axis] ? load.lower[axis] - x : x > load.upper[axis] ? load.upper[axis] - x : 0.0;
  if (to == 0 || !c.substrate || c.substrate->poisson >= least_poisson_that_holds) return part_of_way * to;
  return to > 0 ? load.upper[axis] - x : load.lower[axis] - x;
}

/// A load that pulls the solid away from a droplet draws it to the load; one that pushes drives it away. The nearest ones count.
void take_ways(const Case& c, std::size_t axis, const Droplet& droplet, double half, Extent& span) {
  double least = std::numeric_limits<double>::infinity();
  for (const Load& load : c.loads) least = std::min(least, gap_to(droplet, load));
  const double x = droplet.centre[axis], reach = half + least_fine_margin * c.fluid->capillarity;
  for (const Load& load : c.loads) {
    if (gap_to(droplet, load) > 1.01 * least) continue;
    const double way = way_to(c, axis, load, x), pulls = load.force[axis] * way;
    if (pulls >= 0) span.take(x + way - reach, x + way + reach);
    if (pulls <= 0) span.take(x - way - reach, x - way + reach);
  }
}

/// Several droplets may become one, around their common centre.
std::vector<Droplet> with_their_union(const Case& c) {
  std::vector<Droplet> all = c.droplets;
  if (all.size() < 2) return all;
  Droplet one{std::vector<double>(c.domain.size.size(), 0.0)};
  double volume = 0;
  for (const Droplet& droplet : c.droplets) {
    const double part = std::pow(largest_radius(droplet), c.dimension());
    volume += part;
    for (std::size_t d = 0; d < one.centre.size(); ++d) one.centre[d] += part * droplet.centre[d];
  }
  for (double& x : one.centre) x /= volume;
  one.radius = std::pow(volume, 1.0 / c.dimension());
  all.push_back(one);
  return all;
}

Extent along_wall(const Case& c, std::size_t axis) {
  Extent span;
  const double beside = margin * c.fluid->capillarity;
  for (const Droplet& droplet : with_their_union(c)) {
    const double reach = half_width(c, droplet) + beside;
    span.take(droplet.centre[axis] - reach, droplet.centre[axis] + reach);
  }
  for (const Droplet& droplet : c.droplets) take_ways(c, axis, droplet, half_width(c, droplet), span);
  for (const Film& film : c.films) span.take(film.lower[axis] - beside, film.upper[axis] + beside);
  return span;
}

/// Surface tension over Young's modulus, without the integral of elastocapillary_length (scene/groups). sigma = 0.55 g
/// (1 - theta)^(3/2) is the law of a van der Waals fluid near its critical point, with the factor of theta = 0.39.
double rough_elastocapillary_length(const Case& c) {
  return 0.55 * c.fluid->capillarity * std::pow(1 - c.fluid->temperature, 1.5) / c.substrate->young_modulus();
}

Extent height_of(const Case& c, const Droplet& droplet) {
  const double radius = largest_radius(droplet), middle = droplet.centre.back();
  if (!sits_on_wall(c, droplet)) return {middle - radius, middle + radius};
  return {c.wall_height(), c.wall_height() + radius * (1 - cap_cosine(c, droplet))};
}

Extent upwards(const Case& c) {
  Extent span;
  const double beside = margin * c.fluid->capillarity, above = margin_above * c.fluid->capillarity;
  for (const Droplet& droplet : with_their_union(c)) {
    const Extent height = height_of(c, droplet);
    span.take(height.low - beside, height.high + (sits_on_wall(c, droplet) ? above : beside));
  }
  for (const Film& film : c.films) span.take(film.lower.back() - beside, film.upper.back() + beside);
  return span;
}

/// Of a periodic axis the fine part whose middle is closest to a position.
FinePart nearest_fine_part(const Case& c, std::size_t axis, double x) {
  FinePart fine = fine_part(c, static_cast<int>(axis));
  if (c.boundary.side[axis][0] != Side::periodic || std::isinf(fine.low)) return fine;
  const double length = c.domain.size[axis];
  const double turns = std::round((x - 0.5 * (fine.low + fine.high)) / length);
  return {fine.low + turns * length, fine.high + turns * length};
}

}  // namespace

void choose_fine_box(Case& c) {
  Grading& grading = c.domain.grading;
  if (grading.fine != FineElements::automatic) return;
  grading.fine = FineElements::box;
  const std::size_t axes = c.domain.size.size(), vertical = axes - 1;
  grading.lower.assign(axes, 0);
  grading.upper = c.domain.size;
  const bool anywhere = goes_anywhere(c);
  for (std::size_t axis = 0; axis < axes && !anywhere; ++axis) {
    if (c.boundary.side[axis][0] == Side::periodic || is_driven(c, axis)) continue;
    const Extent span = axis == vertical ? upwards(c) : along_wall(c, axis);
    grading.lower[axis] = std::max(0.0, span.low);
    grading.upper[axis] = std::min(c.domain.size[axis], span.high);
    const double h = fine_length(c, static_cast<int>(axis));
    if (axis == vertical && c.substrate)
      grading.lower[axis] =
          std::max(0.0, c.wall_height() - std::max(fine_rows_below * h, rough_elastocapillary_length(c)));
  }
}

namespace {

/// What the fine elements have to hold along an axis: where a droplet or film lies, and which of its ends are interfaces.
struct Body {
  std::string name;
  Extent span;
  bool below = true, above = true;
};

Body body_of(const Case& c, std::size_t droplet, std::size_t axis) {
  const Droplet& one = c.droplets[droplet];
  const double half = half_width(c, one), x = one.centre[axis];
  const bool upright = axis + 1 == c.domain.size.size();
  return {fmt::format("droplet[{}]", droplet), upright ? height_of(c, one) : Extent{x - half, x + half},
          !(upright && sits_on_wall(c, one))};
}

Body body_of_film(const Case& c, std::size_t film, std::size_t axis) {
  const double low = c.films[film].lower[axis], high = c.films[film].upper[axis];
  const double ground = axis + 1 == c.domain.size.size() ? c.wall_height() : 0, slack = 1e-9 * c.domain.size[axis];
  const bool whole = high - low >= c.domain.size[axis] - slack;  // along a periodic axis it has no ends then
  const bool ends = c.boundary.side[axis][0] == Side::periodic;
  return {fmt::format("film[{}]", film),
          {low, high},
          !whole && (ends || low > ground + slack),
          !whole && (ends || high < c.domain.size[axis] - slack)};
}

std::string warning_about(const Case& c, const Body& body, std::size_t axis) {
  const bool upright = axis + 1 == c.domain.size.size(), periodic = c.boundary.side[axis][0] == Side::periodic;
  const double capillarities = upright && !body.below ? least_fine_margin_above : least_fine_margin;
  const double margin = capillarities * c.fluid->capillarity;
  const FinePart fine = nearest_fine_part(c, axis, 0.5 * (body.span.low + body.span.high));
  const bool below = body.below && body.span.low - margin < fine.low;
  if (!below && !(body.above && body.span.high + margin > fine.high)) return {};
  double low = std::min(body.span.low - (body.below ? margin : 0), fine.low),
         high = std::max(body.span.high + (body.above ? margin : 0), fine.high);
  if (!periodic) low = std::max(low, 0.0), high = std::min(high, c.domain.size[axis]);
  if (high - low > c.domain.size[axis]) low = 0, high = c.domain.size[axis];
  return fmt::format(
      "{} lies in [{:.4g}, {:.4g}] along axis {}, and the fine elements of domain.grading end at {:.4g}: less than {} "
      "capillarities away. Longer elements within the interface drive it, by up to one or two of the short ones "
      "(docs/limits.md); write a larger box, [{:.4g}, {:.4g}] along this axis{}",
      body.name, body.span.low, body.span.high, axis, below ? fine.low : fine.high, capillarities, low, high,
      periodic && (low < 0 || high > c.domain.size[axis]) ? ", which may reach around the ends of a periodic one" : "");
}

}  // namespace

std::string warning_about_fine_box(const Case& c) {
  if (!c.fluid) return {};
  const std::size_t axes = c.domain.size.size();
  const auto first_of = [&](std::size_t count, const auto& body) {
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t axis = 0; axis < axes; ++axis)
        if (std::string what = warning_about(c, body(c, k, axis), axis); !what.empty()) return what;
    return std::string();
  };
  const std::string of_droplets = first_of(c.droplets.size(), body_of);
  return of_droplets.empty() ? first_of(c.films.size(), body_of_film) : of_droplets;
}

}  // namespace softwet
