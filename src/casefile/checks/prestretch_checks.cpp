// What can be combined with a solid that is stretched before the scene begins.
#include <fmt/core.h>

#include <cmath>

#include "casefile/checks/checker.hpp"

namespace softwet {
namespace {

const std::string prestretch_key = "substrate.prestretch";

bool multiple_of(double angle, double right) { return std::abs(std::remainder(angle, right)) < 1e-9; }

void check_stretches(const Checker& check) {
  const std::size_t count = check.c.substrate->prestretch.size(), wanted = check.c.dimension() == 3 ? 2 : 1;
  if (count == wanted) return;
  check.refuse(
      prestretch_key, fmt::format("must be {}, not {}", wanted == 2 ? "2 numbers, along x and y" : "1 number", count),
      wanted == 2 ? "write [l_1, l_2]; the stretch upright follows"
                  : fmt::format("write [l_1]{}", check.c.axisymmetric()
                                                     ? ": along r and around the axis the stretch is the same"
                                                     : "; the strain stays plane, and the stretch upright follows"));
}

/// In a Saint Venant-Kirchhoff solid a stretch acts on the next one far more or less than in a gel.
void check_prestretched_law(const Checker& check) {
  const Substrate& s = *check.c.substrate;
  if (s.strain == Strain::small)
    check.refuse(prestretch_key,
                 "needs strain = \"finite\": in small strains a stretch changes neither the stiffness nor the stress "
                 "that a rotation carries along, so the layer would not feel it",
                 "write strain = \"finite\" and material = \"neo_hookean\", or remove the prestretch");
  constexpr double most = 0.15;
  if (s.material != MaterialModel::saint_venant_kirchhoff) return;
  for (const double stretch : s.prestretch)
    if (std::abs(stretch - 1) > most + slack)
      check.refuse(prestretch_key,
                   fmt::format("has {:.4g}: a Saint Venant-Kirchhoff solid is no model of a gel beyond 0.85 and 1.15. "
                               "Stretched by 1.3 at poisson = 0.45 it thins to 0.66 where a neo-Hookean solid thins to "
                               "0.80, and the ridge of a droplet on it is 18 % higher",
                               stretch),
                   "write material = \"neo_hookean\"");
}

/// Stresses of fibres in the stretched layer have to be borne by the sides alone.
void check_prestretched_fibres(const Checker& check) {
  const Case& c = check.c;
  const Fibre& fibre = c.substrate->fibre;
  if (fibre.stiffness == 0) return;
  if (c.axisymmetric())
    check.refuse(prestretch_key, "excludes fibres in (r, z): stretched along r alone, they pull the layer to the axis",
                 "remove substrate.fibre or the prestretch");
  if (!multiple_of(fibre.angle, 180))
    check.refuse(
        prestretch_key,
        "needs fibres in the plane of the wall: inclined ones pull at the free top, and nothing holds them there",
        "write fibre.angle = 0");
  if (c.dimension() == 2 || multiple_of(fibre.azimuth, 90)) return;
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (std::size_t end = 0; end < 2; ++end)
      if (c.boundary.side[axis][end] == Side::slip)
        check.refuse(prestretch_key,
                     fmt::format("needs sides that hold oblique fibres, and {} slips", side_name(axis, end, 2)),
                     "write fibre.azimuth = 0 or 90, or sides that are periodic or clamped");
}

void check_prestretched_sides(const Checker& check) {
  for (std::size_t axis = 0; axis < check.vertical(); ++axis)
    for (std::size_t end = 0; end < 2; ++end)
      if (check.c.boundary.side[axis][end] == Side::free)
        check.refuse(
            prestretch_key,
            fmt::format("needs sides that hold the stretch, and {} is free", side_name(axis, end, check.vertical())),
            "write \"slip\", \"clamped\" or \"periodic\" there");
}

}  // namespace

void check_prestretch(const Checker& check) {
  if (!check.c.substrate || check.c.substrate->prestretch.empty()) return;
  check.with({prestretch_key}, [&] { check_stretches(check); });
  check.with({prestretch_key, "substrate.strain", "substrate.material"}, [&] { check_prestretched_law(check); });
  check.with({prestretch_key, "substrate.fibre", "boundary"}, [&] { check_prestretched_fibres(check); });
  check.with({prestretch_key, "boundary"}, [&] { check_prestretched_sides(check); });
}

}  // namespace softwet
