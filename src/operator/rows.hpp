// Rows of elements in colours: those of one colour share no control value, so every sum has one fixed order, whatever the
// number of threads.
#pragma once

#include "operator/element.hpp"

namespace softwet {

/// Whether elements along the first axis belong to a row, or are coloured too.
enum class FirstAxis { in_rows, coloured };

/// Rows of elements along the first axis, numbered within one colour of the other axes: elements of a colour are
/// `stride` = degree + 1 apart, so they share no control point; with a shared test function a colour has one layer.
template <int D>
struct Colouring {
  int start[D], step[D], count[D];
  ElementColumns first_axis;

  /// @param run  of elements along the first axis, where its elements are coloured too, by their number on the axis
  template <class Real>
  Colouring(const Region<D, Real>& region, int stride, int colour, FirstAxis along, int run = 0)
      : first_axis(region.first_axis()) {
    for (int d = 0; d < D; ++d) {
      const bool coloured = d > 0 || along == FirstAxis::coloured;
      const ElementRun elements = d > 0 ? ElementRun{0, region.axis[d].elements, 0} : first_axis.run[run];
      step[d] = colours_of(region, stride, d);
      const int own = coloured ? colour % step[d] : 0;
      if (coloured) colour /= step[d];
      start[d] = elements.begin + ((own - elements.begin - elements.shift) % step[d] + step[d]) % step[d];
      count[d] = coloured ? (elements.end - start[d] + step[d] - 1) / step[d] : 1;
    }
  }
  template <class Real>
  static int colours_of(const Region<D, Real>& region, int stride, int d) {
    return d == D - 1 && stride > 1 && region.shared_test ? region.axis[d].elements : stride;
  }
  /// Calls visit(colouring) for one colour after another of all elements of a region.
  template <class Real, class Visit>
  static void for_all(const Region<D, Real>& region, int stride, FirstAxis along, const Visit& visit) {
    const bool in_rows = along == FirstAxis::in_rows;
    int colours = 1;
    for (int d = in_rows ? 1 : 0; d < D; ++d) colours *= colours_of(region, stride, d);
    const int runs = in_rows ? 1 : region.first_axis().runs;
    for (int colour = 0; colour < colours; ++colour)
      for (int run = 0; run < runs; ++run) {
        const Colouring colouring(region, stride, colour, along, run);
        if (colouring.items() > 0) visit(colouring);
      }
  }
  int items() const {
    int n = 1;
    for (int d = 0; d < D; ++d) n *= count[d] > 0 ? count[d] : 0;
    return n;
  }
  KOKKOS_FUNCTION Batch<D> batch(int item) const {
    Batch<D> b{};
    b.count = 1;
    for (int d = 0; d < D; ++d) {
      b.element[d] = start[d] + step[d] * (item % count[d]);
      item /= count[d];
    }
    return b;
  }
};

/// Numbers of a batch: a lane for each element on the host, one element on a device.
template <class Real>
using BatchNumber = std::conditional_t<on_host, Pack<Real>, OneNumber<Real>>;

/// Runs body(batch) for all elements of a row, `lanes` elements in a batch. The last element of a full batch is one
/// before a multiple of `lanes` on the axis, whichever part of it is stored: so every sum has the same order.
template <int D, int lanes, class Body>
KOKKOS_FORCEINLINE_FUNCTION void for_batches(const ElementColumns& columns, Batch<D> b, const Body& body) {
  for (int r = 0; r < columns.runs; ++r) {
    const ElementRun& run = columns.run[r];
    for (int e = run.begin; e < run.end;) {
      const int whole = e + lanes - (e + run.shift) % lanes, stop = whole < run.end ? whole : run.end;
      b.element[0] = e;
      b.count = stop - e;
      body(b);
      e = stop;
    }
  }
}

/// A loop body for threads of the host, called through a pointer, so that one loop is compiled for all bodies.
struct HostItem {
  const void* body;
  void (*run)(const void* body, int item);

  void operator()(int item) const { run(body, item); }
};

/// Runs body(item) for so many items on the threads of the host, and waits.
template <class Body>
void for_items(const char* name, int items, const Body& body) {
  const HostItem item{&body, [](const void* it, int i) { (*static_cast<const Body*>(it))(i); }};
  Kokkos::parallel_for(name, Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace>(0, items), item);
}

/// Runs a body for the batches of a row of elements on the host, likewise called through a pointer.
template <int D>
struct RowBody {
  const void* body;
  void (*run)(const void* body, const ElementColumns& columns, const Batch<D>& row);

  template <int lanes, class Body>
  static RowBody of(const Body& body) {
    return {&body, [](const void* it, const ElementColumns& columns, const Batch<D>& row) {
              for_batches<D, lanes>(columns, row, *static_cast<const Body*>(it));
            }};
  }
};

/// An item of one colour on the host: a row of elements.
template <int D>
struct ColourRow {
  Colouring<D> colouring;
  RowBody<D> row;

  void operator()(int item) const { row.run(row.body, colouring.first_axis, colouring.batch(item)); }
};

/// An item of one colour on a device: one element.
template <int D, class Body>
struct ColourElement {
  Colouring<D> colouring;
  Body body;

  KOKKOS_FUNCTION void operator()(int item) const { body(colouring.batch(item)); }
};

/// Layers with the same test functions, on the host. An item is a block of elements along the first axis with all layers above
/// each other. Blocks begin at multiples of their width on the whole axis. Those of a colour share no control value: they are
/// two blocks apart, and `stride` elements along the middle axis of three.
template <int D>
struct BlockOfColumns {
  static constexpr int width = 16;  // at least the degree
  ElementRun along;
  int first_block, first_row, rows, stride, layers;  ///< of this colour; rows along the middle axis
  RowBody<D> row;

  void operator()(int item) const {
    const int begin = (first_block + 2 * (item / rows)) * width - along.shift;
    ElementColumns block;
    block.runs = 1;
    block.run[0] = {begin > along.begin ? begin : along.begin, begin + width < along.end ? begin + width : along.end,
                    along.shift};
    Batch<D> b{};
    if constexpr (D == 3) b.element[1] = first_row + stride * (item % rows);
    for (b.element[D - 1] = 0; b.element[D - 1] < layers; ++b.element[D - 1]) row.run(row.body, block, b);
  }

  template <class Real>
  static void run(const char* name, const Region<D, Real>& region, int stride, const RowBody<D>& body) {
    const int all_rows = D == 3 ? region.axis[1].elements : 1, apart = D == 3 ? stride : 1;
    const ElementColumns columns = region.first_axis();
    for (int r = 0; r < columns.runs; ++r) {
      const ElementRun& along = columns.run[r];
      const int first = (along.begin + along.shift) / width, end = (along.end + along.shift + width - 1) / width;
      for (int colour = 0; colour < 2 * apart; ++colour) {
        const int block = first + (first + colour / apart) % 2, row = colour % apart;
        const int rows = (all_rows - row + apart - 1) / apart, items = rows * ((end - block + 1) / 2);
        if (items > 0)
          for_items(name, items, BlockOfColumns{along, block, row, rows, apart, region.axis[D - 1].elements, body});
      }
    }
  }
};

/// On the host: runs a body for all rows of a region, one colour after another.
template <int D, class Real>
void for_rows(const char* name, const Region<D, Real>& region, int stride, const RowBody<D>& body) {
  if (region.shared_test) return BlockOfColumns<D>::run(name, region, stride, body);
  Colouring<D>::for_all(region, stride, FirstAxis::in_rows, [&](const Colouring<D>& colouring) {
    for_items(name, colouring.items(), ColourRow<D>{colouring, body});
  });
}

/// Runs body(batch) for all elements of a region, one colour after another.
template <int D, class Real, class Body>
void for_colours(const char* name, const Region<D, Real>& region, int stride, const Body& body) {
  if constexpr (on_host) {
    for_rows(name, region, stride, RowBody<D>::template of<Lanes<BatchNumber<Real>>::count>(body));
  } else {
    Colouring<D>::for_all(region, stride, FirstAxis::coloured, [&](const Colouring<D>& colouring) {
      Kokkos::parallel_for(name, Items(0, colouring.items()), ColourElement<D, Body>{colouring, body});
    });
  }
}

}  // namespace softwet
