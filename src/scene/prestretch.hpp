// The state of a solid that is stretched before the scene begins, from the numbers of a case (host).
#pragma once

#include <string>
#include <vector>

#include "case/case.hpp"
#include "kernels/solid/isotropic.hpp"
#include "kernels/solid/prestretch.hpp"

namespace softwet {

/// Where the solid is stiffest.
inline LameParameters stiffest_of(const Substrate& s) {
  return LameParameters::from(s.density * s.young.most(), s.poisson);
}

/// F_0 of `substrate.prestretch`: along the wall as the case says, upright such that the stress upright is 0, so that u
/// = 0 is at rest below a free face. In 2D the third stretch is 1, in (r, z) it is that along r. `acts` is false where
/// the case has no prestretch.
/// @param stiffness  at the position where the solid is stiffest
/// Tested: tests/unit/scene/test_prestretch.cpp
Prestretch prestretch_of(const Case&, const LameParameters& stiffness);

/// Stress of the stretched layer where u = 0, scale a b^2.
Matrix<double, 3> stress_at_rest(const Case&, const LameParameters& stiffness);

/// Smallest ratio s of a stretch along the wall over the one upright, among the directions in which waves may run on
/// the face. Below least_without_creases an incompressible neo-Hookean face folds into creases, whatever the stretch in
/// the third direction is (Hong, Zhao and Suo, Appl. Phys. Lett. 95, 111901, 2009: upright over lateral stretch 2.4).
/// At the root 0.2956 of s^3 + s^2 + 3 s - 1 waves of every length grow (Biot 1963).
double compression_of_face(const Case&, const Prestretch&);
inline constexpr double least_without_creases = 1 / 2.4, least_of_biot = 0.2956;

/// Stiffness of the face of a stretched half space against loads across it, over the stiffness of an unstretched one:
///   (l_v^2 / J_0) (s^3 + s^2 + 3 s - 1) / (2 (s + 1))
/// of the incompressible neo-Hookean solid (Biot, Mechanics of Incremental Deformations, 1965) with the l_v of the
/// solid. 1 without a prestretch.
double stiffness_of_face(const Case&, const Prestretch&);

/// Sentences for the user about a prestretch, each with value, bound and remedy: a law that is no model of it, a face
/// that folds, a stretched layer that is not at rest. Empty without a prestretch.
std::vector<std::string> forecast_of_prestretch(const Case&);

}  // namespace softwet
