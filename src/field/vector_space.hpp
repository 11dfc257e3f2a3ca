// How vectors lie in lines of columns, as sums over them need it.
#pragma once

#include <stdexcept>

#include "spline/columns.hpp"

namespace softwet {

/// Vectors of one kind, and their parts: made of lines of columns that several processes share, each with some of them,
/// or numbers that each process has all of. A layout has the space of its vectors (`Layout::space`); solvers are given
/// theirs.
struct VectorSpace {
  int stored = strip_width, begin = 0, end = strip_width;  ///< columns of a line; the process's own are [begin, end)
  int first_strip = 0, last_strip = 1, strips = 1;
  int first_function = 0, functions = strip_width;  ///< of the first own column less its place; in a line of the patch
  bool shared = false;                              ///< else each process has all of a vector, of any size

  constexpr VectorSpace() = default;
  /// Vectors on columns that were cut for processes; on others all is the process's own.
  /// @throws std::logic_error  where columns were cut without strips
  explicit VectorSpace(const Columns& c) {
    if (c.stored() == 0) return;
    if (c.elements.strips == 0) throw std::logic_error("columns that were cut without strips have no sums");
    stored = c.stored();
    begin = c.begin;
    end = c.end;
    first_strip = c.elements.first_strip;
    last_strip = c.elements.last_strip;
    strips = c.elements.strips;
    first_function = c.first_function[c.rank] - c.begin;
    functions = c.first_function.back();
    shared = true;
  }
};

/// Vectors that each process has all of.
inline constexpr VectorSpace alone{};

}  // namespace softwet
