// Dense blocks of LU factors, stored for products with vectors in half, single or double precision.
#pragma once

#include <Kokkos_Macros.hpp>
#include <cstdint>
#include <type_traits>

#include "solver/direct/host/dense_product.hpp"

namespace softwet {

/// A number of 16 bits (IEEE 754 binary16: 11 significant bits, 6e-8 to 65504).
struct Half {
  std::uint16_t bits;
};

#if defined(__F16C__) && (defined(KOKKOS_ARCH_AVX2) || defined(KOKKOS_ARCH_AVX512XEON))
#define SOFTWET_HALF  // the processor converts it
#endif

/// What lagged factors are stored in. A processor that does not convert half precision by itself would lose more than the
/// smaller numbers save.
#ifdef SOFTWET_HALF
using FactorNumber = Half;
#else
using FactorNumber = float;
#endif

/// A matrix A in memory that somebody else owns. Half precision has few exponents, so rows and columns are scaled by powers
/// of two that bring the largest entry of each near the largest number; entries 2^28 times smaller than that begin to lose
/// digits, and 2^39 times smaller ones are lost. Products are summed in one fixed order, in single precision; in double
/// precision where the block is stored so.
template <class Number>
class PackedBlock {
 public:
  /// The numbers of vectors, sums, and of the matrix before it is stored.
  using Work = std::conditional_t<std::is_same_v<Number, double>, double, float>;

  PackedBlock() = default;
  PackedBlock(int rows, int columns) : rows_(rows), columns_(columns) {}

  std::size_t bytes() const;
  /// Takes bytes() of memory, on a multiple of 64.
  void place(std::byte* memory);
  void store(const DenseMatrix<const Work>& a);
  /// y = A x and y -= A x. Vectors y have padded(rows) numbers; scratch has `columns`.
  void multiply(const Work* x, Work* y, Work* scratch) const;
  void subtract(const Work* x, Work* y, Work* scratch) const;

  /// Rows with those that fill the last pack.
  static int padded(int rows);

 private:
  static constexpr bool scaled = std::is_same_v<Number, Half>;
  void scale_rows(const DenseMatrix<const Work>& a) requires scaled;
  template <int Sign>
  void product(const Work* x, Work* y, Work* scratch) const;

  int rows_ = 0, columns_ = 0;
  Number* numbers_ = nullptr;                             ///< strip by strip of rows, in each column by column
  float *row_scale_ = nullptr, *column_scale_ = nullptr;  ///< of half precision
};

}  // namespace softwet
