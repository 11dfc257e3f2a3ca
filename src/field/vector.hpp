// Vector algebra with sums in one fixed order, so that results do not depend on the number of threads.
#pragma once

#include <cmath>

#include "field/array.hpp"
#include "field/ranks.hpp"
#include "spline/columns.hpp"

namespace softwet {

/// The vector operations below, for vectors of any precision.
namespace any_precision {

template <class Real>
void combine(const ArrayOf<Real>& y, Real a, const ConstArrayOf<Real>& x, Real b) {
  Kokkos::parallel_for(
      "softwet::combine", Kokkos::RangePolicy<Exec>(0, y.extent(0)),
      KOKKOS_LAMBDA(int i) { y(i) = a * x(i) + (b == 0 ? Real(0) : b * y(i)); });
}

template <class Real>
void add_scaled(const ArrayOf<Real>& y, int offset, Real a, const ConstArrayOf<Real>& x) {
  Kokkos::parallel_for(
      "softwet::add_scaled", Kokkos::RangePolicy<Exec>(0, x.extent(0)),
      KOKKOS_LAMBDA(int i) { y(offset + i) += a * x(i); });
}

template <class Real>
void multiply(const ArrayOf<Real>& y, const ConstArray& x) {
  Kokkos::parallel_for(
      "softwet::multiply", Kokkos::RangePolicy<Exec>(0, y.extent(0)),
      KOKKOS_LAMBDA(int i) { y(i) *= static_cast<Real>(x(i)); });
}

template <class To, class From>
void convert(const ArrayOf<To>& y, const ConstArrayOf<From>& x) {
  Kokkos::parallel_for(
      "softwet::convert", Kokkos::RangePolicy<Exec>(0, y.extent(0)),
      KOKKOS_LAMBDA(int i) { y(i) = static_cast<To>(x(i)); });
}

}  // namespace any_precision

/// y = a x + b y; with b = 0 the old y is not read.
inline void combine(const Array& y, double a, const ConstArray& x, double b) {
  any_precision::combine<double>(y, a, x, b);
}
inline void combine(const ArrayOf<float>& y, double a, const ConstArrayOf<float>& x, double b) {
  any_precision::combine<float>(y, static_cast<float>(a), x, static_cast<float>(b));
}

/// y(i) += a x(i) from offset on, for all i of x.
inline void add_scaled(const Array& y, int offset, double a, const ConstArray& x) {
  any_precision::add_scaled<double>(y, offset, a, x);
}
inline void add_scaled(const ArrayOf<float>& y, int offset, double a, const ConstArrayOf<float>& x) {
  any_precision::add_scaled<float>(y, offset, static_cast<float>(a), x);
}

/// y(i) *= x(i)
inline void multiply(const Array& y, const ConstArray& x) { any_precision::multiply<double>(y, x); }
inline void multiply(const ArrayOf<float>& y, const ConstArray& x) { any_precision::multiply<float>(y, x); }

/// y = x, rounded where y is of single precision.
inline void convert(const Array& y, const ConstArray& x) { Kokkos::deep_copy(Exec(), y, x); }
inline void convert(const ArrayOf<float>& y, const ConstArray& x) { any_precision::convert<float, double>(y, x); }
inline void convert(const Array& y, const ConstArrayOf<float>& x) { any_precision::convert<double, float>(y, x); }

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
/// that follow each other in memory, and of y(i)^2 behind them.
template <class Real>
struct StripSums {
  static constexpr int lines_at_once = 64;
  const Real *x, *y;  ///< y null: the sum of x
  int stride, count;  ///< of the x_k
  bool square;        ///< of y too
  SumColumns columns;
  int size;
  Array partial = {};  ///< [lines][sum][own strip]

  int strips() const { return columns.last_strip - columns.first_strip; }
  int sums() const { return count + (square ? 1 : 0); }
  int items() const {
    const int lines = (size + columns.stored - 1) / columns.stored;
    return (lines + lines_at_once - 1) / lines_at_once * strips() * sums();
  }
  KOKKOS_FUNCTION void operator()(int item) const {
    const int strips = columns.last_strip - columns.first_strip, strip = item % strips;
    const int each = square ? count + 1 : count, k = item / strips % each, block = item / strips / each;
    const int begin = columns.begin + strip * strip_width, end = strip + 1 < strips ? begin + strip_width : columns.end;
    const int first = block * lines_at_once, left = size / columns.stored - first;
    const int start = first * columns.stored + begin, lines = left < lines_at_once ? left : lines_at_once;
    const Real *a = k < count ? x + std::int64_t(k) * stride : y, *b = y;
    double sum[2 * strip_width] = {};
    if (b) {
      add(sum, start, lines, end - begin, [=](int i) { return static_cast<double>(a[i]) * b[i]; });
    } else {
      add(sum, start, lines, end - begin, [=](int i) { return static_cast<double>(a[i]); });
    }
    partial(item) = ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
  }
  template <class Entry>
  KOKKOS_FORCEINLINE_FUNCTION void add(double (&sum)[2 * strip_width], int start, int lines, int width,
                                       const Entry& entry) const {
    const int stored = columns.stored, whole = width < strip_width ? 0 : strip_width;
    int l = 0, i = start;
    for (; l + 1 < lines && whole > 0; l += 2, i += 2 * stored)  // two lines at once: two sums for each column
      for (int k = 0; k < strip_width; ++k) {
        sum[k] += entry(i + k);
        sum[strip_width + k] += entry(i + stored + k);
      }
    if (l < lines && whole > 0)
      for (int k = 0; k < strip_width; ++k) sum[k] += entry(i + k);
    l = 0, i = start;
    for (; l < lines && whole < width; ++l, i += stored)
      for (int k = whole; k < width; ++k) sum[k % strip_width] += entry(i + k);
    if (lines < lines_at_once)  // what is no whole line, of a vector that is not the scene's
      for (int k = start + lines * stored; k < size; ++k) sum[k % strip_width] += entry(k);
  }
};

/// The sums of vectors of `size` entries: one kernel, one copy to the host, and one reduction over all processes.
template <class Real>
std::vector<double> strip_sums(const Real* x, int stride, int count, const Real* y, bool square, int size) {
  const SumColumns& scene = sum_columns();
  const bool of_scene = scene.stored > 0 && size % scene.stored == 0;
  const SumColumns alone{strip_width, 0, strip_width, 0, 1, 1, 0, strip_width};
  StripSums<Real> kernel{x, y, stride, count, square, of_scene ? scene : alone, size};
  const int items = kernel.items(), strips = kernel.strips(), sums = kernel.sums();
  const SumSpace& space = sum_space(items);
  kernel.partial = space.device;
  Kokkos::parallel_for("softwet::sums", Kokkos::RangePolicy<Exec>(0, items), kernel);
  const auto range = Kokkos::make_pair(0, items);
  Kokkos::deep_copy(Kokkos::subview(space.host, range), Kokkos::subview(space.device, range));
  std::vector<double> all(sums);
  if (!of_scene) {
    for (int i = 0; i < items; ++i) all[i / strips % sums] += space.host(i);
    return all;
  }
  StripTotals totals(scene.strips, sums);
  for (int i = 0; i < items; ++i) totals.add(scene.first_strip + i % strips, i / strips % sums, space.host(i));
  for (int k = 0; k < sums; ++k) all[k] = totals.total(k);
  return all;
}

template <class Real>
double strip_sum(const ConstArrayOf<Real>& x, const ConstArrayOf<Real>& y) {
  return strip_sums<Real>(x.data(), 0, 1, y.data(), false, static_cast<int>(x.extent(0)))[0];
}

inline double dot(const ConstArray& x, const ConstArray& y) { return strip_sum<double>(x, y); }
inline double dot(const ConstArrayOf<float>& x, const ConstArrayOf<float>& y) { return strip_sum<float>(x, y); }
inline double total(const ConstArray& x) { return strip_sum<double>(x, {}); }
inline double norm(const ConstArray& x) { return std::sqrt(dot(x, x)); }
inline double norm(const ConstArrayOf<float>& x) { return std::sqrt(dot(x, x)); }

/// Part [first, last) of a vector.
inline ConstArray part(const ConstArray& x, int first, int last) {
  return Kokkos::subview(x, Kokkos::make_pair(first, last));
}

}  // namespace softwet
