#include "solver/coarse_space.hpp"

#include <algorithm>

namespace softwet {

namespace {

using Policy = Kokkos::RangePolicy<Exec, Kokkos::IndexType<std::int64_t>>;

Kokkos::View<double**, Kokkos::LayoutRight, Exec> padded(const std::vector<std::vector<double>>& rows) {
  std::size_t width = 0;
  for (const auto& row : rows) width = std::max(width, row.size());
  Kokkos::View<double**, Kokkos::LayoutRight, Exec> table("transfer", rows.size(), width);
  const auto host = Kokkos::create_mirror_view(table);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < rows[i].size(); ++k) host(i, k) = rows[i][k];
  Kokkos::deep_copy(table, host);
  return table;
}

AxisTransfer make_transfer(const Axis& fine, const Refinement& r) {
  AxisTransfer t;
  t.fine = fine.functions();
  t.coarse = r.coarse.functions();
  t.fine_owned = fine.owned();
  t.coarse_owned = r.coarse.owned();
  t.periodic = fine.periodic();
  // The transpose: coarse functions that hold a fine one follow each other, on a periodic axis also across its ends.
  std::vector<std::vector<double>> of_fine(fine.functions());
  std::vector<int> first(fine.functions(), 0);
  const int turns = t.periodic ? 1 : 0;
  for (int i = 0; i < t.fine_owned; ++i)
    for (int j = -turns * t.coarse_owned; j < (1 + turns) * t.coarse_owned; ++j) {
      const int turn = j < 0 ? -1 : j / t.coarse_owned, at = j - turn * t.coarse_owned;
      const int k = i - r.first[at] - turn * t.fine_owned;
      if (k < 0 || k >= static_cast<int>(r.coefficient[at].size())) continue;
      if (of_fine[i].empty()) first[i] = j;
      of_fine[i].push_back(r.coefficient[at][k]);
    }
  t.first_fine = to_device<Kokkos::View<int*, Exec>>(r.first);
  t.first_coarse = to_device<Kokkos::View<int*, Exec>>(first);
  t.to_fine = padded(r.coefficient);
  t.to_coarse = padded(of_fine);
  return t;
}

/// out(point) = sum over the other side's points of the product of coefficients, component by component.
template <int D, bool ToCoarse>
struct Transfer {
  AxisTransfer axis[D];
  ConstArray from, mask;
  Array to;
  ComponentPlaces<D> from_place, to_place;
  int points;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int c = static_cast<int>(item / points), point = static_cast<int>(item % points);
    if (point < to_place.first[c]) return;
    const int unknown = to_place.shift[c] + point;
    int at[3] = {0, 0, 0}, rest = point;
    for (int d = 0; d < D; ++d) {
      const int n = ToCoarse ? axis[d].coarse : axis[d].fine;
      at[d] = rest % n;
      rest /= n;
    }
    to(unknown) = mask(unknown) == 0 ? 0.0 : sum(c, at, D - 1, 0);
  }
  KOKKOS_FUNCTION double sum(int c, const int* at, int d, int base) const {
    const AxisTransfer& t = axis[d];
    const auto& table = ToCoarse ? t.to_fine : t.to_coarse;
    const int first = ToCoarse ? t.first_fine(at[d]) : t.first_coarse(at[d]);
    const int n = ToCoarse ? t.fine : t.coarse, owned = ToCoarse ? t.fine_owned : t.coarse_owned;
    double result = 0;
    for (int k = 0; k < static_cast<int>(table.extent(1)); ++k) {
      const double factor = table(at[d], k);
      const int i = wrapped(first + k, owned, t.periodic ? owned : 0);
      if (factor == 0 || i < 0) continue;
      const int index = base * n + i;
      if (d > 0) {
        result += factor * sum(c, at, d - 1, index);
      } else if (index >= from_place.first[c]) {
        result += factor * from(from_place.shift[c] + index);
      }
    }
    return result;
  }
};

/// Rows and columns along one axis replaced by their coarse sums; an item is one entry of one line of rows.
template <int D>
struct CoarsenAxis {
  Stencil<D> in, out;
  StencilValues from, to;
  AxisTransfer axis;
  int d, below, above;  ///< control points below and above axis d in the order of storage

  std::int64_t items() const { return out.size() / out.points * above * out.extent[d]; }

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int row = static_cast<int>(item % out.extent[d]), high = static_cast<int>(item / out.extent[d] % above);
    const std::int64_t block = item / out.extent[d] / above;
    const int offset = static_cast<int>(block % out.offsets);
    float* sum = to.data() + block * out.points + (std::int64_t(high) * out.extent[d] + row) * below;
    for (int i = 0; i < below; ++i) sum[i] = 0;
    const int shift = out.shift(offset, d), column = row + shift;
    const int at = wrapped(column, axis.coarse_owned, out.period[d]);
    if (row >= axis.coarse_owned || at < 0) return;
    const int row_fine = axis.first_fine(row);
    const int column_fine = axis.first_fine(at) + (column - at) / axis.coarse_owned * axis.fine_owned;
    int weight = 1;  // of this axis' shift in an offset
    for (int e = 0; e < d; ++e) weight *= 2 * out.degree + 1;
    const std::int64_t first = block - (shift + out.degree) * weight;  // the block with the least shift along this axis
    const int n = static_cast<int>(axis.to_fine.extent(1));
    for (int k = 0; k < n; ++k) {
      const int i = wrapped(row_fine + k, axis.fine_owned, in.period[d]);
      if (axis.to_fine(row, k) == 0 || i < 0) continue;
      for (int l = 0; l < n; ++l) {
        const int step = column_fine + l - row_fine - k;
        const float factor = static_cast<float>(axis.to_fine(row, k) * axis.to_fine(at, l));
        if (factor == 0 || step < -in.degree || step > in.degree) continue;
        const float* source = from.data() + (first + (step + in.degree) * weight) * in.points +
                              (std::int64_t(high) * in.extent[d] + i) * below;
        for (int j = 0; j < below; ++j) sum[j] += factor * source[j];
      }
    }
  }
};

/// Coarse unknowns are free where the fine one that follows them most closely is: ends map to ends, wall to wall.
template <int D>
std::vector<double> coarse_mask(const Layout<D>& fine, const Layout<D>& coarse, const std::vector<double>& mask,
                                const std::vector<Refinement>& refinement) {
  const Stencil<D> in(fine), out(coarse);
  std::vector<double> result(coarse.size(), 0.0);
  for (int c = 0; c < out.components; ++c)
    for (int p = coarse.component_first(c); p < out.points; ++p) {
      int partner = 0, stride = 1;
      bool owned = true;
      for (int d = 0; d < D; ++d) {
        const int i = out.coordinate(p, d);
        const auto& row = refinement[d].coefficient[i];
        const int k = static_cast<int>(std::max_element(row.begin(), row.end()) - row.begin());
        owned = owned && i < coarse.axis[d].owned();
        partner += stride * wrapped(refinement[d].first[i] + k, fine.axis[d].owned(), in.period[d]);
        stride *= in.extent[d];
      }
      if (owned) result[coarse.component_shift(c) + p] = mask[fine.component_shift(c) + partner];
    }
  return result;
}

}  // namespace

template <int D>
CoarseSpace<D>::CoarseSpace(const Layout<D>& fine, const ConstArray& mask, int least)
    : fine_(fine), layout_(fine), fine_mask_(mask) {
  std::vector<Refinement> refinement;
  layout_.axis.clear();
  layout_.row_size = 1;
  for (int d = 0; d < D; ++d) {
    refinement.push_back(refine_from_half(fine.axis[d], least));
    layout_.axis.push_back(refinement[d].coarse);
    if (d < D - 1) layout_.row_size *= refinement[d].coarse.functions();
    axis_[d] = make_transfer(fine.axis[d], refinement[d]);
    exists_ = exists_ || axis_[d].coarse_owned < axis_[d].fine_owned;
  }
  const Axis& vertical = layout_.axis[D - 1];
  const bool halved = vertical.elements() < fine.axis[D - 1].elements();
  layout_.rows = vertical.functions();
  layout_.solid_elements = fine.solid_elements / (halved ? 2 : 1);
  if (layout_.has_solid)
    layout_.wall_row = layout_.has_fluid ? vertical.span(layout_.solid_elements) : layout_.rows - 1;
  mask_ = to_device<Array>(coarse_mask(fine, layout_, to_host(mask), refinement), "coarse.mask");
}

template <int D, bool ToCoarse>
void transfer(const Layout<D>& from_layout, const Layout<D>& to_layout, const AxisTransfer (&axis)[D],
              const ConstArray& from, const ConstArray& mask, const Array& to) {
  const Stencil<D> points(to_layout);
  const ComponentPlaces<D> from_place(from_layout), to_place(to_layout);
  Transfer<D, ToCoarse> body{{}, from, mask, to, from_place, to_place, points.points};
  for (int d = 0; d < D; ++d) body.axis[d] = axis[d];
  Kokkos::parallel_for("softwet::transfer", Policy(0, std::int64_t(points.components) * points.points), body);
}

template <int D>
void CoarseSpace<D>::restrict_to(const ConstArray& fine, const Array& coarse) const {
  transfer<D, true>(fine_, layout_, axis_, fine, mask_, coarse);
}

template <int D>
void CoarseSpace<D>::prolong(const ConstArray& coarse, const Array& fine) const {
  transfer<D, false>(layout_, fine_, axis_, coarse, fine_mask_, fine);
}

template <int D>
void CoarseSpace<D>::galerkin(const StencilMatrix<D>& fine, const StencilValues& coarse) const {
  Stencil<D> in = fine.stencil();
  StencilValues from = fine.values();
  for (int d = D - 1; d >= 0; --d) {  // the first axis last: rows of neighbouring points stay together meanwhile
    Stencil<D> out = in;
    out.points = in.points / in.extent[d] * axis_[d].coarse;
    out.extent[d] = axis_[d].coarse;
    out.period[d] = axis_[d].periodic ? axis_[d].coarse_owned : 0;
    const StencilValues to =
        d == 0 ? coarse : StencilValues(Kokkos::view_alloc("galerkin", Kokkos::WithoutInitializing), out.size());
    int below = 1;
    for (int e = 0; e < d; ++e) below *= out.extent[e];
    const CoarsenAxis<D> body{in, out, from, to, axis_[d], d, below, out.points / below / out.extent[d]};
    Kokkos::parallel_for("softwet::galerkin", Policy(0, body.items()), body);
    in = out;
    from = to;
  }
}

template <int D>
double CoarseSpace<D>::transient_bytes() const {
  Stencil<D> s(fine_);
  double points = 1, bytes = 0;
  for (int d = 0; d < D; ++d) points *= s.extent[d];
  for (int d = D - 1; d > 0; --d) {
    points = points / s.extent[d] * axis_[d].coarse;
    bytes += 4.0 * s.size() / s.points * points;
  }
  return bytes;
}

template class CoarseSpace<2>;
template class CoarseSpace<3>;

}  // namespace softwet
