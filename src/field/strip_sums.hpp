// Sums over vectors in one fixed order, so that results depend on the number neither of threads nor of processes.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <type_traits>

#include "field/lane_sums.hpp"
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
  /// Copies the first so many numbers when all kernels that were started before have run, and waits for them.
  void copy_to_host(std::size_t count) const {
    const auto range = Kokkos::make_pair(std::size_t(0), count);
    if constexpr (!on_host) Kokkos::deep_copy(Exec(), Kokkos::subview(host, range), Kokkos::subview(device, range));
    Exec().fence("softwet: sums for the host");  // one wait, where a copy without Exec() is three
  }
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

/// Sums over one strip of some lines, in double precision, whatever the vectors are: of x_k(i) y(i) for several vectors
/// x_k that follow each other in memory and for each y, and of y(i)^2 of the first y behind them; each entry times its
/// weight. Partial sums are [block of lines][sum][own strip].   Tested: tests/unit/field/test_lane_sums.cpp
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
  int blocks() const {
    const int lines = (size + space.stored - 1) / space.stored;
    return (lines + lines_at_once - 1) / lines_at_once;
  }
  int items() const { return blocks() * strips() * sums(); }

  /// Adds an item of a kernel with one sum, of the entries of a function in the place of x y.
  template <class Sum, class Entry>
  KOKKOS_FORCEINLINE_FUNCTION void add_entries(int item, Sum& sum, const Entry& entry) const {
    add_lines(
        sum, lines_of(item % strips(), item / strips()), [](int) { return 1.0; }, entry);
  }
  template <class Sum>
  KOKKOS_FORCEINLINE_FUNCTION void add(int item, Sum& sum) const {
    const int k = item / strips() % sums();
    const Lines part = lines_of(item % strips(), item / strips() / sums());
    const bool pair = k < count * others;
    const Real *a = pair ? x + std::int64_t(k / others) * stride : y[0], *b = y[pair ? k % others : 0];
    const RangeFactors& w = weights;
    const auto one = [](int) { return 1.0; };
    if (!b) {
      add_lines(sum, part, one, [=](int i) { return static_cast<double>(a[i]); });
    } else if (w.count == 0) {
      add_lines(sum, part, one, [=](int i) { return static_cast<double>(a[i]) * b[i]; });
    } else if (whole_lines || std::is_same_v<Sum, OneLane>) {
      add_lines(
          sum, part, [&](int i) { return w.at(i); }, [=](int i) { return static_cast<double>(a[i]) * b[i]; });
    } else {
      add_lines(sum, part, one, [&](int i) { return w.at(i) * (static_cast<double>(a[i]) * b[i]); });
    }
  }

 private:
  struct Lines {
    int start, count, width;
  };
  KOKKOS_FORCEINLINE_FUNCTION Lines lines_of(int strip, int block) const {
    const int begin = space.begin + strip * strip_width;
    const int end = strip + 1 < strips() ? begin + strip_width : space.end;
    const int first = block * lines_at_once, left = size / space.stored - first;
    return {first * space.stored + begin, left < lines_at_once ? left : lines_at_once, end - begin};
  }
  /// @param weight  of a line, given one of its entries
  template <class Weight, class Entry>
  KOKKOS_FORCEINLINE_FUNCTION void add_lines(double (&sum)[sum_lanes], const Lines& part, const Weight& weight,
                                             const Entry& entry) const {
    const int start = part.start, lines = part.count, width = part.width;
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
    if (lines < lines_at_once)  // entries beyond whole lines, of a vector that is not the scene's
      for (int k = start + lines * stored; k < size; ++k) sum[k % strip_width] += weight(k) * entry(k);
  }
  /// One of several sums, with a weight per entry. Entries beyond whole columns and lines belong to the sums of even
  /// lines.
  template <class Weight, class Entry>
  KOKKOS_FORCEINLINE_FUNCTION void add_lines(OneLane& lane, const Lines& part, const Weight& weight,
                                             const Entry& entry) const {
    const int lines = part.count, stored = space.stored, whole = part.width < strip_width ? 0 : strip_width;
    const int column = lane.column(), odd = lane.first_line(), end = part.start + lines * stored;
    if (whole > 0)
      add_places(lane, (lines - odd + 1) / 2, weight, entry,
                 [&](int m) { return part.start + (odd + 2 * m) * stored + column; });
    if (odd) return;
    const int beyond = (part.width - whole - column + strip_width - 1) / strip_width;  // of this lane's columns
    add_places(lane, lines * beyond, weight, entry,
               [&](int m) { return part.start + m / beyond * stored + whole + column + m % beyond * strip_width; });
    if (lines < lines_at_once)
      for (int k = end; k < size; ++k)
        if (k % strip_width == column) lane.sum += weight(k) * entry(k);
  }
  /// So many entries in their order. Many are fetched at once, since few threads have to wait for memory.
  template <class Weight, class Entry, class Place>
  KOKKOS_FORCEINLINE_FUNCTION static void add_places(OneLane& lane, int count, const Weight& weight, const Entry& entry,
                                                     const Place& place) {
    constexpr int together = 16;
    int m = 0;
    while (m + together <= count)
      for (int j = 0; j < together; ++j, ++m) lane.sum += weight(place(m)) * entry(place(m));
    for (; m < count; ++m) lane.sum += weight(place(m)) * entry(place(m));
  }
};

inline StripsHere strips_here(const VectorSpace& space) { return space.shared ? StripsHere::own : StripsHere::all; }

/// Whether a device adds up so many partial sums, in a second kernel. The host reads and adds up a few thousand in the
/// time of its launch (docs/devices.md).
inline bool adds_on_device(std::int64_t partial_sums) { return !host_algorithms && partial_sums > 4096; }
template <class Real>
bool adds_blocks(const StripSums<Real>& k) {
  return adds_on_device(k.items());
}
/// How many numbers of a kernel come to the host: partial sums, or sums of strips.
template <class Real>
int numbers_of(const StripSums<Real>& k) {
  return adds_blocks(k) ? k.strips() * k.sums() : k.items();
}
/// Starts the kernels that leave them.
/// @param blocks  room for partial sums that do not come to the host
template <class Real>
void start_strip_sums(const StripSums<Real>& k, const Array& numbers, const Array& blocks) {
  start_sums("softwet::sums", k, k.items(), adds_blocks(k) ? blocks : numbers);
  if (adds_blocks(k)) AddBlocks{blocks, k.blocks(), numbers}.start();
}
/// Adds so many numbers of a kernel, which the host has read, to totals from the sum `first` on.
template <class Real>
void add_partial_sums(StripTotals& totals, const StripSums<Real>& k, const double* partial, int numbers, int first) {
  for (int i = 0; i < numbers; ++i)
    totals.add(k.space.first_strip + i % k.strips(), first + i / k.strips() % k.sums(), partial[i]);
}

/// The sums of some kernels on vectors of one space, one after another: a kernel each, or two on a device, one copy to
/// the host, and one reduction over all processes.
template <class Real>
std::vector<double> strip_sums(const std::vector<StripSums<Real>>& kernels) {
  int numbers = 0, blocks = 0, sums = 0;
  for (const StripSums<Real>& k : kernels) {
    numbers += numbers_of(k);
    if (adds_blocks(k)) blocks = std::max(blocks, k.items());
    sums += k.sums();
  }
  const SumScratch& scratch = sum_scratch(std::size_t(numbers) + blocks);
  const auto part = [&](int begin, int count) {
    return Kokkos::subview(scratch.device, Kokkos::make_pair(begin, begin + count));
  };
  int place = 0;
  for (const StripSums<Real>& k : kernels) {
    start_strip_sums(k, part(place, numbers_of(k)), part(numbers, blocks));
    place += numbers_of(k);
  }
  scratch.copy_to_host(numbers);
  const VectorSpace space = kernels.empty() ? alone : kernels.front().space;
  StripTotals totals(space.strips, sums, strips_here(space));
  int first = 0;
  place = 0;
  for (const StripSums<Real>& k : kernels) {
    add_partial_sums(totals, k, scratch.host.data() + place, numbers_of(k), first);
    place += numbers_of(k);
    first += k.sums();
  }
  std::vector<double> all(sums);
  for (int sum = 0; sum < sums; ++sum) all[sum] = totals.total(sum);
  return all;
}

}  // namespace softwet
