#include "solver/schwarz/axis_transfer.hpp"

#include <algorithm>
#include <stdexcept>

#include "field/stencil.hpp"

namespace softwet {

namespace {

struct TransferTerm {
  int source;
  double weight;
};

AxisSums make_sums(const std::vector<std::vector<TransferTerm>>& terms) {
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

using TransferTerms = std::vector<std::vector<TransferTerm>>;

enum class AtCopies { nothing, what_is_stored };

/// Sums of functions as sums at places. One at a copy is left out where not all that it needs is stored.
AxisSums at_places(const TransferTerms& terms, const AxisPlaces& to, const AxisPlaces& from, AtCopies copies) {
  TransferTerms result(to.function.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (!to.own[i] && (copies == AtCopies::nothing || to.function[i] < 0)) continue;
    bool stored = true;
    for (const TransferTerm& t : terms[to.function[i]]) stored = stored && from.place[t.source] >= 0;
    if (!stored && to.own[i]) throw std::logic_error("a coarse space needs more columns beside those of a process");
    if (!stored) continue;
    for (const TransferTerm& t : terms[to.function[i]]) result[i].push_back({from.place[t.source], t.weight});
  }
  return make_sums(result);
}

}  // namespace

AxisPlaces axis_places(const Axis& axis, const Columns& columns) {
  AxisPlaces p;
  p.place = places_of_functions(axis, columns);
  const bool whole = columns.ranks == 1;
  for (int i = 0; i < (whole ? axis.functions() : columns.stored()); ++i) {
    const int f = whole ? i : columns.function[i];
    p.function.push_back(f < axis.owned() ? f : whole ? -1 : f - axis.owned());
    p.own.push_back(f < axis.owned() && (whole || columns.own(i)));
  }
  return p;
}

AxisTransfer make_axis_transfer(const Axis& fine, const Refinement& r, const AxisPlaces& fine_places,
                                const AxisPlaces& coarse_places) {
  const int period = fine.periodic() ? fine.owned() : 0;
  TransferTerms to_coarse(r.coarse.functions()), to_fine(fine.functions());
  for (int j = 0; j < r.coarse.owned(); ++j)
    for (std::size_t k = 0; k < r.coefficient[j].size(); ++k) {
      const double weight = r.coefficient[j][k];
      if (weight == 0) continue;
      const int i = wrapped(r.first[j] + static_cast<int>(k), fine.owned(), period);
      to_coarse[j].push_back({i, weight});
      to_fine[i].push_back({j, weight});
    }
  return {at_places(to_coarse, coarse_places, fine_places, AtCopies::nothing),
          at_places(to_fine, fine_places, coarse_places, AtCopies::what_is_stored),
          static_cast<int>(fine_places.function.size()), static_cast<int>(coarse_places.function.size())};
}

}  // namespace softwet
