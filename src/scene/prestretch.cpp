#include "scene/prestretch.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "case/error.hpp"
#include "case/text.hpp"
#include "kernels/algebra/dual.hpp"
#include "kernels/solid/neo_hookean.hpp"
#include "kernels/solid/saint_venant_kirchhoff.hpp"

namespace softwet {
namespace {

Matrix<double, 3> stretched(const Vector<double, 3>& stretch) {
  Matrix<double, 3> g{};
  for (int d = 0; d < 3; ++d) g(d, d) = stretch[d] - 1;
  return g;
}

/// Calls visit(law) with the material of a case.
template <class Visit>
auto with_law(const Case& c, const LameParameters& stiffness, const Visit& visit) {
  return c.substrate->material == MaterialModel::neo_hookean ? visit(NeoHookean{stiffness})
                                                             : visit(SaintVenantKirchhoff{stiffness});
}

/// The stretch along an axis that leaves no stress along it: Newton's method for l_v P_vv = 0 in ln l_v. For both laws
/// this function is convex above its largest root. |ln(l_1 l_2)| is above the root for any Poisson ratio, so that
/// values from there fall to the root. 0 where there is none.
template <class Law>
double free_stretch(const Law& law, const Vector<double, 3>& stretch, int axis) {
  constexpr int most = 200;
  double x = std::abs(std::log(stretch[(axis + 1) % 3] * stretch[(axis + 2) % 3]));
  for (int k = 0; k < most; ++k) {
    const double length = std::exp(x);
    Matrix<Dual<double>, 3> g;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) g(i, j) = {i == j ? stretch[i] - 1 : 0.0, 0.0};
    g(axis, axis) = {length - 1, length};
    const Dual<double> force = Dual<double>{length, length} * law.first_piola(g)(axis, axis);
    if (!(force.tangent > 0)) return 0;
    const double next = x - force.value / force.tangent;
    if (!(next < x)) return length;
    x = next;
  }
  return 0;
}

/// Whether a profile differs between positions of one height.
bool varies_along_wall(const Case& c, const Profile& profile) {
  constexpr int places = 8;
  const int up = c.dimension() - 1;
  for (int k = 0; profile.varies() && k <= places; ++k) {
    std::array<double, 3> x{};
    x[up] = c.substrate->thickness * k / places;
    const double first = profile.at(x);
    for (int axis = 0; axis < up; ++axis)
      for (int i = 1; i <= places; ++i) {
        std::array<double, 3> other = x;
        other[axis] = c.domain.size[axis] * i / places;
        if (std::abs(profile.at(other) - first) > 1e-6 * profile.most()) return true;
      }
  }
  return false;
}

}  // namespace

Prestretch prestretch_of(const Case& c, const LameParameters& stiffness) {
  Prestretch r;
  const std::vector<double>& along = c.substrate->prestretch;
  if (along.empty()) return r;
  const int up = c.dimension() - 1;
  r.acts = true;
  for (int d = 0; d < up; ++d) r.stretch[d] = along[d];
  if (c.axisymmetric()) r.stretch[2] = along[0];
  r.stretch[up] = with_law(c, stiffness, [&](const auto& law) { return free_stretch(law, r.stretch, up); });
  if (r.stretch[up] == 0)
    throw Error(Exit::invalid_input,
                "substrate.prestretch = " + short_text(along.front()) +
                    " with substrate.poisson = " + short_text(c.substrate->poisson) +
                    ": no stretch upright frees the top of stress; write a prestretch closer to 1");
  r.energy_at_rest = with_law(c, stiffness, [&](const auto& law) { return law.energy(stretched(r.stretch)); });
  return r;
}

Matrix<double, 3> stress_at_rest(const Case& c, const LameParameters& stiffness) {
  const Prestretch p = prestretch_of(c, stiffness);
  return with_law(c, stiffness, [&](const auto& law) { return p.first_piola(law.first_piola(stretched(p.stretch))); });
}

double compression_of_face(const Case& c, const Prestretch& p) {
  const int up = c.dimension() - 1;
  double least = p.stretch[0];
  for (int d = 1; d < up; ++d) least = std::min(least, p.stretch[d]);
  return least / p.stretch[up];
}

double stiffness_of_face(const Case& c, const Prestretch& p) {
  const double s = compression_of_face(c, p), up = p.stretch[c.dimension() - 1];
  return up * up / p.volume_ratio() * (s * s * s + s * s + 3 * s - 1) / (2 * (s + 1));
}

std::vector<std::string> forecast_of_prestretch(const Case& c) {
  std::vector<std::string> found;
  const Substrate& s = *c.substrate;
  if (s.prestretch.empty()) return found;
  const LameParameters stiffest = stiffest_of(s);
  const Prestretch here = prestretch_of(c, stiffest);
  const std::string key = "substrate.prestretch = " + short_text(s.prestretch.front(), 6);
  if (s.material == MaterialModel::saint_venant_kirchhoff) {
    Case other = c;
    other.substrate->material = MaterialModel::neo_hookean;
    const int up = c.dimension() - 1;
    found.push_back(key + ": a Saint Venant-Kirchhoff solid is " + short_text(here.stretch[up], 4) +
                    " of its height then, a neo-Hookean one, as gels and rubbers are, " +
                    short_text(prestretch_of(other, stiffest).stretch[up], 4) +
                    "; write substrate.material = \"neo_hookean\"");
  }
  const double compression = compression_of_face(c, here);
  if (compression < least_without_creases)
    found.push_back(
        key + ": along the wall the layer is stretched " + short_text(compression) +
        " times as much as upright; below " + short_text(least_without_creases) +
        " its face folds into creases, and below " + short_text(least_of_biot) +
        " waves of every length grow on it, so that the result depends on the mesh; write a prestretch closer to 1");
  if (varies_along_wall(c, s.young))
    found.push_back(key +
                    ": where substrate.young varies along the wall the stretched layer is not at rest where its "
                    "displacement is 0; write time.start = \"equilibrium\" to begin at rest");
  return found;
}

}  // namespace softwet
