// What a case file says by a word: an enumeration for each key, and behind it its words in the order of the
// enumerators.
#pragma once

#include <string>
#include <type_traits>
#include <vector>

namespace softwet {

enum class Side { slip, no_slip, clamped, free, periodic };
inline std::vector<std::string> words_of(Side) { return {"slip", "no_slip", "clamped", "free", "periodic"}; }

/// Whether a side across an axis prescribes a component of velocity and displacement.
inline bool holds(Side side, int component, int axis) {
  return side == Side::no_slip || side == Side::clamped || (side == Side::slip && component == axis);
}

/// Test functions of the wall in the capillary force: next to the wall only, or blended over the fluid like the mesh.
enum class Traction { layer, blended };
inline std::vector<std::string> words_of(Traction) { return {"layer", "blended"}; }

enum class Phase { vapour, liquid };
inline std::vector<std::string> words_of(Phase) { return {"vapour", "liquid"}; }

/// g^2 |grad rho| cos(alpha) of the paper, or the variational wall energy.
enum class WallLaw { gradient, energy };
inline std::vector<std::string> words_of(WallLaw) { return {"gradient", "energy"}; }

/// Whether the wall energy is a tension of the wall too, as its derivative by the wall's place says.
enum class WallTensionModel { none, acts };
inline std::vector<std::string> words_of(WallTensionModel) { return {"none", "acts"}; }

enum class MaterialModel { saint_venant_kirchhoff, neo_hookean };
inline std::vector<std::string> words_of(MaterialModel) { return {"saint_venant_kirchhoff", "neo_hookean"}; }

/// The strain in the material's law. Small: Hooke's law, in place of the material.
enum class Strain { finite, small };
inline std::vector<std::string> words_of(Strain) { return {"finite", "small"}; }

/// Of the solid. None: it is in equilibrium at every time.
enum class Inertia { full, none };
inline std::vector<std::string> words_of(Inertia) { return {"full", "none"}; }

/// How the stiffness of the solid against changes of volume is integrated: at all points, or in parts (SelectiveParts).
enum class VolumeQuadrature { full, selective };
inline std::vector<std::string> words_of(VolumeQuadrature) { return {"full", "selective"}; }

/// Points of an element along an axis: one more than the degree, or as many as the degree.
enum class Quadrature { full, reduced };
inline std::vector<std::string> words_of(Quadrature) { return {"full", "reduced"}; }

/// Where elements have the length size / elements. Automatic becomes a box when a case is read.
enum class FineElements { everywhere, automatic, box };
inline std::vector<std::string> words_of(FineElements) { return {"everywhere", "automatic", "box"}; }

/// What the two axes of a 2D scene are: x and y of a state that is the same at any depth, or the distance r from an
/// axis of symmetry, which is the left side, and the height.
enum class Coordinates { plane, axisymmetric };
inline std::vector<std::string> words_of(Coordinates) { return {"plane", "axisymmetric"}; }

/// The field that a wave is added to.
enum class WaveField { density, velocity_x, velocity_y, velocity_z, displacement_x, displacement_y, displacement_z };
inline std::vector<std::string> words_of(WaveField) {
  return {"density", "velocity_x", "velocity_y", "velocity_z", "displacement_x", "displacement_y", "displacement_z"};
}
inline bool is_displacement(WaveField field) { return field >= WaveField::displacement_x; }
inline bool is_velocity(WaveField field) { return field != WaveField::density && !is_displacement(field); }
/// The direction of the component of a vector, 0 along x; -1 for the density.
inline int axis_of(WaveField field) {
  if (field == WaveField::density) return -1;
  return static_cast<int>(field) -
         static_cast<int>(is_velocity(field) ? WaveField::velocity_x : WaveField::displacement_x);
}

/// Automatic becomes generalized_alpha or kick_drift when a case is read (TimeControl::automatic).
enum class TimeScheme { generalized_alpha, kick_drift, rkl2, ssp_rk3, automatic };
inline std::vector<std::string> words_of(TimeScheme) {
  return {"generalized_alpha", "kick_drift", "rkl2", "ssp_rk3", "automatic"};
}

/// How explicit schemes invert the masses of velocity, density and chemical potential. Consistent: as they are, by
/// conjugate gradients. Lumped: replaced by their row sums, of second order in space. Corrected: row sums followed by
/// three products with the mass, of sixth order for smooth fields (MassInverse).
enum class MassKind { corrected, lumped, consistent };
inline std::vector<std::string> words_of(MassKind) { return {"corrected", "lumped", "consistent"}; }

/// Equilibrium: the scene is brought to rest before the first step.
enum class StartState { initial, equilibrium };
inline std::vector<std::string> words_of(StartState) { return {"initial", "equilibrium"}; }

/// Products of the Jacobian in Newton's method.
enum class JacobianKind { exact, difference };
inline std::vector<std::string> words_of(JacobianKind) { return {"exact", "difference"}; }

enum class PreconditionerKind { automatic, lu, schwarz, none };
inline std::vector<std::string> words_of(PreconditionerKind) { return {"automatic", "lu", "schwarz", "none"}; }

/// How a device starts the preconditioner.
enum class Launch { kernels, graph };
inline std::vector<std::string> words_of(Launch) { return {"kernels", "graph"}; }

/// What a case asks for; what is computed is a Precision (case/precision.hpp).
enum class PrecisionChoice { automatic, full, mixed };
inline std::vector<std::string> words_of(PrecisionChoice) { return {"automatic", "double", "mixed"}; }

/// A named set of defaults (casefile/schema/quality.hpp).
enum class Quality { draft, standard, reference };
inline std::vector<std::string> words_of(Quality) { return {"draft", "standard", "reference"}; }

/// What a probe makes of its values.
enum class ProbeOperation { value, mean, integral, max, min };
inline std::vector<std::string> words_of(ProbeOperation) { return {"value", "mean", "integral", "max", "min"}; }

template <class Choice>
  requires std::is_enum_v<Choice> std::string word_of(Choice choice) {
    return words_of(choice)[static_cast<std::size_t>(choice)];
  }

}  // namespace softwet
