#include "observe/acting_stress.hpp"

#include "kernels/algebra/symmetric.hpp"
#include "kernels/solid/branches.hpp"

namespace softwet {
namespace {

using Tensor = Matrix<double, 3>;

/// Adds the viscous stress.
template <int D>
void add_viscosity(const SolidPoints<D>& at, const std::vector<Tensor>& gradients, const Substrate& s,
                   std::vector<Tensor>& stress) {
  const KelvinVoigt term = viscosity_of(s);
  if (term.rate() == 0) return;
  const std::vector<Tensor> rates = velocity_gradients(at);
  for (std::size_t i = 0; i < stress.size(); ++i)
    stress[i] = stress[i] + term.residual(SolidStrainRate<double, 3>{gradients[i], rates[i]}).momentum_flux;
}

/// Adds the stress of branches under small strains: of q = sum 2 G_i (u - a_i).
template <int D>
void add_small_branches(const SolidPoints<D>& at, const std::vector<Tensor>& gradients, const Branches& branches,
                        std::vector<Tensor>& stress) {
  std::vector<Tensor> lag(stress.size(), Tensor{});
  for (int b = 0; b < branches.count; ++b) {
    const std::vector<Tensor> remembered = branch_gradients(at, b);
    for (std::size_t i = 0; i < lag.size(); ++i)
      lag[i] = lag[i] + (2 * branches.modulus[b]) * (gradients[i] + (-1.0) * remembered[i]);
  }
  for (std::size_t i = 0; i < stress.size(); ++i)
    stress[i] = stress[i] + BranchStress{}.residual(LagStrain<double, 3>{lag[i]}).momentum_flux;
}

/// Adds the stress of branches under finite strains: of h = sum 2 G_i A_i / sum 2 G_i, which the Gauss points remember.
template <int D>
void add_finite_branches(const SolidPoints<D>& at, const std::vector<Tensor>& gradients, const Branches& branches,
                         int points, std::vector<Tensor>& stress) {
  const double whole = branches.weight(0);
  std::vector<Tensor> remembered(stress.size(), Tensor{});
  for (int b = 0; b < branches.count; ++b) {
    const std::vector<Tensor> strains = remembered_strains(at, b, points);
    for (std::size_t i = 0; i < strains.size(); ++i)
      remembered[i] = remembered[i] + (2 * branches.modulus[b] / whole) * strains[i];
  }
  for (std::size_t i = 0; i < stress.size(); ++i) {
    const RememberedStrain<double, 3> strain{gradients[i], entries_of(remembered[i]), true};
    stress[i] = stress[i] + whole * FiniteBranchStress{}.residual(strain).momentum_flux;
  }
}

}  // namespace

template <int D>
std::vector<Tensor> acting_stress(const SolidPoints<D>& at, const std::vector<Tensor>& gradients, const Case& c,
                                  const SolidCoefficients& solid) {
  const Substrate& s = *c.substrate;
  std::vector<Tensor> stress;
  for (std::size_t i = 0; i < gradients.size(); ++i) stress.push_back(solid.first_piola(gradients[i], at.place(i)));
  if (s.volume_quadrature == VolumeQuadrature::selective) take_means(at, gradients, solid, stress);
  add_viscosity(at, gradients, s, stress);
  if (solid.branches.count == 0) return stress;
  if (s.strain == Strain::small)
    add_small_branches(at, gradients, solid.branches, stress);
  else
    add_finite_branches(at, gradients, solid.branches, c.domain.points(), stress);
  return stress;
}

template std::vector<Tensor> acting_stress(const SolidPoints<2>&, const std::vector<Tensor>&, const Case&,
                                           const SolidCoefficients&);
template std::vector<Tensor> acting_stress(const SolidPoints<3>&, const std::vector<Tensor>&, const Case&,
                                           const SolidCoefficients&);

}  // namespace softwet
