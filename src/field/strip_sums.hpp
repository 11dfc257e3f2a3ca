// Sums over vectors in one fixed order, so that results depend neither on the number of threads nor on that of processes.
#pragma once

#include "field/array.hpp"
#include "field/range_factors.hpp"
#include "field/ranks.hpp"
#include "spline/columns.hpp"

namespace softwet {

/// How the vectors of the scene that a process computes lie in lines of columns: what sums have to know of it. A model
/// sets it. The columns [begin, end) are the process's own. A vector whose size is no multiple of `stored` is none of them.
struct SumColumns {
  int stored = 0, begin = 0, end = 0;
  int first_strip = 0, last_strip = 0, strips = 0;
  int first_function = 0, functions = 0;  ///< of the first own column less its place; in a line of the whole patch
};
inline SumColumns& sum_columns() {
  static SumColumns columns;
  return columns;
}
inline void set_sum_columns(const Columns& c) {
  sum_columns() = {c.stored(),
                   c.begin,
                   c.end,
                   c.elements.first_strip,
                   c.elements.last_strip,
                   c.elements.strips,
                   c.first_function[c.rank] - c.begin,
                   c.first_function.back()};
}

/// Sums by strip of columns. A strip has one order of its own, and the strips are added up in their order by all
/// processes, after each has told the others its own. So the number of processes does not matter.
class StripTotals {
 public:
  explicit StripTotals(int strips, int sums = 1) : strips_(strips), total_(static_cast<std::size_t>(strips) * sums) {}
  void add(int strip, int sum, double part) { total_[sum * strips_ + strip] += part; }
  double total(int sum) {
    if (!told_) ranks::add(total_.data(), static_cast<int>(total_.size()));
    told_ = true;
    double all = 0;
    for (int s = 0; s < strips_; ++s) all += total_[sum * strips_ + s];
    return all;
  }

 private:
  int strips_;
  std::vector<double> total_;
  bool told_ = false;
};

/// Scratch for partial sums: allocated once, grown when needed, released before Kokkos ends.
struct SumSpace {
  Array device;
  Array::host_mirror_type host;
};
inline SumSpace& sum_space(std::size_t entries) {
  static SumSpace space;
  if (space.device.extent(0) < entries) {
    if (!space.device.data()) Kokkos::push_finalize_hook([] { space = {}; });
    space.device = Array(Kokkos::view_alloc("partial sums", Kokkos::WithoutInitializing), entries);
    space.host = Kokkos::create_mirror_view(space.device);
  }
  return space;
}

/// Sums over one strip of some lines, in double precision, whatever the vectors are: of x_k(i) y(i) for several vectors x_k
/// that follow each other in memory and for each y, and of y(i)^2 of the first y behind them; each entry times its weight.
template <class Real>
struct StripSums {
  static constexpr int lines_at_once = 64, most_others = 2;
  const Real* x;
  int stride, count;           ///< of the x_k
  const Real* y[most_others];  ///< null: the sum of x
  int others;                  ///< number of the y
  bool square;                 ///< of the first y too
  int size;                    ///< of each vector
  RangeFactors weights = {};
  SumColumns columns = {};  ///< set by the constructor, as all below
  bool of_scene = false;    ///< else each process has all of these vectors
  bool whole_lines = true;  ///< all entries of a line have one weight
  int place = 0;            ///< of its partial sums
  Array partial = {};       ///< [lines][sum][own strip]

  StripSums(const Real* x_, int stride_, int count_, const std::vector<const Real*>& y_, bool square_, int size_,
            const RangeFactors& weights_ = {})
      : x(x_),
        stride(stride_),
        count(count_),
        y{},
        others(static_cast<int>(y_.size())),
        square(square_),
        size(size_),
        weights(weights_) {
    for (int m = 0; m < others; ++m) y[m] = y_[m];
    const SumColumns& scene = sum_columns();
    of_scene = scene.stored > 0 && size % scene.stored == 0;
    columns = of_scene ? scene : SumColumns{strip_width, 0, strip_width, 0, 1, 1, 0, strip_width};
    whole_lines = weights.multiples_of(columns.stored);
  }

  KOKKOS_FUNCTION int strips() const { return columns.last_strip - columns.first_strip; }
  KOKKOS_FUNCTION int sums() const { return count * others + (square ? 1 : 0); }
  int items() const {
    const int lines = (size + columns.stored - 1) / columns.stored;
    return (lines + lines_at_once - 1) / lines_at_once * strips() * sums();
  }
  KOKKOS_FUNCTION void operator()(int item) const {
    const int strip = item % strips(), k = item / strips() % sums(), block = item / strips() / sums();
    const int begin = columns.begin + strip * strip_width;
    const int end = strip + 1 < strips() ? begin + strip_width : columns.end;
    const int first = block * lines_at_once, left = size / columns.stored - first;
    const int start = first * columns.stored + begin, lines = left < lines_at_once ? left : lines_at_once;
    const bool pair = k < count * others;
    const Real *a = pair ? x + std::int64_t(k / others) * stride : y[0], *b = y[pair ? k % others : 0];
    const RangeFactors& w = weights;
    const auto one = [](int) { return 1.0; };
    double sum[2 * strip_width] = {};
    if (!b) {
      add(sum, start, lines, end - begin, one, [=](int i) { return static_cast<double>(a[i]); });
    } else if (w.count == 0) {
      add(sum, start, lines, end - begin, one, [=](int i) { return static_cast<double>(a[i]) * b[i]; });
    } else if (whole_lines) {
      add(
          sum, start, lines, end - begin, [&](int i) { return w.at(i); },
          [=](int i) { return static_cast<double>(a[i]) * b[i]; });
    } else {
      add(sum, start, lines, end - begin, one, [&](int i) { return w.at(i) * (static_cast<double>(a[i]) * b[i]); });
    }
    partial(place + item) = ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
  }
  /// @param weight  of a line, given one of its entries
  template <class Weight, class Entry>
  KOKKOS_FORCEINLINE_FUNCTION void add(double (&sum)[2 * strip_width], int start, int lines, int width,
                                       const Weight& weight, const Entry& entry) const {
    const int stored = columns.stored, whole = width < strip_width ? 0 : strip_width;
    int l = 0, i = start;
    for (; l + 1 < lines && whole > 0; l += 2, i += 2 * stored) {  // two lines at once: two sums for each column
      const double w = weight(i), next = weight(i + stored);
      for (int k = 0; k < strip_width; ++k) {
        sum[k] += w * entry(i + k);
        sum[strip_width + k] += next * entry(i + stored + k);
      }
    }
    if (l < lines && whole > 0)
      for (int k = 0; k < strip_width; ++k) sum[k] += weight(i) * entry(i + k);
    l = 0, i = start;
    for (; l < lines && whole < width; ++l, i += stored)
      for (int k = whole; k < width; ++k) sum[k % strip_width] += weight(i) * entry(i + k);
    if (lines < lines_at_once)  // what is no whole line, of a vector that is not the scene's
      for (int k = start + lines * stored; k < size; ++k) sum[k % strip_width] += weight(k) * entry(k);
  }
};

/// The sums of some kernels, one after another: a kernel each, one copy to the host, and one reduction over all processes.
template <class Real>
std::vector<double> strip_sums(std::vector<StripSums<Real>> kernels) {
  int items = 0, sums = 0;
  for (StripSums<Real>& k : kernels) {
    k.place = items;
    items += k.items();
    sums += k.sums();
  }
  const SumSpace& space = sum_space(items);
  for (StripSums<Real>& k : kernels) {
    k.partial = space.device;
    Kokkos::parallel_for("softwet::sums", Items(0, k.items()), k);
  }
  const auto range = Kokkos::make_pair(0, items);
  Kokkos::deep_copy(Kokkos::subview(space.host, range), Kokkos::subview(space.device, range));
  const SumColumns& scene = sum_columns();
  StripTotals totals(scene.strips, sums);
  std::vector<double> all(sums, 0.0);
  int first = 0;
  for (const StripSums<Real>& k : kernels) {
    for (int i = 0; i < k.items(); ++i) {
      const int sum = first + i / k.strips() % k.sums();
      if (k.of_scene) totals.add(scene.first_strip + i % k.strips(), sum, space.host(k.place + i));
      if (!k.of_scene) all[sum] += space.host(k.place + i);
    }
    first += k.sums();
  }
  first = 0;
  for (const StripSums<Real>& k : kernels) {
    for (int sum = first; sum < first + k.sums() && k.of_scene; ++sum) all[sum] = totals.total(sum);
    first += k.sums();
  }
  return all;
}

}  // namespace softwet
