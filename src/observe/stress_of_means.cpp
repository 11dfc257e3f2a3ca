#include <algorithm>

#include "observe/acting_stress.hpp"
#include "scene/beside_joint.hpp"
#include "scene/selective.hpp"

namespace softwet {
namespace {

using Tensor = Matrix<double, 3>;

/// The elements of an axis that hold a point, among [first, last): two on a line between them.
std::vector<int> holders(const Axis& axis, double x, int first, int last) {
  const int e = std::clamp(axis.element_at(x), first, last - 1), n = axis.elements();
  const double hair = one_height * axis.length(), low = x - axis.lower(e), high = axis.size(e) - low;
  const bool round = axis.periodic() && first == 0 && last == n;
  if (low < hair && (e > first || round)) return {e > first ? e - 1 : n - 1, e};
  if (high < hair && (e + 1 < last || round)) return {e, e + 1 < last ? e + 1 : 0};
  return {e};
}

/// The elements that hold the points of an axis, each once, and for each point their numbers in this list.
struct HoldersAlong {
  std::vector<int> elements;
  std::vector<std::vector<int>> of_point;

  HoldersAlong(const Axis& axis, const std::vector<double>& points, int first, int last) {
    for (const double x : points) of_point.push_back(holders(axis, x, first, last));
    for (const std::vector<int>& some : of_point) elements.insert(elements.end(), some.begin(), some.end());
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
    for (std::vector<int>& some : of_point)
      for (int& e : some)
        e = static_cast<int>(std::lower_bound(elements.begin(), elements.end(), e) - elements.begin());
  }
};

template <int D>
class MeansOfElements {
 public:
  MeansOfElements(const SolidPoints<D>& at, const ChosenMaterial& material, const SolidCoefficients& solid) {
    std::array<std::vector<int>, D> elements;
    for (int d = 0; d < D; ++d) {
      const Axis& axis = at.snapshot.layout().axis[d];
      const bool vertical = d == D - 1;
      along_.emplace_back(axis, at.grid[d], vertical ? at.rows.first : 0, vertical ? at.rows.last : axis.elements());
      elements[d] = along_[d].elements;
    }
    const std::vector<Tensor> means = mean_gradients<D>(at.snapshot, elements);
    for (std::size_t k = 0; k < means.size(); ++k)
      stress_.push_back(share(at.snapshot.layout(), elements, k, solid) * material.first_piola(means[k]));
  }

  /// The mean of the stresses of the elements that hold a point.
  Tensor at(std::size_t point) const {
    std::array<const std::vector<int>*, D> holders;
    std::size_t count = 1;
    for (int d = 0; d < D; ++d) {
      const auto& points = along_[d].of_point;
      holders[d] = &points[point % points.size()];
      point /= points.size();
      count *= holders[d]->size();
    }
    Tensor sum{};
    for (std::size_t k = 0; k < count; ++k) {
      std::size_t rest = k, number = 0, stride = 1;
      for (int d = 0; d < D; ++d) {
        number += stride * (*holders[d])[rest % holders[d]->size()];
        rest /= holders[d]->size();
        stride *= along_[d].elements.size();
      }
      sum = sum + stress_[number];
    }
    return (1.0 / count) * sum;
  }

 private:
  /// The mean stiffness of an element over the stiffness of the material.
  static double share(const Layout<D>& layout, const std::array<std::vector<int>, D>& elements, std::size_t k,
                      const SolidCoefficients& solid) {
    if (!solid.young.varies()) return 1;
    std::array<double, D> low, size;
    for (int d = 0; d < D; ++d) {
      const int e = elements[d][k % elements[d].size()];
      low[d] = layout.axis[d].lower(e), size[d] = layout.axis[d].size(e);
      k /= elements[d].size();
    }
    const Gauss rule(layout.axis[0].degree() + 1);
    const std::size_t n = rule.point.size();
    double sum = 0;
    for (std::size_t q = 0; q < (D == 3 ? n * n * n : n * n); ++q) {
      std::array<double, 3> x{};
      double weight = 1;
      std::size_t rest = q;
      for (int d = 0; d < D; ++d, rest /= n) {
        x[d] = low[d] + size[d] * rule.point[rest % n];
        weight *= rule.weight[rest % n];
      }
      sum += weight * solid.young.at(x);
    }
    return sum / solid.largest_young;
  }

  std::vector<HoldersAlong> along_;
  std::vector<Tensor> stress_;
};

}  // namespace

template <int D>
void take_means(const SolidPoints<D>& at, const std::vector<Tensor>& gradients, const SolidCoefficients& solid,
                std::vector<Tensor>& stress) {
  const ElasticLaw law = std::visit([](const auto& term) { return law_of(term.material); }, solid.law);
  const SelectiveMaterials parts = selective_materials(law, solid.stiffness, solid.prestretch);
  if (!parts.has_means()) return;
  const ChosenMaterial& material = parts.of_means;
  const MeansOfElements<D> means(at, material, solid);
  for (std::size_t i = 0; i < stress.size(); ++i) {
    const double share = solid.young.varies() ? solid.young.at(at.place(i)) / solid.largest_young : 1;
    stress[i] = stress[i] + means.at(i) + (-share) * material.first_piola(gradients[i]);
  }
}

template void take_means(const SolidPoints<2>&, const std::vector<Tensor>&, const SolidCoefficients&,
                         std::vector<Tensor>&);
template void take_means(const SolidPoints<3>&, const std::vector<Tensor>&, const SolidCoefficients&,
                         std::vector<Tensor>&);

}  // namespace softwet
