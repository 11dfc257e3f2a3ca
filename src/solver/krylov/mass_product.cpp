#include "solver/krylov/mass_product.hpp"

/// Before a loop whose turns do not depend on each other, though arrays may be the same: host compilers vectorise it.
#if defined(__GNUC__) && !defined(__clang__) && !defined(__CUDACC__)
#define SOFTWET_INDEPENDENT _Pragma("GCC ivdep")
#else
#define SOFTWET_INDEPENDENT
#endif

namespace softwet {
namespace {

/// What a pass does beside its axis: nothing; multiply what it reads by factor root; or end a step of the series.
enum class Pass { plain, scaled, finish };

/// The values that a pass along one axis reads and writes.
struct Lines {
  const double* in;
  double* out;
  Kokkos::View<const double**, Kokkos::LayoutRight, Exec> band;
  int row;     ///< values along the first axis
  int stride;  ///< between neighbours along this axis
  int extent;  ///< values along this axis
  int nodes;   ///< control points of a component
  StepPointers step;
};

/// One axis of a product. An item is a row of values along the first axis on the host, and one value on a device.
template <int P, Pass pass>
struct AlongAxis : Lines {
  static constexpr int width = 2 * P + 1;

  explicit AlongAxis(const Lines& lines) : Lines(lines) {}

  KOKKOS_FUNCTION void operator()(int item) const {
    if constexpr (host_algorithms) {
      const int begin = item * row;
      stride == 1 ? first_axis(begin) : other_axis(begin, begin / stride % extent);
    } else {
      store(item, item % nodes, guarded(item, item / stride % extent));
    }
  }

  KOKKOS_FORCEINLINE_FUNCTION double read(int i, int node) const {
    return pass == Pass::scaled ? step.factor * step.root[node] * in[i] : in[i];
  }
  KOKKOS_FORCEINLINE_FUNCTION void store(int i, int node, double sum) const {
    if constexpr (pass == Pass::finish) {
      step.finish(i, node, sum);
    } else {
      out[i] = sum;
    }
  }
  KOKKOS_FUNCTION double guarded(int i, int place) const {
    const int node = i % nodes;
    double sum = 0;
    for (int k = 0; k < width; ++k) {
      const int way = (k - P) * stride;
      if (place + k >= P && place + k < extent + P) sum += band(k, place) * read(i + way, node + way);
    }
    return sum;
  }

  void first_axis(int begin) const {
    const int end = Kokkos::max(P, row - P), node = begin % nodes;
    const double* b[width];
    for (int k = 0; k < width; ++k) b[k] = &band(k, 0);
    for (int i = 0; i < Kokkos::min(P, row); ++i) store(begin + i, node + i, guarded(begin + i, i));
    SOFTWET_INDEPENDENT
    for (int i = P; i < end; ++i) {
      double sum = b[0][i] * read(begin + i - P, node + i - P);
      for (int k = 1; k < width; ++k) sum += b[k][i] * read(begin + i + k - P, node + i + k - P);
      store(begin + i, node + i, sum);
    }
    for (int i = end; i < row; ++i) store(begin + i, node + i, guarded(begin + i, i));
  }

  void other_axis(int begin, int place) const {
    const int node = begin % nodes;
    int way[width];
    double b[width];
    for (int k = 0; k < width; ++k) {
      const bool inside = place + k >= P && place + k < extent + P;
      way[k] = inside ? (k - P) * stride : 0;
      b[k] = inside ? band(k, place) : 0.0;
    }
    SOFTWET_INDEPENDENT
    for (int i = 0; i < row; ++i) {
      double sum = b[0] * in[begin + i + way[0]];
      for (int k = 1; k < width; ++k) sum += b[k] * in[begin + i + way[k]];
      store(begin + i, node + i, sum);
    }
  }
};

/// Values at the ghosts of a periodic axis, of components behind each other: sums count for what they are copies of, and
/// become copies.
template <int D>
struct CloseAxis {
  GhostPair<D> pair;
  Array values;
  int nodes, items;  ///< of a component: control points, and ghosts
  bool add, copy;

  KOKKOS_FUNCTION void operator()(int g) const {
    int ghost = 0, own = 0;
    pair(g % items, ghost, own);
    const int first = g / items * nodes;
    if (add) values(first + own) += values(first + ghost);
    if (copy) values(first + ghost) = values(first + own);
  }
};

/// The end of a step of the series at every value, where sums along the last axis have to be completed first.
struct FinishStep {
  StepPointers step;
  const double* product;
  int nodes;
  KOKKOS_FUNCTION void operator()(int i) const { step.finish(i, i % nodes, product[i]); }
};

template <int P, Pass pass>
void run_axis(const Lines& lines, int items) {
  Kokkos::parallel_for("softwet::mass_product", Items(0, items), AlongAxis<P, pass>(lines));
}

}  // namespace

template <int D, int P>
MassProduct<D, P>::MassProduct(const Layout<D>& l, int points) : layout_(l) {
  for (int d = 0; d < D; ++d) {
    const Axis& axis = l.axis[d];
    std::vector<ElementRun> all{{0, axis.elements(), 0}}, fluid{{l.solid_elements, axis.elements(), 0}};
    if (d == 0 && l.columns.elements.runs > 0)
      all.assign(l.columns.elements.run, l.columns.elements.run + l.columns.elements.runs);
    velocity_[d] = band(d, all, 0, l.extent(d), points);
    scalar_[d] = d < D - 1 ? velocity_[d] : band(d, fluid, l.wall_row, l.fluid_rows(), points);
  }
  for (Array& a : scratch_) a = Array("mass product", std::max(l.velocity_size(), 2 * l.scalar_size()));
}

template <int D, int P>
typename MassProduct<D, P>::Band MassProduct<D, P>::band(int d, const std::vector<ElementRun>& runs, int first_function,
                                                         int functions, int points) const {
  const Axis& axis = layout_.axis[d];
  Kokkos::View<double**, Kokkos::LayoutRight, Kokkos::HostSpace> band("mass band", 2 * P + 1, functions);
  const Gauss gauss(points);
  for (const ElementRun& run : runs)
    for (int l = run.begin; l < run.end; ++l)
      for (int q = 0; q < points; ++q) {
        const int e = l + run.shift;
        const double x = axis.lower(e) + axis.size(e) * gauss.point[q];
        const std::vector<double> value = axis.values(e, x);
        const double weight = axis.size(e) * gauss.weight[q] * (layout_.axisymmetric && d == 0 ? x : 1.0);
        const int first = axis.span(e) - run.shift - first_function;
        for (int a = 0; a <= P; ++a)
          for (int b = 0; b <= P; ++b) band(b - a + P, first + a) += weight * value[a] * value[b];
      }
  Kokkos::View<double**, Kokkos::LayoutRight, Exec> device("mass band", 2 * P + 1, functions);
  Kokkos::deep_copy(device, band);
  return device;
}

template <int D, int P>
int MassProduct<D, P>::extent(int d, bool velocities) const {
  if (d < D - 1) return layout_.extent(d);
  return velocities ? layout_.rows : layout_.fluid_rows();
}

template <int D, int P>
template <bool Step>
void MassProduct<D, P>::run(const WeightedMass& mass, const SeriesStep& series, const ConstArray& in, const Array& out,
                            int first, int last) const {
  const bool velocities = first < D;
  const int nodes = extent(D - 1, velocities) * layout_.row_size, count = (last - first) * nodes;
  const int row = layout_.extent(0), items = host_algorithms ? count / row : count;
  const StepPointers step(mass, series);
  const bool open = Step && closes(layout_, D - 1);  // sums along the last axis are not complete after their pass
  int stride = 1;
  for (int d = 0; d < D; ++d) {
    const double* from = d == 0 ? in.data() : scratch_[(d - 1) % 2].data();
    const Array to = d == D - 1 && !open ? out : scratch_[d % 2];
    const Lines lines{from,  to.data(), velocities ? velocity_[d] : scalar_[d], row, stride, extent(d, velocities),
                      nodes, step};
    if (Step && d == 0) {
      run_axis<P, Pass::scaled>(lines, items);
    } else if (Step && d == D - 1 && !open) {
      run_axis<P, Pass::finish>(lines, items);
    } else {
      run_axis<P, Pass::plain>(lines, items);
    }
    if (closes(layout_, d)) close(d, to, first, last, true);
    stride *= extent(d, velocities);
  }
  if (open)
    Kokkos::parallel_for("softwet::finish_step", Items(0, count),
                         FinishStep{step, scratch_[(D - 1) % 2].data(), nodes});
}

template <int D, int P>
void MassProduct<D, P>::close(int axis, const Array& values, int first, int last, bool add) const {
  const bool velocities = first < D;
  const bool copy = layout_.whole() || axis != 0;
  CloseAxis<D> close{{{}, axis, extent(axis, velocities) - layout_.axis[axis].degree()}, values, 1, 1, add, copy};
  for (int d = 0; d < D; ++d) {
    close.pair.box.extent[d] = extent(d, velocities);
    close.nodes *= extent(d, velocities);
    close.items *= d == axis ? layout_.axis[axis].degree() : extent(d, velocities);
  }
  Kokkos::parallel_for("softwet::close", Items(0, (last - first) * close.items), close);
}

template <int D, int P>
void MassProduct<D, P>::fill_ghosts(const Array& values, int first, int last) const {
  if (!layout_.whole()) update_columns(layout_.columns, *layout_.exchange, values);
  for (int d = 0; d < D; ++d)
    if (closes(layout_, d) && (d > 0 || layout_.whole())) close(d, values, first, last, false);
}

template <int D, int P>
void MassProduct<D, P>::apply(const ConstArray& in, const Array& out, int first, int last) const {
  run<false>({}, {}, in, out, first, last);
}

template <int D, int P>
void MassProduct<D, P>::step(const WeightedMass& mass, const SeriesStep& series, int first, int last) const {
  run<true>(mass, series, series.y, series.image, first, last);
}

template class MassProduct<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
