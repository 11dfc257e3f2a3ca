// The Jacobian with frozen geometry as a sparse matrix, read off a few coloured Jacobian-vector products.
#pragma once

#include <vector>

#include "field/ghosts.hpp"
#include "solver/preconditioner.hpp"

namespace softwet {

/// Compressed columns of the matrix over all stored unknowns; prescribed and ghost entries are identity rows.
/// Filled colour by colour (src/solver/colours.hpp).
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
  void add_column(const Layout<D>& layout, const int* centre);

  std::vector<int> start_, row_;
  std::vector<double> values_, mask_;
  std::vector<std::vector<Column>> columns_of_colour_;
  Array seed_, product_;
};

}  // namespace softwet
