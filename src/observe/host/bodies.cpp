#include "observe/host/bodies.hpp"

#include <algorithm>

namespace softwet {
namespace {

bool has_bubbles(const Case& c) { return c.fluid && c.fluid->ambient == Phase::liquid; }
std::size_t films_of(const Case& c) { return has_bubbles(c) ? 0 : c.films.size(); }

void add_names(const std::string& kind, std::size_t count, std::vector<std::string>& names) {
  if (count == 1) names.push_back("the " + kind);
  for (std::size_t k = 1; count > 1 && k <= count; ++k) names.push_back(kind + " " + std::to_string(k));
}

}  // namespace

std::vector<Body> bodies_of(const Case& c) {
  std::vector<Body> bodies(c.droplets.size() + films_of(c));
  for (std::size_t k = 0; k < c.droplets.size(); ++k)
    std::copy(c.droplets[k].centre.begin(), c.droplets[k].centre.end(), bodies[k].place.begin());
  for (std::size_t k = 0; k < films_of(c); ++k)
    for (std::size_t d = 0; d < c.domain.size.size(); ++d)
      bodies[c.droplets.size() + k].place[d] =
          std::clamp(0.5 * (c.films[k].lower[d] + c.films[k].upper[d]), 0.0, c.domain.size[d]);
  return bodies;
}

std::vector<std::string> body_names(const Case& c) {
  std::vector<std::string> names;
  add_names(has_bubbles(c) ? "bubble" : "droplet", c.droplets.size(), names);
  add_names("film", films_of(c), names);
  return names;
}

}  // namespace softwet
