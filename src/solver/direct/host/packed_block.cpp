#include "solver/direct/host/packed_block.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>

#include "solver/direct/host/host_pack.hpp"

#ifdef SOFTWET_HALF
#include <immintrin.h>
#endif

namespace softwet {

#ifdef SOFTWET_HALF
constexpr int to_nearest = _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC;
#ifdef KOKKOS_ARCH_AVX512XEON
static HostPack<float> load(const Half* from) {
  return HostPack<float>(_mm512_cvtph_ps(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from))));
}
static void store(const HostPack<float>& x, Half* to) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm512_cvtps_ph(static_cast<__m512>(x), to_nearest));
}
#else
static HostPack<float> load(const Half* from) {
  return HostPack<float>(_mm256_cvtph_ps(_mm_loadu_si128(reinterpret_cast<const __m128i*>(from))));
}
static void store(const HostPack<float>& x, Half* to) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(to), _mm256_cvtps_ph(static_cast<__m256>(x), to_nearest));
}
#endif
#endif

namespace {

constexpr int packs_in_strip = 4;  ///< the last strip of a block may have fewer
constexpr float top = 32768;       ///< scaled entries lie below; the largest number of half precision is 65504

/// The pack at the end of a column, of which `left` numbers exist; the others are zero.
template <class Work>
HostPack<Work> load_some(const Work* from, int left) {
  if (left >= host_lanes<Work>) return load(from);
  Work part[host_lanes<Work>] = {};
  for (int l = 0; l < left; ++l) part[l] = from[l];
  return load(part);
}

/// The power of two, 2^110 at most, that brings a number to [0.5, 1); one for zero and for what is not finite.
float to_unit(float size) {
  const int exponent = static_cast<int>(std::bit_cast<std::uint32_t>(size) >> 23 & 0xffu);
  if (exponent == 0 || exponent == 255) return 1;
  return std::bit_cast<float>(std::uint32_t(std::clamp(253 - exponent, 1, 237)) << 23);
}

/// Adds the products of a strip, `Packs` packs high, with x to `sum`. Several columns are summed side by side, so that one
/// sum need not wait for the other.
template <int Packs, class Number, class Work>
void add_strip(const Number* a, int columns, const Work* x, HostPack<Work>* sum) {
  using Pack = HostPack<Work>;
  constexpr int side = Packs == 1 ? 8 : Packs == 2 ? 4 : 2, lanes = host_lanes<Work>, step = Packs * lanes;
  Pack part[side][Packs];
  for (int s = 0; s < side; ++s)
    for (int p = 0; p < Packs; ++p) part[s][p] = Pack(Work(0));
  int j = 0;
  for (; j + side <= columns; j += side, a += side * step)
    for (int s = 0; s < side; ++s) {
      const Pack factor(x[j + s]);
      for (int p = 0; p < Packs; ++p) part[s][p] = part[s][p] + load(a + s * step + p * lanes) * factor;
    }
  for (; j < columns; ++j, a += step) {
    const Pack factor(x[j]);
    for (int p = 0; p < Packs; ++p) part[0][p] = part[0][p] + load(a + p * lanes) * factor;
  }
  for (int width = side / 2; width > 0; width /= 2)
    for (int s = 0; s < width; ++s)
      for (int p = 0; p < Packs; ++p) part[s][p] = part[s][p] + part[s + width][p];
  for (int p = 0; p < Packs; ++p) sum[p] = part[0][p];
}

template <class Number, class Work>
void add_strip(int packs, const Number* a, int columns, const Work* x, HostPack<Work>* sum) {
  switch (packs) {
    case 1:
      return add_strip<1>(a, columns, x, sum);
    case 2:
      return add_strip<2>(a, columns, x, sum);
    case 3:
      return add_strip<3>(a, columns, x, sum);
    default:
      return add_strip<packs_in_strip>(a, columns, x, sum);
  }
}

constexpr std::size_t aligned(std::size_t bytes) { return (bytes + 63) / 64 * 64; }

}  // namespace

template <class Number>
int PackedBlock<Number>::padded(int rows) {
  constexpr int lanes = host_lanes<Work>;
  return (rows + lanes - 1) / lanes * lanes;
}

template <class Number>
std::size_t PackedBlock<Number>::bytes() const {
  const std::size_t scales = aligned(sizeof(float) * padded(rows_)) + aligned(sizeof(float) * columns_);
  return aligned(sizeof(Number) * padded(rows_) * columns_) + (scaled ? scales : 0);
}

template <class Number>
void PackedBlock<Number>::place(std::byte* memory) {
  numbers_ = reinterpret_cast<Number*>(memory);
  memory += aligned(sizeof(Number) * padded(rows_) * columns_);
  row_scale_ = reinterpret_cast<float*>(memory);
  column_scale_ = reinterpret_cast<float*>(memory + aligned(sizeof(float) * padded(rows_)));
}

template <class Number>
void PackedBlock<Number>::store(const DenseMatrix<const Work>& a) {
  using Pack = HostPack<Work>;
  constexpr int lanes = host_lanes<Work>;
  const int height = padded(rows_);
  if constexpr (scaled) scale_rows(a);
  for (int j = 0; j < columns_; ++j) {
    const Work* from = a.column(j);
    Pack factor(Work(1));
    if constexpr (scaled) {
      Pack largest(0.0f);
      for (int i = 0; i < rows_; i += lanes)
        largest = Kokkos::max(largest, Kokkos::abs(load_some(from + i, rows_ - i)) * load(row_scale_ + i));
      float each[lanes];
      softwet::store(largest, each);
      const float unit = to_unit(*std::max_element(each, each + lanes) / top);
      column_scale_[j] = 1 / unit;
      factor = Pack(unit);
    }
    for (int first = 0; first < height; first += packs_in_strip * lanes) {
      const int strip = std::min(packs_in_strip * lanes, height - first);
      Number* to = numbers_ + std::size_t(first) * columns_ + std::size_t(j) * strip;
      for (int i = first; i < first + strip; i += lanes, to += lanes) {
        Pack x = load_some(from + i, rows_ - i);
        if constexpr (scaled) x = x * load(row_scale_ + i) * factor;
        softwet::store(x, to);
      }
    }
  }
  if constexpr (scaled)
    for (int i = 0; i < height; ++i) row_scale_[i] = 1 / row_scale_[i];
}

/// Factors that bring the largest entry of each row below the top.
template <class Number>
void PackedBlock<Number>::scale_rows(const DenseMatrix<const Work>& a) requires scaled {
  std::fill(row_scale_, row_scale_ + padded(rows_), 0.0f);
  for (int j = 0; j < columns_; ++j) {
    const float* from = a.column(j);
    for (int i = 0; i < rows_; i += host_lanes<float>)
      softwet::store<float>(Kokkos::max(load(row_scale_ + i), Kokkos::abs(load_some(from + i, rows_ - i))),
                            row_scale_ + i);
  }
  for (int i = 0; i < padded(rows_); ++i) row_scale_[i] = top * to_unit(row_scale_[i]);
}

template <class Number>
template <int Sign>
void PackedBlock<Number>::product(const Work* x, Work* y, Work* scratch) const {
  constexpr int lanes = host_lanes<Work>;
  if (columns_ == 0) {  // nothing was stored, not even the scales of the rows
    if (Sign > 0) std::fill(y, y + padded(rows_), Work(0));
    return;
  }
  if constexpr (scaled) {
    for (int j = 0; j < columns_; ++j) scratch[j] = x[j] * column_scale_[j];
    x = scratch;
  }
  const int height = padded(rows_);
  for (int first = 0; first < height; first += packs_in_strip * lanes) {
    const int packs = std::min(packs_in_strip, (height - first) / lanes);
    HostPack<Work> sum[packs_in_strip];
    add_strip(packs, numbers_ + std::size_t(first) * columns_, columns_, x, sum);
    for (int p = 0; p < packs; ++p) {
      Work* to = y + first + p * lanes;
      if constexpr (scaled) sum[p] = sum[p] * load(row_scale_ + first + p * lanes);
      softwet::store<Work>(Sign > 0 ? sum[p] : load(to) - sum[p], to);
    }
  }
}

template <class Number>
void PackedBlock<Number>::multiply(const Work* x, Work* y, Work* scratch) const {
  product<1>(x, y, scratch);
}
template <class Number>
void PackedBlock<Number>::subtract(const Work* x, Work* y, Work* scratch) const {
  product<-1>(x, y, scratch);
}

template class PackedBlock<float>;
template class PackedBlock<double>;
#ifdef SOFTWET_HALF
template class PackedBlock<Half>;
#endif

}  // namespace softwet
