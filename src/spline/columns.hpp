// Columns of control points along the first axis: strips of them, and those that one of several processes stores.
#pragma once

#include "spline/axis.hpp"

namespace softwet {

/// Elements of a strip. The last strip also has the remaining elements.
inline constexpr int strip_width = 4;

/// Elements that follow each other: the stored element l is element l + shift of the axis.
struct ElementRun {
  int begin = 0, end = 0, shift = 0;
};

/// The elements along the first axis that a process runs. It sums the integrals of the stored elements [own_begin,
/// own_end), in the strips [first_strip, last_strip) of all `strips`. Strips 0: nothing was cut.
struct ElementColumns {
  ElementRun run[2];
  int runs = 0;
  int own_begin = 0, own_end = 0;
  int first_strip = 0, last_strip = 0, strips = 0;
};

/// All elements of an axis, in one run.
ElementColumns whole_elements(int elements);

/// The columns of an axis that a process stores: its own ones, [begin, end) in storage, and copies of `beside`
/// neighbouring columns on both sides. A process owns whole strips. The copies behind the end of a periodic axis count
/// as columns of their own and belong to the last process.
///
/// The elements of a process are all those that its own control points live on, so that nothing has to be added up
/// between processes. Around a periodic axis the first process keeps the last columns apart, behind its others. Its
/// last elements have control points of their own there, and what these get beyond the end is added to the first
/// columns. A single process does the same, so the order is the same.
struct Columns {
  int rank = 0, ranks = 1;
  std::vector<int> function;  ///< of each stored column; empty: nothing was cut
  int begin = 0, end = 0, beside = 0;
  std::vector<int> first_function;  ///< of each rank, and the end
  ElementColumns elements;

  int stored() const { return static_cast<int>(function.size()); }
  bool own(int column) const { return column >= begin && column < end; }
};

/// The part of one of `ranks` processes; at most `most_ranks` have one. At least `degree` neighbouring columns are
/// stored on each side.
Columns cut_columns(const Axis&, int rank, int ranks, int beside = 0);
int most_ranks(const Axis&);

/// The part of an axis that was cut before these functions. It has no strips.
Columns cut_before(const Axis&, int rank, const std::vector<int>& first_function, int beside);

/// Where each function of an axis is stored, an own column before a copy; -1: nowhere. A periodic axis repeats itself
/// behind its own functions; these have the place of what they repeat.
std::vector<int> places_of_functions(const Axis&, const Columns&);

}  // namespace softwet
