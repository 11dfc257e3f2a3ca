// The Jacobian with frozen geometry as a sparse matrix, read off a few coloured Jacobian-vector products.
#pragma once

#include <vector>

#include "field/ghosts.hpp"
#include "solver/preconditioner.hpp"

namespace softwet {

/// Compressed columns of the matrix over all stored unknowns; prescribed and ghost entries are identity rows.
/// Control points further apart than the degree do not couple, so columns of one colour share no row and one product
/// yields all of them: (2 degree + 1)^D colours per component.
template <int D>
class StencilMatrix {
 public:
  StencilMatrix(const Layout<D>& layout, const ConstArray& mask);

  /// Fills `values` from products.
  void fill(const Product& product);

  int size() const { return static_cast<int>(start_.size()) - 1; }
  const std::vector<int>& start() const { return start_; }
  const std::vector<int>& row() const { return row_; }
  const std::vector<double>& values() const { return values_; }

 private:
  struct Column {
    int index, first_entry, entries;
  };
  std::vector<int> colour_of_axis(const Axis& axis, int extent, int& colours) const;
  void add_column(const std::vector<Box<D>>& all, const Layout<D>& layout, std::size_t component, int point);

  std::vector<int> start_, row_;
  std::vector<double> values_, mask_;
  std::vector<std::vector<Column>> columns_of_colour_;
  std::vector<int> colour_of_column_;
};

}  // namespace softwet
