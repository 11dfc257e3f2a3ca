// Blocks of neighbouring lines of values: the items of kernels on a processor.
#pragma once

#include "field/layout.hpp"

/// Before a loop whose turns do not depend on each other, though arrays may be the same: host compilers vectorise it.
#if defined(__GNUC__) && !defined(__clang__) && !defined(__CUDACC__)
#define SOFTWET_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SOFTWET_INDEPENDENT
#endif

namespace softwet {

/// The two kinds of components: velocities have control points in the solid and in the fluid, scalars in the fluid
/// alone.
enum class Unknowns { velocities, scalars };

/// What an item of a kernel has: a block of lines on a processor, a value on a device.
struct BlockOfLines {
  int number;
};
struct OneValue {
  int number;
};
using ValuesOfItem = std::conditional_t<host_algorithms, BlockOfLines, OneValue>;

/// Components behind each other, cut into blocks of lines along the first axis. A block has a range of places along
/// each of the other axes. Ends of blocks never part the values that end ties connect (time/masses/end_ties.hpp): the
/// first two and the last two of an axis, and those below and on the wall or the joint of the solid.
template <int D>
struct LineBlocks {
  static constexpr int width = 16;  ///< about

  int extent[D] = {}, nodes = 1;             ///< of a component
  int blocks[D] = {};                        ///< along each axis; 1 along the first
  Kokkos::View<const int*, Exec> starts[D];  ///< first place of each block, and the end

  LineBlocks() = default;
  LineBlocks(const Layout<D>& l, Unknowns of) {
    const int joint = l.axis[D - 1].joint(), joint_row = joint > 0 ? l.axis[D - 1].span(joint) : 0;
    for (int d = 0; d < D; ++d) {
      extent[d] = d < D - 1 ? l.extent(d) : of == Unknowns::velocities ? l.rows : l.fluid_rows();
      nodes *= extent[d];
      std::vector<int> places{0};
      while (places.back() < extent[d])
        places.push_back(d == 0      ? extent[d]
                         : d < D - 1 ? end_behind(places.back(), extent[d], 0, 0)
                                     : end_behind(places.back(), extent[d], l.wall_row, joint_row));
      blocks[d] = static_cast<int>(places.size()) - 1;
      starts[d] = to_device<Kokkos::View<int*, Exec>>(places, "line blocks");
    }
  }

  int count() const {
    int all = 1;
    for (int d = 0; d < D; ++d) all *= blocks[d];
    return all;
  }
  /// Items of a kernel for all values of so many components.
  int items(int components) const { return components * (host_algorithms ? count() : nodes); }
  /// Calls body(value, node) for all values of an item, in any order.
  template <class Body>
  KOKKOS_FORCEINLINE_FUNCTION void for_values(OneValue value, const Body& body) const {
    body(value.number, value.number % nodes);
  }
  template <class Body>
  void for_values(BlockOfLines block, const Body& body) const {
    for_lines(block.number, [&](int begin, int node) {
      SOFTWET_INDEPENDENT
      for (int i = 0; i < extent[0]; ++i) body(begin + i, node + i);
    });
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
  static int end_behind(int begin, int extent, int wall, int joint) {
    const int left = extent - begin, blocks = std::max(1, (left + width / 2) / width);
    int end = begin + (left + blocks - 1) / blocks;
    while (end < extent && (end == 1 || end == extent - 1 || end == wall || end == joint)) ++end;
    return end;
  }
};

}  // namespace softwet
