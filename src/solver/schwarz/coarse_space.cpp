#include "solver/schwarz/coarse_space.hpp"

#include <algorithm>

#include "memory/chunk.hpp"

namespace softwet {

namespace {

/// Entries of a line of control points along the first axis that are summed at once.
constexpr int sum_piece = chunk(64);

/// Sums along axis d of all components. An item is a piece of a line of the result.
template <int D>
struct SumAxis {
  AxisSums sums;
  Places<D> from_place, to_place;
  ConstArray from, mask;  ///< mask of the result; empty: nothing is prescribed
  Array to;
  int d, components;

  KOKKOS_FUNCTION int pieces() const { return chunks_in(to_place.extent[0], sum_piece); }
  std::int64_t items() const { return std::int64_t(components) * (to_place.points / to_place.extent[0]) * pieces(); }

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int n = to_place.extent[0], lines = to_place.points / n;
    const int begin = static_cast<int>(item % pieces()) * sum_piece, line = static_cast<int>(item / pieces() % lines);
    const int c = static_cast<int>(item / pieces() / lines), count = begin + sum_piece < n ? sum_piece : n - begin;
    if (line * n < to_place.first[c]) return;
    double sum[sum_piece] = {};
    if (d == 0) {
      along_line(c, line, begin, count, sum);
    } else {
      across_lines(c, line, begin, count, sum);
    }
    const int first = to_place.shift[c] + line * n + begin;
    for (int i = 0; i < count; ++i) to(first + i) = mask.extent(0) == 0 || mask(first + i) != 0 ? sum[i] : 0.0;
  }
  KOKKOS_FUNCTION void along_line(int c, int line, int begin, int count, double* sum) const {
    const double* source = from.data() + from_place.shift[c] + line * from_place.extent[0];
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < static_cast<int>(sums.weight.extent(1)); ++k)
        sum[i] += sums.weight(begin + i, k) * source[sums.source(begin + i, k)];
  }
  KOKKOS_FUNCTION void across_lines(int c, int line, int begin, int count, double* sum) const {
    int below = 1;  // lines between neighbours along axis d
    for (int e = 1; e < d; ++e) below *= to_place.extent[e];
    const int row = line / below % to_place.extent[d], above = line / below / to_place.extent[d];
    for (int k = 0; k < static_cast<int>(sums.weight.extent(1)); ++k) {
      const double weight = sums.weight(row, k);
      const int other = (above * from_place.extent[d] + sums.source(row, k)) * below + line % below;
      const int start = other * from_place.extent[0];
      if (weight == 0 || start < from_place.first[c]) continue;
      const double* source = from.data() + from_place.shift[c] + start + begin;
      for (int i = 0; i < count; ++i) sum[i] += weight * source[i];
    }
  }
};

/// Coarse unknowns are free where the fine one that follows them most closely is: ends map to ends, wall to wall.
template <int D>
std::vector<double> coarse_mask(const Layout<D>& fine, const Layout<D>& coarse, const std::vector<double>& mask,
                                const std::vector<Refinement>& refinement) {
  const Stencil<D> in(fine), out(coarse);
  const std::vector<int> column = places_of_functions(fine.axis[0], fine.columns);
  std::vector<double> result(coarse.size(), 0.0);
  for (int c = 0; c < out.components; ++c)
    for (int p = coarse.component_first(c); p < out.points; ++p) {
      int partner = 0, stride = 1;
      bool owned = true;
      for (int d = 0; d < D; ++d) {
        const Axis& axis = fine.axis[d];
        const int place = out.coordinate(p, d), i = coarse.function(place, d);
        const auto& row = refinement[d].coefficient[i];
        const int k = static_cast<int>(std::max_element(row.begin(), row.end()) - row.begin());
        owned = owned && i < coarse.axis[d].owned() && coarse.own(place, d);
        const int function = wrapped(refinement[d].first[i] + k, axis.owned(), axis.periodic() ? axis.owned() : 0);
        partner += stride * (d == 0 ? column[function] : function);
        stride *= in.extent[d];
      }
      if (owned) result[coarse.component_shift(c) + p] = mask[fine.component_shift(c) + partner];
    }
  return result;
}

/// Cuts the columns of a coarse layout where the columns of the fine one are cut.
template <int D>
void cut_like(const Layout<D>& fine, Layout<D>& coarse) {
  const bool joined = coarse.axis[0].elements() < fine.axis[0].elements();
  std::vector<int> first;
  for (int f : fine.columns.first_function) first.push_back(joined ? f / 2 : f);
  first.back() = coarse.axis[0].functions();
  coarse.columns = cut_before(coarse.axis[0], fine.columns.rank, first, fine.columns.beside);
  coarse.exchange = plan_exchange(coarse.axis[0], coarse.columns);
}

}  // namespace

template <int D>
CoarseSpace<D>::CoarseSpace(const Layout<D>& fine, const ConstArray& mask, int least, TransferKernels kernels)
    : fine_(fine), layout_(fine.whole_patch()), fine_mask_(mask), kernels_(kernels) {
  std::vector<Refinement> refinement;
  layout_.axis.clear();
  layout_.row_size = 1;
  for (int d = 0; d < D; ++d) {
    refinement.push_back(refine_from_half(fine.axis[d], least));
    layout_.axis.push_back(refinement[d].coarse);
    if (d == 0 && !fine.whole()) cut_like(fine, layout_);
    if (d < D - 1) layout_.row_size *= layout_.extent(d);
    axis_[d] =
        make_axis_transfer(fine.axis[d], refinement[d], axis_places(fine.axis[d], d == 0 ? fine.columns : Columns()),
                           axis_places(layout_.axis[d], d == 0 ? layout_.columns : Columns()));
    exists_ = exists_ || refinement[d].coarse.elements() < fine.axis[d].elements();
  }
  const Axis& vertical = layout_.axis[D - 1];
  layout_.rows = vertical.functions();
  if (layout_.has_solid) layout_.solid_elements = layout_.has_fluid ? vertical.kink() : vertical.elements();
  if (layout_.has_solid)
    layout_.wall_row = layout_.has_fluid ? vertical.span(layout_.solid_elements) : layout_.rows - 1;
  const Array free = to_device<Array>(coarse_mask(fine, layout_, to_host(mask), refinement), "coarse.mask");
  if (!layout_.whole()) update_columns<double>(layout_.columns, *layout_.exchange, free);
  mask_ = free;
  product_.emplace(fine, layout_, refinement);
  int points = Stencil<D>(fine).points;
  for (int step = 0; step + 1 < D && kernels == TransferKernels::one_for_each_axis; ++step) {
    points = points / axis_[D - 1 - step].fine * axis_[D - 1 - step].coarse;
    between_[step] = Array("coarse.between", std::size_t(fine.components()) * points);
  }
}

/// Axis by axis: those in between have the rows of the coarse space, so that the fewest sums have the longest lines.
template <int D>
void CoarseSpace<D>::transfer(Towards towards, const ConstArray& from, const Array& to) const {
  const bool to_coarse = towards == Towards::coarse;
  if (kernels_ == TransferKernels::one) {
    const WriteEntries<SumAllAxes<D, double>> all{to_coarse ? restriction(from) : prolongation(from), to};
    return Kokkos::parallel_for("softwet::transfer", LongItems(0, all.items()), all);
  }
  const Layout<D>& source = to_coarse ? fine_ : layout_;
  const Layout<D>& target = to_coarse ? layout_ : fine_;
  Places<D> from_place = places_of(source);
  ConstArray values = from;
  for (int step = 0; step < D; ++step) {
    const int d = to_coarse ? D - 1 - step : step;
    const bool last = step == D - 1;
    Places<D> to_place = last ? places_of(target) : from_place;
    if (!last) {
      to_place.extent[d] = target.extent(d);
      to_place.points = from_place.points / from_place.extent[d] * to_place.extent[d];
      const int row = to_place.points / to_place.extent[D - 1];
      for (int c = 0; c < D + 2; ++c) {
        to_place.shift[c] = c * to_place.points;
        to_place.first[c] = c < D ? 0 : layout_.wall_row * row;
      }
    }
    const Array result = last ? to : between_[to_coarse ? step : D - 2 - step];
    const ConstArray mask = !last ? ConstArray() : to_coarse ? mask_ : fine_mask_;
    const AxisSums& sums = to_coarse ? axis_[d].to_coarse : axis_[d].to_fine;
    const SumAxis<D> body{sums, from_place, to_place, values, mask, result, d, source.components()};
    Kokkos::parallel_for("softwet::transfer", LongItems(0, body.items()), body);
    from_place = to_place;
    values = result;
  }
}

template <int D>
void CoarseSpace<D>::restrict_to(const ConstArray& fine, const Array& coarse) const {
  transfer(Towards::coarse, fine, coarse);
}

template <int D>
void CoarseSpace<D>::prolong(const ConstArray& coarse, const Array& fine) const {
  transfer(Towards::fine, coarse, fine);
}

template class CoarseSpace<2>;
template class CoarseSpace<3>;

}  // namespace softwet
