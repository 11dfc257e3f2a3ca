// Blocks of neighbouring lines of values: the items of kernels on the host.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "field/layout.hpp"

namespace softwet {

/// Components behind each other, cut into blocks of lines along the first axis. A block has a range of places along each
/// of the other axes. Ends of blocks never part the values that end ties connect (time/masses/end_ties.hpp): the first two and the
/// last two of an axis, and those below and on the wall or the joint of the solid.
template <int D>
struct LineBlocks {
  static constexpr int widest = 32, narrowest = 8;  ///< about, in lines along an axis

  int extent[D] = {}, nodes = 1;             ///< of a component
  int blocks[D] = {};                        ///< along each axis; 1 along the first
  Kokkos::View<const int*, Exec> starts[D];  ///< first place of each block, and the end

  LineBlocks() = default;
  LineBlocks(const Layout<D>& l, bool velocities) {
    const int joint = l.axis[D - 1].joint(), joint_row = joint > 0 ? l.axis[D - 1].span(joint) : 0;
    for (int d = 0; d < D; ++d) extent[d] = d < D - 1 ? l.extent(d) : velocities ? l.rows : l.fluid_rows();
    const std::array<int, D> parts = parts_for(Exec().concurrency(), velocities ? D : 1);
    for (int d = 0; d < D; ++d) {
      nodes *= extent[d];
      std::vector<int> places{0};
      for (int left = parts[d]; places.back() < extent[d]; left = std::max(left - 1, 1))
        places.push_back(d < D - 1 ? end_behind(places.back(), extent[d], left, 0, 0)
                                   : end_behind(places.back(), extent[d], left, l.wall_row, joint_row));
      blocks[d] = static_cast<int>(places.size()) - 1;
      starts[d] = to_device<Kokkos::View<int*, Exec>>(places, "line blocks");
    }
  }

  int count() const {
    int all = 1;
    for (int d = 0; d < D; ++d) all *= blocks[d];
    return all;
  }
  /// The block of value i.
  int of(int i) const {
    int block = i / nodes * count(), step = 1, rest = i % nodes;
    for (int d = 0; d < D; ++d) {
      int b = 0;
      while (starts[d](b + 1) <= rest % extent[d]) ++b;
      block += b * step;
      step *= blocks[d];
      rest /= extent[d];
    }
    return block;
  }
  /// Places [first, last) of a block along an axis.
  void range(int block, int axis, int& first, int& last) const {
    for (int d = 0; d < axis; ++d) block /= blocks[d];
    first = starts[axis](block % blocks[axis]);
    last = starts[axis](block % blocks[axis] + 1);
  }
  /// Calls body(first value, first node) for each line of a block.
  template <class Body>
  void for_lines(int block, const Body& body) const {
    const int component = block / count() * nodes;
    int first[3] = {}, last[3] = {1, 1, 1};
    for (int d = 1; d < D; ++d) range(block, d, first[d], last[d]);
    for (int z = first[2]; z < last[2]; ++z)
      for (int y = first[1]; y < last[1]; ++y) {
        const int node = (D == 3 ? z * extent[1] + y : y) * extent[0];
        body(component + node, node);
      }
  }

 private:
  /// Blocks along each axis, so that all threads have some. Neighbouring blocks both make the sums along the first axis of the
  /// lines that they share, so that wide blocks make fewer.
  std::array<int, D> parts_for(int threads, int components) const {
    std::array<int, D> parts;
    for (int d = 0; d < D; ++d) parts[d] = d == 0 ? 1 : std::max(1, (extent[d] + widest / 2) / widest);
    for (;;) {
      int all = components, cut = D - 1;
      for (int d = 0; d < D; ++d) all *= parts[d];
      for (int d = 1; d < D; ++d)
        if (extent[d] / parts[d] > extent[cut] / parts[cut]) cut = d;
      if (all >= 2 * threads || extent[cut] < 2 * narrowest * parts[cut]) return parts;
      ++parts[cut];
    }
  }
  static int end_behind(int begin, int extent, int blocks, int wall, int joint) {
    int end = begin + (extent - begin + blocks - 1) / blocks;
    while (end < extent && (end == 1 || end == extent - 1 || end == wall || end == joint)) ++end;
    return end;
  }
};

}  // namespace softwet
