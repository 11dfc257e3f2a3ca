#include "solver/axis_transfer.hpp"

#include <algorithm>

#include "field/stencil.hpp"

namespace softwet {

namespace {

struct Term {
  int source;
  double weight;
};

AxisSums make_sums(const std::vector<std::vector<Term>>& terms) {
  std::size_t width = 0;
  for (const auto& list : terms) width = std::max(width, list.size());
  const AxisSums sums{decltype(AxisSums::source)("transfer.source", terms.size(), width),
                      decltype(AxisSums::weight)("transfer.weight", terms.size(), width)};
  const auto source = Kokkos::create_mirror_view(sums.source);
  const auto weight = Kokkos::create_mirror_view(sums.weight);
  for (std::size_t i = 0; i < terms.size(); ++i)
    for (std::size_t k = 0; k < terms[i].size(); ++k) {
      source(i, k) = terms[i][k].source;
      weight(i, k) = terms[i][k].weight;
    }
  Kokkos::deep_copy(sums.source, source);
  Kokkos::deep_copy(sums.weight, weight);
  return sums;
}

}  // namespace

AxisTransfer make_axis_transfer(const Axis& fine, const Refinement& r) {
  const int period = fine.periodic() ? fine.owned() : 0;
  std::vector<std::vector<Term>> to_coarse(r.coarse.functions()), to_fine(fine.functions());
  for (int j = 0; j < r.coarse.owned(); ++j)
    for (std::size_t k = 0; k < r.coefficient[j].size(); ++k) {
      const double weight = r.coefficient[j][k];
      if (weight == 0) continue;
      const int i = wrapped(r.first[j] + static_cast<int>(k), fine.owned(), period);
      to_coarse[j].push_back({i, weight});
      to_fine[i].push_back({j, weight});
    }
  return {make_sums(to_coarse), make_sums(to_fine), fine.functions(), r.coarse.functions()};
}

}  // namespace softwet
