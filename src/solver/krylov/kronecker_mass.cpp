#include "solver/krylov/kronecker_mass.hpp"

namespace softwet {
namespace {

/// Rows of the mass matrix of functions [first_function, ..) on the elements [first, last): (i, k) is M(i, i - k).
std::vector<double> mass_band(const Axis& axis, int points, int first, int last, int first_function, int functions) {
  const int p = axis.degree();
  const Gauss gauss(points);
  std::vector<double> band(static_cast<std::size_t>(functions) * (p + 1), 0.0);
  for (int e = first; e < last; ++e)
    for (int q = 0; q < points; ++q) {
      const double x = axis.lower(e) + axis.size(e) * gauss.point[q];
      const std::vector<double> value = axis.values(e, x);
      const double weight = axis.size(e) * gauss.weight[q] * axis.weight(x);
      for (int a = 0; a <= p; ++a)
        for (int b = 0; b <= a; ++b)
          band[(axis.span(e) + a - first_function) * (p + 1) + a - b] += weight * value[a] * value[b];
    }
  return band;
}

/// L D L^T of a band in place; functions that are not `free` become the identity.
BandedFactors factorise(std::vector<double> band, int p, const std::vector<bool>& is_free) {
  const int n = static_cast<int>(is_free.size()), w = p + 1;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k <= std::min(p, i); ++k)
      if (!is_free[i] || !is_free[i - k]) band[i * w + k] = k == 0 ? 1 : 0;
  Kokkos::View<double**, Kokkos::LayoutRight, Kokkos::HostSpace> f("banded factors", n, w);
  for (int i = 0; i < n; ++i)
    for (int k = std::min(p, i); k >= 0; --k) {
      double sum = band[i * w + k];
      for (int m = k + 1; m <= std::min(p, i); ++m) sum -= f(i, m) * (k == 0 ? f(i, m) : f(i - k, m - k)) / f(i - m, 0);
      f(i, k) = k == 0 ? 1 / sum : sum * f(i - k, 0);
    }
  Kokkos::View<double**, Kokkos::LayoutRight, Exec> device("banded factors", n, w);
  Kokkos::deep_copy(device, f);
  return device;
}

/// Solves along one axis: an item is a line of n values, `stride` apart.
struct SolveLine {
  Array x;
  BandedFactors factors;
  int offset, n, stride;

  KOKKOS_FUNCTION void operator()(int line) const {
    double* v = x.data() + offset + line % stride + line / stride * stride * n;
    const int p = static_cast<int>(factors.extent(1)) - 1;
    for (int i = 0; i < n; ++i)
      for (int k = 1; k <= p && k <= i; ++k) v[i * stride] -= factors(i, k) * v[(i - k) * stride];
    for (int i = n - 1; i >= 0; --i) {
      double y = v[i * stride] * factors(i, 0);
      for (int k = 1; k <= p && i + k < n; ++k) y -= factors(i + k, k) * v[(i + k) * stride];
      v[i * stride] = y;
    }
  }
};

}  // namespace

template <int D>
KroneckerMass<D>::KroneckerMass(const Layout<D>& own, int points, const ConstArray& device_mask)
    : layout_(own), boxes_(boxes(own.whole_patch())) {
  const Layout<D> l = own.whole_patch();
  if (!own.whole()) patch_ = Array("mass of the patch", l.size());
  const std::vector<double> mask = to_host_of_patch(own, device_mask);
  std::vector<double> sums(l.size(), 1.0);
  for (const Axis& axis : l.axis) exact_ = exact_ && !axis.periodic();
  for (std::size_t c = 0; c < boxes_.size(); ++c) {
    const Box<D>& box = boxes_[c];
    auto& factors = factors_.emplace_back();
    int stride = 1, middle = box.offset, size = 1;  // the ends of an axis are judged in the middle of the others
    std::array<int, D> step;
    for (int d = 0; d < D; ++d) {
      step[d] = stride;
      middle += box.extent[d] / 2 * stride;
      stride *= box.extent[d];
      size *= box.extent[d];
    }
    for (int d = 0; d < D; ++d) {
      const Axis& axis = l.axis[d];
      const bool of_fluid = d == D - 1 && c >= D;
      const int first = of_fluid ? l.solid_elements : 0, function = of_fluid ? l.wall_row : 0, n = box.extent[d];
      const std::vector<double> band = mass_band(axis, points, first, axis.elements(), function, n);
      const std::vector<double> all = axis.integrals(0, axis.length(), first, axis.elements());
      std::vector<bool> is_free(n);
      for (int i = 0; i < n; ++i) is_free[i] = mask[middle + (i - n / 2) * step[d]] != 0;
      factors[d] = factorise(band, axis.degree(), is_free);
      for (int i = 0; i < size; ++i) {
        const int index = i / step[d] % n;
        double integral = all[function + index];
        if (axis.periodic() && index + axis.owned() < n) integral += all[function + index + axis.owned()];
        sums[box.offset + i] *= integral;
      }
    }
  }
  row_sums_ = from_patch(own, sums);
}

template <int D>
void KroneckerMass<D>::solve(const Array& x, int first, int last) const {
  if (layout_.whole()) return solve_lines(x, first, last);
  gather_columns(layout_.columns, x, patch_);
  solve_lines(patch_, first, last);
  take_columns(layout_.columns, patch_, x);
}

template <int D>
void KroneckerMass<D>::solve_lines(const Array& x, int first, int last) const {
  for (int c = first; c < last; ++c) {
    const Box<D>& box = boxes_[c];
    int size = 1, stride = 1;
    for (int d = 0; d < D; ++d) size *= box.extent[d];
    for (int d = 0; d < D; ++d) {
      const int n = box.extent[d];
      Kokkos::parallel_for("softwet::mass_lines", Items(0, size / n),
                           SolveLine{x, factors_[c][d], box.offset, n, stride});
      stride *= n;
    }
  }
}

template class KroneckerMass<2>;
template class KroneckerMass<3>;

}  // namespace softwet
