// Needles: springs that hold boxes of the solid at positions that move.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "case/case.hpp"
#include "field/factor.hpp"
#include "field/stage.hpp"
#include "field/stencil.hpp"
#include "kernels/solid/spring.hpp"
#include "operator/integrate.hpp"
#include "scene/loads.hpp"

namespace softwet {

/// What a needle measures. In the coordinates (r, z) Needles has it for each radian.
struct NeedleReading {
  std::array<double, 3> force{};  ///< of the needle on the solid
  double energy = 0;              ///< in its springs
  double power = 0;               ///< of the needle that moves: the force times U'
  double power_on_solid = 0;      ///< of its springs on the solid
};

namespace needle_kernels {

/// out -= w k (U - u)
template <int D, class Real>
struct SubtractForce {
  Array out;
  ConstArray weight;
  ConstArrayOf<Real> displacement;
  Spring spring;
  Factor place[D];
  int apart, nodes;  ///< from one velocity, and from one displacement, to the next
  KOKKOS_FUNCTION void operator()(int i) const {
    if (weight(i) == 0) return;
    for (int d = 0; d < D; ++d)
      out(d * apart + i) -= weight(i) * spring.force(place[d] - static_cast<double>(displacement(d * nodes + i)));
  }
};

/// out += scale k w direction
template <int D, class Real>
struct AddProduct {
  ArrayOf<Real> out;
  ConstArrayOf<Real> direction;
  ConstArray held;
  double scale;
  int apart;
  KOKKOS_FUNCTION void operator()(int i) const {
    if (held(i) == 0) return;
    for (int d = 0; d < D; ++d) out(d * apart + i) += static_cast<Real>(scale * held(i)) * direction(d * apart + i);
  }
};

template <int D>
struct AddDiagonal {
  Stencil<D> stencil;
  StencilValues values;
  ConstArray held;
  double scale;
  KOKKOS_FUNCTION void operator()(int i) const {
    if (held(i) == 0) return;
    for (int d = 0; d < D; ++d)
      values(stencil.index(d, d, stencil.offsets / 2, i)) += static_cast<float>(scale * held(i));
  }
};

/// gap = U - u, force = w k gap, along one axis.
struct Pull {
  Array gap, force;
  ConstArray weight, displacement;
  Spring spring;
  double place;
  KOKKOS_FUNCTION void operator()(int i) const {
    gap(i) = weight(i) == 0 ? 0 : place - displacement(i);
    force(i) = weight(i) * spring.force(gap(i));
  }
};

}  // namespace needle_kernels

/// The needles of a case. A needle holds the control values u_i with the weights w_i = int_box N_i dX of its box, which
/// goes with the solid: force w_i k (U - u_i), energy sum_i w_i k/2 |U - u_i|^2.
/// Tested: tests/unit/scene/test_needles.cpp
template <int D>
class Needles {
 public:
  static constexpr const char* energy_column = "energy_needle";

  Needles() = default;
  Needles(const Layout<D>& l, const Case& c) : clock_zero_(c.clock_zero()) {
    if (c.needles.empty()) return;
    std::vector<double> held(static_cast<std::size_t>(l.solid_rows()) * l.row_size, 0.0);
    for (const Needle& needle : c.needles) {
      const std::vector<double> w = weights_on_box(l, needle.lower, needle.upper, 1);
      for (std::size_t i = 0; i < w.size(); ++i) held[i] += needle.stiffness * w[i];
      const Array pull(Kokkos::view_alloc("needle.pull", Kokkos::WithoutInitializing), 2 * D * w.size());
      all_.push_back({needle, to_device<Array>(w, "needle"), pull});
    }
    held_ = to_device<Array>(held, "needles");
  }

  bool empty() const { return all_.empty(); }

  /// How many numbers their places are, and these at a time.
  int numbers() const { return D * static_cast<int>(all_.size()); }
  void find_places(double time, double* numbers) const {
    for (const Held& one : all_)
      for (int d = 0; d < D; ++d) *numbers++ = place(one, d, time);
  }

  /// @param places  where kernels read what `find_places` has found; null: they have it as arguments
  template <class Real>
  void add_to_residual(const Layout<D>& l, double time, const ArrayOf<Real>& displacement, const Array& out,
                       const double* places = nullptr) const {
    for (const Held& one : all_) {
      needle_kernels::SubtractForce<D, Real> force{out, one.weight,          displacement, {one.needle.stiffness},
                                                   {},  l.rows * l.row_size, nodes(l)};
      for (int d = 0; d < D; ++d) force.place[d] = factor_at(places ? places++ : nullptr, place(one, d, time));
      Kokkos::parallel_for("softwet::needle", Items(0, nodes(l)), force);
    }
  }

  /// @param scale  d displacement / d velocity
  template <class Real>
  void add_to_product(const Layout<D>& l, double scale, const ArrayOf<Real>& direction,
                      const ArrayOf<Real>& out) const {
    if (empty()) return;
    Kokkos::parallel_for("softwet::needle_product", Items(0, nodes(l)),
                         needle_kernels::AddProduct<D, Real>{out, direction, held_, scale, l.rows * l.row_size});
  }

  void add_to_matrix(double scale, const Stencil<D>& stencil, const StencilValues& values) const {
    if (empty()) return;
    Kokkos::parallel_for("softwet::needle_matrix", Items(0, held_.extent(0)),
                         needle_kernels::AddDiagonal<D>{stencil, values, held_, scale});
  }

  /// Starts what each needle measures, which is there when `pending` is finished. The list has to stay where it is
  /// until then.
  void start_readings(const Layout<D>& l, const Stage& stage, PendingIntegrals& pending,
                      std::vector<NeedleReading>& found) const {
    found.assign(all_.size(), {});
    if (empty()) return;
    const VectorSpace space = l.space();
    const int n = nodes(l);
    for (std::size_t k = 0; k < all_.size(); ++k) {
      const Held& one = all_[k];
      NeedleReading& reading = found[k];
      for (int d = 0; d < D; ++d) {
        const Array gap = Kokkos::subview(one.pull, Kokkos::make_pair(2 * d * n, (2 * d + 1) * n)),
                    force = Kokkos::subview(one.pull, Kokkos::make_pair((2 * d + 1) * n, (2 * d + 2) * n));
        const int u = l.displacement_offset(d), v = l.velocity_offset(d);
        Kokkos::parallel_for("softwet::needle_reading", Items(0, n),
                             needle_kernels::Pull{gap,
                                                  force,
                                                  one.weight,
                                                  part(stage.displacement, u, u + n),
                                                  {one.needle.stiffness},
                                                  place(one, d, stage.time)});
        pending.start_sum(space, force, {}, [&reading, d, speed = speed(one, d, stage.time)](double sum) {
          reading.force[d] = sum;
          reading.power += sum * speed;
        });
        pending.start_sum(space, force, gap, [&reading](double sum) { reading.energy += 0.5 * sum; });
        pending.start_sum(space, force, part(stage.unknown, v, v + n),
                          [&reading](double sum) { reading.power_on_solid += sum; });
      }
    }
  }

 private:
  struct Held {
    Needle needle;
    Array weight;
    Array pull;  ///< gap and force along each axis, for readings
  };

  static int nodes(const Layout<D>& l) { return l.solid_rows() * l.row_size; }
  double place(const Held& one, int d, double time) const { return one.needle.place(d, time - clock_zero_); }
  /// Speed just before a time: at a corner of the path it is the speed of the step that ends there.
  double speed(const Held& one, int d, double time) const {
    const double before = 1e-7 * std::max(1.0, std::abs(time));
    return (place(one, d, time) - place(one, d, time - before)) / before;
  }

  double clock_zero_ = 0;
  std::vector<Held> all_;
  Array held_;  ///< sum of k w_i of all needles
};

}  // namespace softwet
