// What the bound of explicit steps sees at a control point of the solid.
#pragma once

#include <cmath>

#include "time/explicit/step_points.hpp"

namespace softwet::step_points {

/// Where a control point of the solid lies: on its top face, on its bottom, or between them.
enum class SolidPlace { inside, face, bottom };

/// The solid with what its rates have in common at all points.
/// @tparam Axial  in the coordinates (r, z)
template <int D, class Material, bool Axial = false>
struct SolidBound {
  template <class N>
  using Tensor = std::conditional_t<Axial, AxialMatrix<N>, Matrix<N, D>>;

  Material material;
  Fibres fibres;
  StepFormula formula;
  Prestretch prestretch = {};
  double joined[D][D] = {};  ///< part of dP/dF between two axes that counts
  double wave = 0;           ///< frequency of elastic waves = wave sqrt(stiffness)
  double surface = 0;        ///< square of the frequency of capillary waves on the undeformed top face
  double along_face = 0;     ///< square of the frequency of waves along the top face, by its modulus
  double springs = 0;        ///< square of the frequency of the bottom on its springs
  double held = 0;           ///< square of the frequency of the springs of needles
  double viscous = 0;        ///< rate of viscosity in the undeformed state
  double branches = 0;       ///< stiffness of branches, at least the largest row of its part in any solid
  double dashpots = 0;       ///< rate of the dashpots of the bottom

  /// @param symbols    of ends
  /// @param many       axes whose symbols add up
  /// @param length     of the shortest side of an element
  /// @param free_axis  of a solid alone that has a free end along the axis
  SolidBound(const Elastodynamics<Material>& solid, const Fibres& along, StepFormula f, const SolidRates& more,
             const MassSymbols& symbols, double many, double length, const bool (&free_axis)[D])
      : material(solid.material), fibres(along), formula(f) {
    constexpr double margin = 1.05;  // waves along free and held sides are a little faster
    const double symbol = margin * symbols.elastic / length;
    const double modulus = many * symbol * symbol / solid.density;  // square of a frequency over the modulus
    wave = std::sqrt(modulus);
    const auto of_face = [&](double stiffness) {
      return (D - 1) * margin * symbols.surface * symbols.surface * stiffness / (solid.density * std::pow(length, 3));
    };
    surface = of_face(more.tension);
    along_face = of_face(more.modulus);
    const double of_bottom = margin * symbols.springs * symbols.springs / (solid.density * length);
    springs = of_bottom * more.springs;
    dashpots = of_bottom * more.dashpots;
    held = std::pow(symbols.held, many) * more.held / solid.density;
    viscous = modulus * more.viscosity;
    branches = more.branches;
    for (int d = 0; d < D; ++d)
      for (int e = 0; e < D; ++e) joined[d][e] = d == e ? 1 : free_axis[d] && free_axis[e] ? 0.5 : 0;
  }

  /// Rates where the displacement has a gradient.
  KOKKOS_FUNCTION void rates(const Tensor<double>& gradient, SolidPlace place, double* rate) const {
    const bool on_face = place == SolidPlace::face, below = place == SolidPlace::bottom;
    const double elastic =
        wave * wave * (stiffness(gradient) + stiffness_of_fibres(gradient) + stiffness_of_branches(gradient));
    const double tension = surface > 0 && on_face ? surface * shortening(gradient) : 0;
    const double face = along_face > 0 && on_face ? stiffened(tension, gradient) : tension;
    rate[elasticity] = Kokkos::sqrt(elastic + face + (below ? springs : 0) + held);
    rate[viscosity] = viscous * lengthened(gradient) + (below ? dashpots : 0);
    rate[combined] = combine(formula, rate[elasticity], rate[viscosity], 0.0, 0.0);
  }

 private:
  /// The gradient as dual numbers, with the tangent 0.
  KOKKOS_FUNCTION static Tensor<Dual<double>> dual(const Tensor<double>& gradient) {
    Tensor<Dual<double>> a;
    for (int c = 0; c < D; ++c)
      for (int d = 0; d < D; ++d) a(c, d) = Dual<double>(gradient(c, d), 0.0);
    if constexpr (Axial) a.hoop = Dual<double>(gradient.hoop, 0.0);
    return a;
  }
  KOKKOS_FORCEINLINE_FUNCTION Tensor<Dual<double>> first_piola(const Tensor<Dual<double>>& gradient) const {
    if (!prestretch.acts) return material.first_piola(gradient);
    return prestretch.first_piola(material.first_piola(prestretch.whole(gradient)));
  }
  /// Largest row of dP/dF.
  KOKKOS_FUNCTION double stiffness(const Tensor<double>& gradient) const {
    double row[D][D] = {};  // [component of the force][axis of the wave]
    for (int along = 0; along < D; ++along)
      for (int axis = 0; axis < D; ++axis) {
        Tensor<Dual<double>> moved = dual(gradient);
        moved(along, axis).tangent = 1;
        const Tensor<Dual<double>> stress = first_piola(moved);
        for (int c = 0; c < D; ++c)
          for (int d = 0; d < D; ++d) row[c][d] += joined[d][axis] * Kokkos::abs(stress(c, d).tangent);
      }
    double largest = 0;
    if constexpr (Axial) {
      Tensor<Dual<double>> moved = dual(gradient);
      moved.hoop.tangent = 1;
      largest = Kokkos::abs(first_piola(moved).hoop.tangent);
    }
    for (int c = 0; c < D; ++c)
      for (int d = 0; d < D; ++d) largest = Kokkos::max(largest, row[c][d]);
    return largest;
  }
  /// The square of |F|^2, at least 1, which it is where nothing is deformed: how a stretch makes F C F^T stiffer.
  KOKKOS_FUNCTION static double lengthened(const Tensor<double>& gradient) {
    const auto deformed = add_diagonal(gradient, 1.0);
    const double length = Kokkos::max(1.0, contract(deformed, deformed) / (Axial ? 3 : D));
    return length * length;
  }
  /// Stiffness of branches, which under finite strains grow stiffer in a stretch.
  KOKKOS_FUNCTION double stiffness_of_branches(const Tensor<double>& gradient) const {
    if constexpr (std::is_same_v<Material, Hooke>) return branches;
    return branches > 0 ? branches * lengthened(gradient) : 0;
  }
  /// Largest eigenvalue of dP/dF of the fibres; its eigenvector is F a_0 (x) a_0.
  KOKKOS_FUNCTION double stiffness_of_fibres(const Tensor<double>& gradient) const {
    if (fibres.stiffness == 0) return 0;
    const auto deformed = add_diagonal(gradient, 1.0);
    double along[D], square = 0;
    for (int c = 0; c < D; ++c) {
      along[c] = 0;
      for (int d = 0; d < D; ++d) along[c] += deformed(c, d) * fibres.direction[d];
      square += along[c] * along[c];
    }
    if (!(square > 0)) return 0;
    Tensor<Dual<double>> moved = dual(gradient);
    for (int c = 0; c < D; ++c)
      for (int d = 0; d < D; ++d) moved(c, d).tangent = along[c] * fibres.direction[d];
    const auto stress = fibres.residual(SolidStrain<Dual<double>, D, Tensor<Dual<double>>>{moved}).momentum_flux;
    double sum = 0;
    for (int c = 0; c < D; ++c)
      for (int d = 0; d < D; ++d) sum += along[c] * fibres.direction[d] * stress(c, d).tangent;
    return Kokkos::max(sum / square, 0.0);
  }
  /// A face that is shortened carries shorter waves: 1 / its smallest stretch, at most 10, in 3D and in (r, z) times
  /// the larger one.
  KOKKOS_FUNCTION double shortening(const Tensor<double>& gradient) const {
    double least = 1, most = 1;
    for (int d = 0; d + 1 < D; ++d) {
      double square = 0;
      for (int c = 0; c < D; ++c) square += Kokkos::pow(gradient(c, d) + (c == d ? 1.0 : 0.0), 2);
      least = Kokkos::min(least, Kokkos::sqrt(square));
      most = Kokkos::max(most, Kokkos::sqrt(square));
    }
    if constexpr (Axial) {
      least = Kokkos::min(least, Kokkos::abs(1 + gradient.hoop));
      most = Kokkos::max(most, Kokkos::abs(1 + gradient.hoop));
    }
    return (D == 2 && !Axial ? 1 : most) / Kokkos::max(least, 0.1);
  }
  /// The face with its modulus too. Tension meets motion across the face and the modulus, times the square of the
  /// largest stretch, motion along it: the larger counts. Strains that pull the face tight are a tension of their own.
  KOKKOS_FUNCTION double stiffened(double tension, const Tensor<double>& gradient) const {
    double most = 1, tight = 0;
    for (int d = 0; d + 1 < D; ++d) {
      double row = 0;
      for (int e = 0; e + 1 < D; ++e) {
        double product = 0;
        for (int c = 0; c < D; ++c)
          product += (gradient(c, d) + (c == d ? 1.0 : 0.0)) * (gradient(c, e) + (c == e ? 1.0 : 0.0));
        row += Kokkos::abs(product);
      }
      most = Kokkos::max(most, row);
      tight += Kokkos::max(0.0, 0.5 * (row - 1));
    }
    if constexpr (Axial) {
      const double square = (1 + gradient.hoop) * (1 + gradient.hoop);
      most = Kokkos::max(most, square);
      tight += Kokkos::max(0.0, 0.5 * (square - 1));
    }
    return Kokkos::max(tension, along_face * most) + along_face * tight;
  }
};

template <int D, class Bound>
struct SolidPoint {
  Bound bound;
  const double* displacement;
  ConstArray greville[D];
  int extent[D];
  int nodes;
  int row_size;

  KOKKOS_FUNCTION void operator()(int i, double* rate) const {
    typename Bound::template Tensor<double> gradient;
    int stride = 1;
    for (int d = 0; d < D; ++d) {
      for (int c = 0; c < D; ++c)
        gradient(c, d) =
            difference(displacement + c * nodes, i, i / stride % extent[d], extent[d], stride, greville[d]);
      stride *= extent[d];
    }
    if constexpr (is_axial_matrix<decltype(gradient)>) {
      const double r = greville[0](i % extent[0]);
      gradient.hoop = r > 0 ? displacement[i] / r : gradient(0, 0);
    }
    const SolidPlace place = i >= nodes - row_size ? SolidPlace::face
                             : i < row_size        ? SolidPlace::bottom
                                                   : SolidPlace::inside;
    bound.rates(gradient, place, rate);
  }
};

}  // namespace softwet::step_points
