#include "solver/krylov/mass_product.hpp"

namespace softwet {
namespace {

/// One axis of a product. An item is a row of values along the first axis on the host, and one value on a device.
template <int P>
struct AlongAxis {
  static constexpr int width = 2 * P + 1;
  const double* in;
  double* out;
  Kokkos::View<const double**, Kokkos::LayoutRight, Exec> band;
  int row;     ///< values along the first axis
  int stride;  ///< between neighbours along this axis
  int extent;  ///< values along this axis

  KOKKOS_FUNCTION void operator()(int item) const {
    if constexpr (host_algorithms) {
      stride == 1 ? first_axis(item) : other_axis(item * row, item * row / stride % extent);
    } else {
      const int place = item / stride % extent;
      out[item] = guarded(item, place);
    }
  }

  KOKKOS_FUNCTION double guarded(int index, int place) const {
    double sum = 0;
    for (int k = 0; k < width; ++k)
      if (place + k >= P && place + k < extent + P) sum += band(k, place) * in[index + (k - P) * stride];
    return sum;
  }

  void first_axis(int item) const {
    const int begin = item * row, end = Kokkos::max(P, row - P);
    for (int i = 0; i < Kokkos::min(P, row); ++i) out[begin + i] = guarded(begin + i, i);
    const double* b[width];
    for (int k = 0; k < width; ++k) b[k] = &band(k, 0);
    const double* x = in + begin - P;
    double* y = out + begin;
    for (int i = P; i < end; ++i) {
      double sum = b[0][i] * x[i];
      for (int k = 1; k < width; ++k) sum += b[k][i] * x[i + k];
      y[i] = sum;
    }
    for (int i = end; i < row; ++i) out[begin + i] = guarded(begin + i, i);
  }

  void other_axis(int begin, int place) const {
    const double* x[width];
    double b[width];
    for (int k = 0; k < width; ++k) {
      const bool inside = place + k >= P && place + k < extent + P;
      x[k] = in + begin + (inside ? (k - P) * stride : 0);
      b[k] = inside ? band(k, place) : 0.0;
    }
    double* y = out + begin;
    for (int i = 0; i < row; ++i) {
      double sum = b[0] * x[0][i];
      for (int k = 1; k < width; ++k) sum += b[k] * x[k][i];
      y[i] = sum;
    }
  }
};

}  // namespace

template <int D, int P>
MassProduct<D, P>::MassProduct(const Layout<D>& l, int points) : layout_(l) {
  for (int d = 0; d < D; ++d) {
    const Axis& axis = l.axis[d];
    std::vector<ElementRun> all{{0, axis.elements(), 0}}, fluid{{l.solid_elements, axis.elements(), 0}};
    if (d == 0 && l.columns.elements.runs > 0)
      all.assign(l.columns.elements.run, l.columns.elements.run + l.columns.elements.runs);
    velocity_[d] = band(axis, all, 0, l.extent(d), points);
    scalar_[d] = d < D - 1 ? velocity_[d] : band(axis, fluid, l.wall_row, l.fluid_rows(), points);
  }
  for (Array& a : scratch_) a = Array("mass product", std::max(l.velocity_size(), 2 * l.scalar_size()));
}

template <int D, int P>
typename MassProduct<D, P>::Band MassProduct<D, P>::band(const Axis& axis, const std::vector<ElementRun>& runs,
                                                         int first_function, int functions, int points) const {
  Kokkos::View<double**, Kokkos::LayoutRight, Kokkos::HostSpace> band("mass band", 2 * P + 1, functions);
  const Gauss gauss(points);
  for (const ElementRun& run : runs)
    for (int l = run.begin; l < run.end; ++l)
      for (int q = 0; q < points; ++q) {
        const int e = l + run.shift;
        const std::vector<double> value = axis.values(e, axis.lower(e) + axis.spacing() * gauss.point[q]);
        const double weight = axis.spacing() * gauss.weight[q];
        const int first = axis.span(e) - run.shift - first_function;
        for (int a = 0; a <= P; ++a)
          for (int b = 0; b <= P; ++b) band(b - a + P, first + a) += weight * value[a] * value[b];
      }
  Kokkos::View<double**, Kokkos::LayoutRight, Exec> device("mass band", 2 * P + 1, functions);
  Kokkos::deep_copy(device, band);
  return device;
}

template <int D, int P>
void MassProduct<D, P>::apply(const Array& in, const Array& out, int first, int last) const {
  const bool velocities = first < D;
  const int count = (last - first) * (velocities ? layout_.rows : layout_.fluid_rows()) * layout_.row_size;
  const int offset = velocities ? layout_.velocity_offset(first)
                                : (first == D ? layout_.density_offset() : layout_.potential_offset());
  const int row = layout_.extent(0), items = host_algorithms ? count / row : count;
  int stride = 1;
  for (int d = 0; d < D; ++d) {
    const int extent = d < D - 1 ? layout_.extent(d) : (velocities ? layout_.rows : layout_.fluid_rows());
    // The scratch vectors hold these components alone.
    const double* from = d == 0 ? in.data() + offset : scratch_[(d - 1) % 2].data();
    double* to = d == D - 1 ? out.data() + offset : scratch_[d % 2].data();
    Kokkos::parallel_for("softwet::mass_product", Items(0, items),
                         AlongAxis<P>{from, to, velocities ? velocity_[d] : scalar_[d], row, stride, extent});
    stride *= extent;
  }
}

template class MassProduct<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
