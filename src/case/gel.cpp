#include "case/gel.hpp"

#include <complex>

namespace softwet {
namespace {

constexpr double beyond = 1;       ///< decades on either side of the range
constexpr double of_decade = 1.5;  ///< branches

/// sin(n pi)/pi
double share(const PowerLaw& law) { return std::sin(law.exponent * M_PI) / M_PI; }

}  // namespace

GelFit GelFit::of(double modulus, const PowerLaw& law) {
  GelFit fit;
  if (!law.acts()) return fit;
  const double low = law.decades[0] - beyond, width = law.decades[1] - law.decades[0] + 2 * beyond;
  const int count = std::min(most_branches, static_cast<int>(std::round(of_decade * width)) + 1);
  const double part = std::log(10) * width / (count - 1);
  for (int j = 0; j < count; ++j) {
    const double s = std::pow(10, low) * std::exp(j * part);  // times the time of the law
    fit.branches.push_back({modulus * share(law) * std::pow(s, law.exponent) * part, law.time / s});
  }
  const double last = std::pow(10, low + width) * std::exp(part / 2);
  fit.viscosity = modulus * law.time * share(law) * std::pow(last, law.exponent - 1) / (1 - law.exponent);
  return fit;
}

double GelFit::error(double modulus, const PowerLaw& law) const {
  constexpr int looks = 400;
  using Complex = std::complex<double>;
  double largest = 0;
  for (int k = 0; k <= looks; ++k) {
    const double decade = law.decades[0] + (law.decades[1] - law.decades[0]) * k / looks;
    const Complex turn{0, std::pow(10, decade) / law.time};  // i w
    Complex sum = modulus + turn * viscosity;
    for (const Branch& branch : branches) sum += branch.modulus * turn * branch.time / (1.0 + turn * branch.time);
    const Complex exact = modulus * (1.0 + std::pow(turn * law.time, law.exponent));
    largest = std::max(largest, std::abs(sum / exact - 1.0));
  }
  return largest;
}

std::vector<Branch> all_branches(const Substrate& s) {
  std::vector<Branch> all = s.branches;
  const GelFit fit = GelFit::of(s.shear_modulus(), s.gel);
  all.insert(all.end(), fit.branches.begin(), fit.branches.end());
  return all;
}

double shear_viscosity(const Substrate& s) { return s.viscosity + GelFit::of(s.shear_modulus(), s.gel).viscosity; }

}  // namespace softwet
