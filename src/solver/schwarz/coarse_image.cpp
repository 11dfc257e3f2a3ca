#include "solver/schwarz/coarse_image.hpp"

#include <algorithm>
#include <utility>

#include "memory/chunk.hpp"
#include "memory/large_pages.hpp"
#include "solver/schwarz/bfloat16.hpp"

namespace softwet {

namespace {

/// Neighbouring control points at once: of a line where the values are made, of a row where they are used, and those
/// that the registers of a processor hold.
constexpr int line_piece = chunk(64), row_piece = chunk(512), pack = chunk(16);
constexpr int most_shifts = 2 * 3 + 1;  ///< of degree 3

template <int D>
AxisColumns make_columns(const Layout<D>& layout, int d, const AxisSums& to_fine) {
  const Stencil<D> stencil(layout);
  const auto source = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), to_fine.source);
  const auto weight = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), to_fine.weight);
  const int n = stencil.extent[d], shifts = 2 * stencil.degree + 1;
  const auto for_terms = [&](const auto& visit) {
    for (int i = 0; i < n; ++i)
      for (int s = 0; s < shifts && layout.own(i, d); ++s) {
        const int to = stencil.moved(i, s - stencil.degree, d);
        for (std::size_t k = 0; to >= 0 && k < source.extent(1); ++k)
          if (weight(to, k) != 0) visit(i, s, source(to, k), weight(to, k));
      }
  };
  std::vector<std::vector<int>> columns(n);
  const auto number = [&](int i, int column) {
    return std::find(columns[i].begin(), columns[i].end(), column) - columns[i].begin();
  };
  for_terms([&](int i, int, int column, double) {
    if (number(i, column) == static_cast<std::ptrdiff_t>(columns[i].size())) columns[i].push_back(column);
  });
  std::vector<int> count;
  for (const auto& list : columns) count.push_back(static_cast<int>(list.size()));
  const int width = *std::max_element(count.begin(), count.end());
  const AxisColumns result{to_device<decltype(AxisColumns::count)>(count),
                           decltype(AxisColumns::place)("image.place", n, width),
                           decltype(AxisColumns::weight)("image.weight", width, shifts, n)};
  const auto place = Kokkos::create_mirror_view(result.place);
  const auto share = Kokkos::create_mirror_view(result.weight);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < count[i]; ++k) place(i, k) = columns[i][k];
  for_terms([&](int i, int s, int column, double w) { share(number(i, column), s, i) += static_cast<float>(w); });
  Kokkos::deep_copy(result.place, place);
  Kokkos::deep_copy(result.weight, share);
  return result;
}

/// The values of A P. An item is a piece of a line of control points, for a pair of components and the columns that
/// differ along the first axis alone: what they are along the other axes is summed first.
template <int D>
struct FillImage {
  CoarseImageValues<D> out;
  StencilValues matrix;

  KOKKOS_FUNCTION int pieces() const { return chunks_in(out.stencil.extent[0], line_piece); }
  KOKKOS_FUNCTION int lines() const { return out.stencil.points / out.stencil.extent[0]; }
  KOKKOS_FUNCTION int across() const { return out.columns() / out.axis[0].columns(); }
  std::int64_t items() const { return std::int64_t(out.stencil.pairs()) * across() * lines() * pieces(); }

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int n = out.stencil.extent[0], begin = static_cast<int>(item % pieces()) * line_piece;
    const int line = static_cast<int>(item / pieces() % lines()), lines_of_row = out.row_points / n;
    item /= std::int64_t(pieces()) * lines();
    const int other = static_cast<int>(item % across()), pair = static_cast<int>(item / across());
    const int count = begin + line_piece < n ? line_piece : n - begin;
    float sum[most_shifts][line_piece] = {};
    along_other_axes(pair, other, line, begin, count, sum);
    const int shifts = 2 * out.stencil.degree + 1, width = out.axis[0].columns();
    for (int k = 0; k < width; ++k) {
      const std::int64_t to = out.begin(pair, other * width + k, line / lines_of_row) + line % lines_of_row * n + begin;
      for (int i = 0; i < count; ++i) {
        float value = 0;
        for (int s = 0; s < shifts; ++s) value += out.axis[0].weight(k, s, begin + i) * sum[s][i];
        out.entry(to + i) = narrow(value);
      }
    }
  }
  KOKKOS_FUNCTION void along_other_axes(int pair, int other, int line, int begin, int count,
                                        float (&sum)[most_shifts][line_piece]) const {
    const Stencil<D>& in = out.stencil;
    const int shifts = 2 * in.degree + 1;
    for (int o = 0; o < in.offsets / shifts; ++o) {
      float weight = 1;
      int k = other, s = o, at = line;
      for (int d = 1; d < D; ++d) {
        weight *= out.axis[d].weight(k % out.axis[d].columns(), s % shifts, at % in.extent[d]);
        k /= out.axis[d].columns();
        s /= shifts;
        at /= in.extent[d];
      }
      if (weight == 0) continue;
      const float* entry =
          matrix.data() + (std::int64_t(pair) * in.offsets + o * shifts) * in.points + line * in.extent[0] + begin;
      for (int t = 0; t < shifts; ++t)
        for (int i = 0; i < count; ++i) sum[t][i] += weight * entry[std::int64_t(t) * in.points + i];
    }
  }
};

/// Where a coarse vector lies, and which of its values a point of a row needs.
template <int D>
struct CoarseValues {
  ConstArray z;
  ComponentPlaces<D> places;
  int rows, row_points;
  Kokkos::View<const int**, Kokkos::LayoutRight, Exec> source;

  KOKKOS_FUNCTION bool exist(int u, int row) const { return row * row_points >= places.first[u]; }
  KOKKOS_FUNCTION float operator()(int u, int row, int column, int i) const {
    return static_cast<float>(z(places.shift[u] + row * row_points + source(column, i)));
  }
};

/// The values of a coarse row that the points of a fine one need, side by side. An item is one column of all these
/// points.
template <int D>
struct SpreadCoarse {
  CoarseValues<D> from;
  int length;
  StencilValues out;

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int columns = static_cast<int>(from.source.extent(0)), column = static_cast<int>(item % columns);
    const int row = static_cast<int>(item / columns % from.rows), u = static_cast<int>(item / columns / from.rows);
    if (!from.exist(u, row)) return;
    float* to = out.data() + item * length;
    for (int i = 0; i < static_cast<int>(from.source.extent(1)); ++i) to[i] = from(u, row, column, i);
  }
};

/// y = r - A P z. An item is a piece of a row of control points, for one component.
template <int D>
struct SubtractImage {
  CoarseImageValues<D> values;
  ComponentPlaces<D> places;
  CoarseValues<D> from;
  StencilValues spread;  ///< on the host: what SpreadCoarse makes of these
  ConstArray r, mask;
  Array y;

  KOKKOS_FUNCTION int pieces() const { return chunks_in(values.row_points, row_piece); }
  std::int64_t items() const { return std::int64_t(values.stencil.components) * values.rows() * pieces(); }

  KOKKOS_FUNCTION void operator()(std::int64_t item) const {
    const int begin = static_cast<int>(item % pieces()) * row_piece;
    const int row = static_cast<int>(item / pieces() % values.rows());
    const int a = static_cast<int>(item / pieces() / values.rows()), components = values.stencil.components;
    if (row * values.row_points < places.first[a]) return;
    const int end = begin + row_piece < values.row_points ? begin + row_piece : values.row_points;
    float sum[row_piece] = {};
    const AxisColumns& last = values.axis[D - 1];
    for (int u = 0; u < components; ++u)
      for (int k = 0; k < last.count(row) && values.stencil.couples(a, u); ++k)
        if (from.exist(u, last.place(row, k))) add(a, u, k, row, begin, end - begin, sum);
    const int first = places.shift[a] + row * values.row_points;
    for (int i = begin; i < end; ++i) y(first + i) = (r(first + i) - sum[i - begin]) * mask(first + i);
  }
  /// The columns in one coarse row.
  KOKKOS_FUNCTION void add(int a, int u, int k, int row, int begin, int count, float* sum) const {
    const int coarse_row = values.axis[D - 1].place(row, k), pair = values.stencil.pair(a, u);
    for (int c = 0; c < values.in_row;) {
      const std::uint16_t* entry = values.entry.data() + values.begin(pair, k * values.in_row + c, row) + begin;
      if constexpr (host_algorithms) {
        const float* at =
            spread.data() + ((std::int64_t(u) * from.rows + coarse_row) * values.in_row + c) * values.length + begin;
        if (c + 4 <= values.in_row) {
          add_columns(entry, at, count, sum, std::make_integer_sequence<int, 4>());
          c += 4;
          continue;
        }
        add_columns(entry, at, count, sum, std::make_integer_sequence<int, 1>());
      } else {
        sum[0] += widen(*entry) * from(u, coarse_row, c, begin);
      }
      ++c;
    }
  }
  /// Whole packs: what lies beyond the end of the row is not used.
  template <int... K>
  KOKKOS_FUNCTION void add_columns(const std::uint16_t* entry, const float* from, int count, float* sum,
                                   std::integer_sequence<int, K...>) const {
    const int next = values.length;
    for (int j = 0; j < count; j += pack)
      for (int i = j; i < j + pack; ++i) sum[i] += ((widen(entry[K * next + i]) * from[K * next + i]) + ...);
  }
};

}  // namespace

template <int D>
CoarseImage<D>::CoarseImage(const Layout<D>& fine, const ConstArray& mask, const CoarseSpace<D>& space)
    : values_{Stencil<D>(fine)},
      mask_(mask),
      places_(fine),
      coarse_places_(space.layout()),
      coarse_rows_(space.layout().extent(D - 1)),
      coarse_row_points_(Stencil<D>(space.layout()).points / coarse_rows_) {
  for (int d = 0; d < D; ++d) values_.axis[d] = make_columns(fine, d, space.axis(d).to_fine);
  for (int d = 0; d + 1 < D; ++d) {
    values_.in_row *= values_.axis[d].columns();
    values_.row_points *= values_.stencil.extent[d];
  }
  values_.length = chunks_in(values_.row_points, pack) * pack;
  source_ = decltype(source_)("image.source", values_.in_row, values_.row_points);
  const auto source = Kokkos::create_mirror_view(source_);
  for (int d = 0, points = 1, columns = 1, stride = 1; d + 1 < D; ++d) {
    const auto place = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), values_.axis[d].place);
    for (int k = 0; k < values_.in_row; ++k)
      for (int i = 0; i < values_.row_points; ++i)
        source(k, i) += stride * place(i / points % place.extent(0), k / columns % place.extent(1));
    points *= values_.stencil.extent[d];
    columns *= values_.axis[d].columns();
    stride *= space.layout().extent(d);
  }
  Kokkos::deep_copy(source_, source);
  if (host_algorithms)
    spread_ = StencilValues("image.z",
                            std::int64_t(values_.stencil.components) * coarse_rows_ * values_.in_row * values_.length);
}

template <int D>
void CoarseImage<D>::build(const StencilMatrix<D>& matrix) {
  if (values_.entry.extent(0) == 0) {
    values_.entry = large_array<decltype(values_.entry)>("image", values_.size());
    Kokkos::deep_copy(values_.entry, std::uint16_t(0));
  }
  const FillImage<D> fill{values_, matrix.values()};
  Kokkos::parallel_for("softwet::fill_image", LongItems(0, fill.items()), fill);
}

template <int D>
void CoarseImage<D>::residual(const ConstArray& r, const ConstArray& z, const Array& y) const {
  const CoarseValues<D> from{z, coarse_places_, coarse_rows_, coarse_row_points_, source_};
  if (host_algorithms)
    Kokkos::parallel_for("softwet::spread", LongItems(0, spread_.extent(0) / values_.length),
                         SpreadCoarse<D>{from, values_.length, spread_});
  const SubtractImage<D> subtract{values_, places_, from, spread_, r, mask_, y};
  Kokkos::parallel_for("softwet::image", LongItems(0, subtract.items()), subtract);
}

template class CoarseImage<2>;
template class CoarseImage<3>;

}  // namespace softwet
