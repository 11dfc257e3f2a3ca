#include "solver/krylov/mass_product.hpp"

namespace softwet {
namespace {

/// Values at the ghosts of a periodic axis, of components behind each other, become copies.
template <int D>
struct CopyGhosts {
  GhostPair<D> pair;
  Array values;
  int nodes, items;  ///< of a component: control points, and ghosts

  KOKKOS_FUNCTION void operator()(int g) const {
    int ghost = 0, own = 0;
    pair(g % items, ghost, own);
    const int first = g / items * nodes;
    values(first + ghost) = values(first + own);
  }
};

template <int D, int P>
struct StoreProduct {
  BandProduct<D, P> product;
  Array out;

  KOKKOS_FUNCTION void operator()(int item) const {
    product.for_values(ValuesOfItem{item}, [to = out.data()](int i, int, double sum) { to[i] = sum; });
  }
};

}  // namespace

template <int D, int P>
MassProduct<D, P>::MassProduct(const Layout<D>& l, int points) : layout_(l) {
  int stride = 1;
  for (const Unknowns of : {Unknowns::velocities, Unknowns::scalars}) {
    BandProduct<D, P>& product = of == Unknowns::velocities ? velocity_ : scalar_;
    product.blocks = LineBlocks<D>(l, of);
    product.nodes = product.blocks.nodes;
  }
  for (int d = 0; d < D; ++d) {
    const Axis& axis = l.axis[d];
    std::vector<ElementRun> all{{0, axis.elements(), 0}}, fluid{{l.solid_elements, axis.elements(), 0}};
    if (d == 0 && l.columns.elements.runs > 0)
      all.assign(l.columns.elements.run, l.columns.elements.run + l.columns.elements.runs);
    velocity_.band[d] = band(d, all, 0, l.extent(d), points);
    scalar_.band[d] = d < D - 1 ? velocity_.band[d] : band(d, fluid, l.wall_row, l.fluid_rows(), points);
    for (BandProduct<D, P>* product : {&velocity_, &scalar_}) {
      product->extent[d] = product->blocks.extent[d];
      product->stride[d] = stride;
      product->owned[d] = product->extent[d] - (closes(l, d) ? axis.degree() : 0);
    }
    stride *= l.extent(d);
  }
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
        const double weight = axis.size(e) * gauss.weight[q] * axis.weight(x);
        const int first = axis.span(e) - run.shift - first_function;
        for (int a = 0; a <= P; ++a)
          for (int b = 0; b <= P; ++b) band(b - a + P, first + a) += weight * value[a] * value[b];
      }
  Kokkos::View<double**, Kokkos::LayoutRight, Exec> device("mass band", 2 * P + 1, functions);
  Kokkos::deep_copy(device, band);
  return device;
}

template <int D, int P>
BandProduct<D, P> MassProduct<D, P>::of(const ConstArray& in, Unknowns of) const {
  BandProduct<D, P> product = of == Unknowns::velocities ? velocity_ : scalar_;
  product.in = in.data();
  return product;
}

template <int D, int P>
void MassProduct<D, P>::apply(const ConstArray& in, const Array& out, int first, int last) const {
  const BandProduct<D, P> product = of(in, kind(first));
  Kokkos::parallel_for("softwet::mass_product", Items(0, product.blocks.items(last - first)),
                       StoreProduct<D, P>{product, out});
}

template <int D, int P>
void MassProduct<D, P>::copy_ghosts(int axis, const Array& values, int first, int last) const {
  const BandProduct<D, P>& product = first < D ? velocity_ : scalar_;
  CopyGhosts<D> copy{{{}, axis, product.owned[axis]}, values, product.nodes, 1};
  for (int d = 0; d < D; ++d) {
    copy.pair.box.extent[d] = product.extent[d];
    copy.items *= d == axis ? layout_.axis[axis].degree() : product.extent[d];
  }
  Kokkos::parallel_for("softwet::close", Items(0, (last - first) * copy.items), copy);
}

template <int D, int P>
void MassProduct<D, P>::fill_ghosts(const Array& values, int first, int last) const {
  if (!layout_.whole()) update_columns(layout_.columns, *layout_.exchange, values);
  for (int d = 0; d < D; ++d)
    if (closes(layout_, d) && (d > 0 || layout_.whole())) copy_ghosts(d, values, first, last);
}

template class MassProduct<SOFTWET_DIMENSION, SOFTWET_DEGREE>;

}  // namespace softwet
