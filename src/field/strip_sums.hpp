// Sums over vectors in one fixed order, so that results depend neither on the number of threads nor on that of processes.
#pragma once

#include <stdexcept>

#include "field/range_factors.hpp"
#include "field/ranks.hpp"
#include "field/vector_space.hpp"
#include "memory/array.hpp"

namespace softwet {

/// Which strips of a sum a process has: its own ones, or a copy of all.
enum class StripsHere { own, all };

/// Sums by strip of columns. A strip has one order of its own, and the strips are added up in their order by all
/// processes, after each has sent its own to the others. So the number of processes does not matter.
class StripTotals {
 public:
  StripTotals(int strips, int sums, StripsHere here)
      : strips_(strips), told_(here == StripsHere::all), total_(static_cast<std::size_t>(strips) * sums) {}
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
  bool told_;
  std::vector<double> total_;
};

/// Scratch for partial sums: static, allocated once, grown when needed, released before Kokkos ends.
struct SumScratch {
  Array device;
  HostArray host;
};
inline void grow(SumScratch& scratch, std::size_t entries) {
  if (scratch.device.extent(0) >= entries) return;
  if (!scratch.device.data()) Kokkos::push_finalize_hook([&scratch] { scratch = {}; });
  scratch.device = Array(Kokkos::view_alloc("partial sums", Kokkos::WithoutInitializing), entries);
  scratch.host = mirror_of(scratch.device);
}
inline SumScratch& sum_scratch(std::size_t entries) {
  static SumScratch scratch;
  grow(scratch, entries);
  return scratch;
}

/// Whether a sum of squares comes behind the sums of products.
enum class SquareOfFirst { left_out, added };

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
  VectorSpace space;        ///< of the vectors
  bool whole_lines = true;  ///< all entries of a line have one weight
  int place = 0;            ///< of its partial sums
  Array partial = {};       ///< [lines][sum][own strip]

  /// @throws std::logic_error  where a vector of a shared space is not made of whole lines
  StripSums(const VectorSpace& space_, const Real* x_, int stride_, int count_, const std::vector<const Real*>& y_,
            SquareOfFirst square_, int size_, const RangeFactors& weights_ = {})
      : x(x_),
        stride(stride_),
        count(count_),
        y{},
        others(static_cast<int>(y_.size())),
        square(square_ == SquareOfFirst::added),
        size(size_),
        weights(weights_),
        space(space_) {
    if (space.shared && size % space.stored != 0) throw std::logic_error("a vector that is not made of whole lines");
    for (int m = 0; m < others; ++m) y[m] = y_[m];
    whole_lines = weights.multiples_of(space.stored);
  }

  KOKKOS_FUNCTION int strips() const { return space.last_strip - space.first_strip; }
  KOKKOS_FUNCTION int sums() const { return count * others + (square ? 1 : 0); }
  int items() const {
    const int lines = (size + space.stored - 1) / space.stored;
    return (lines + lines_at_once - 1) / lines_at_once * strips() * sums();
  }
  /// An item of a kernel with one sum, of the entries of a function in the place of x y.
  template <class Entry>
  KOKKOS_FORCEINLINE_FUNCTION void sum_of(int item, const Entry& entry) const {
    const int strip = item % strips(), first = item / strips() * lines_at_once;
    const int begin = space.begin + strip * strip_width;
    const int end = strip + 1 < strips() ? begin + strip_width : space.end;
    const int left = size / space.stored - first, lines = left < lines_at_once ? left : lines_at_once;
    double sum[2 * strip_width] = {};
    add(
        sum, first * space.stored + begin, lines, end - begin, [](int) { return 1.0; }, entry);
    store(item, sum);
  }
  KOKKOS_FORCEINLINE_FUNCTION void store(int item, const double (&sum)[2 * strip_width]) const {
    partial(place + item) = ((sum[0] + sum[1]) + (sum[2] + sum[3])) + ((sum[4] + sum[5]) + (sum[6] + sum[7]));
  }
  KOKKOS_FUNCTION void operator()(int item) const {
    const int strip = item % strips(), k = item / strips() % sums(), block = item / strips() / sums();
    const int begin = space.begin + strip * strip_width;
    const int end = strip + 1 < strips() ? begin + strip_width : space.end;
    const int first = block * lines_at_once, left = size / space.stored - first;
    const int start = first * space.stored + begin, lines = left < lines_at_once ? left : lines_at_once;
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
    store(item, sum);
  }
  /// @param weight  of a line, given one of its entries
  template <class Weight, class Entry>
  KOKKOS_FORCEINLINE_FUNCTION void add(double (&sum)[2 * strip_width], int start, int lines, int width,
                                       const Weight& weight, const Entry& entry) const {
    const int stored = space.stored, whole = width < strip_width ? 0 : strip_width;
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

inline StripsHere strips_here(const VectorSpace& space) { return space.shared ? StripsHere::own : StripsHere::all; }

/// Adds what a kernel has left, and the host has read, to totals from the sum `first` on.
template <class Real, class Partial>
void add_partial_sums(StripTotals& totals, const StripSums<Real>& k, int place, const Partial& partial, int first) {
  for (int i = 0; i < k.items(); ++i)
    totals.add(k.space.first_strip + i % k.strips(), first + i / k.strips() % k.sums(), partial(place + i));
}

/// The sums of some kernels on vectors of one space, one after another: a kernel each, one copy to the host, and one
/// reduction over all processes.
template <class Real>
std::vector<double> strip_sums(std::vector<StripSums<Real>> kernels) {
  int items = 0, sums = 0;
  for (StripSums<Real>& k : kernels) {
    k.place = items;
    items += k.items();
    sums += k.sums();
  }
  const SumScratch& scratch = sum_scratch(items);
  for (StripSums<Real>& k : kernels) {
    k.partial = scratch.device;
    Kokkos::parallel_for("softwet::sums", Items(0, k.items()), k);
  }
  const auto range = Kokkos::make_pair(0, items);
  Kokkos::deep_copy(Kokkos::subview(scratch.host, range), Kokkos::subview(scratch.device, range));
  const VectorSpace space = kernels.empty() ? alone : kernels.front().space;
  StripTotals totals(space.strips, sums, strips_here(space));
  int first = 0;
  for (const StripSums<Real>& k : kernels) {
    add_partial_sums(totals, k, k.place, scratch.host, first);
    first += k.sums();
  }
  std::vector<double> all(sums);
  for (int sum = 0; sum < sums; ++sum) all[sum] = totals.total(sum);
  return all;
}

}  // namespace softwet
