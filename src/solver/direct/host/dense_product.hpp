// Products and inverses of dense matrices on one thread of the host. They allocate nothing.
#pragma once

#include <cstddef>
#include <type_traits>

namespace softwet {

/// A matrix in single or double precision, column by column, `stride` numbers from one column to the next.
template <class Number>
struct DenseMatrix {
  Number* data;
  int rows, columns, stride;
  Number* column(int j) const { return data + std::ptrdiff_t(j) * stride; }
  DenseMatrix part(int row, int first_column, int row_count, int column_count) const {
    return {column(first_column) + row, row_count, column_count, stride};
  }
  operator DenseMatrix<const Number>() const { return {data, rows, columns, stride}; }
};
/// Arguments that may be matrices of numbers that change, of the precision that the scratch memory has.
template <class Number>
using DenseInput = DenseMatrix<const std::type_identity_t<Number>>;
template <class Number>
using DenseOutput = DenseMatrix<std::type_identity_t<Number>>;

/// Numbers of scratch memory that a product needs.
std::size_t product_scratch();

/// c += sign a b. The blocking is that of Goto and van de Geijn 2008: parts of a and b are copied in the order in which
/// the innermost loop reads them.
template <class Number>
void add_product(std::type_identity_t<Number> sign, const DenseInput<Number>& a, const DenseInput<Number>& b,
                 const DenseOutput<Number>& c, Number* scratch);

/// Numbers of scratch memory that an inversion needs.
std::size_t inversion_scratch(int size);

/// inverse = a^-1 by Gauss-Jordan elimination with partial pivoting; a is overwritten. Panels of columns are eliminated one
/// by one, the other columns by products. The inverse of a singular matrix has entries that are not finite.
template <class Number>
void invert(const DenseOutput<Number>& a, const DenseOutput<Number>& inverse, Number* scratch);

}  // namespace softwet
