// Ties between the last two functions of an axis: they take away the stiff modes of open knots.
#pragma once

#include "field/ghosts.hpp"
#include "solver/krylov/line_blocks.hpp"

namespace softwet {

/// At an open end of an axis the last function has a third of the mass of the functions inside (degree 2), so that the
/// difference of the last two control values c_0, c_1 has the highest frequency of all. A tie adds to the lumped mass
/// of this difference,  D = diag(a) + k d d^T  with  d.c = c_0 - c_1.  Then  W = D^{-1} diag(a)  keeps the mean of the
/// two, weighted with a, and the part 1 / (1 + k / a_0 + k / a_1) of their difference. Uniform fields stay uniform.
/// Where a velocity is held, its neighbours are not tied to it. Where solid and fluid meet, velocities are tied on the
/// side of the solid; where two materials are joined, on the lower side. Ties of several sides follow each other: the
/// halves of all but the last set, the last set, and the other halves in reverse, which is symmetric in the weights.
/// Smaller parts make steps longer, up to a limit, and cost accuracy where a wall has a contact angle.
inline constexpr double kept_of_scalars = 0.6, kept_of_velocities = 0.4;

/// Takes away a part of the difference of two values: the one at `first`, and the one `step` further.
struct EndTie {
  int first, step, node;  ///< the control point of the first value
  bool whole;             ///< else the half of a tie that comes twice
};

/// Ties of one set and block whose places follow each other at the same distance: a loop without dependencies.
struct TieRun {
  EndTie tie;  ///< the first one
  int count, apart;
};

/// Ties of some components in clusters that share no value.
struct TieClusters {
  Kokkos::View<const EndTie*, Exec> ties;               ///< in their order
  Kokkos::View<const int*, Exec> start;                 ///< of the ties of each cluster, and the end
  Kokkos::View<const int*, Exec> member, first_member;  ///< values of each cluster, once
  Kokkos::View<const char*, Exec> tied;                 ///< whether a value is in a cluster
  Kokkos::View<const int*, Exec> of_block;   ///< first cluster of each block of lines, and the end; on the host
  Kokkos::View<const TieRun*, Exec> runs;    ///< the same ties in their order, by block of lines; on the host
  Kokkos::View<const int*, Exec> first_run;  ///< of each block, and the end
  int nodes = 1;                             ///< of a component
  double half = 0, whole = 0;                ///< parts that are taken away; twice the half makes a whole tie

  KOKKOS_FUNCTION int count() const { return static_cast<int>(start.extent(0)) - 1; }

  /// Members [first, last) of a cluster, or of the clusters of a block.
  KOKKOS_FUNCTION void members(int cluster, int& first, int& last) const {
    first = first_member(cluster);
    last = first_member(cluster + 1);
  }
  void members(BlockOfLines block, int& first, int& last) const {
    first = first_member(of_block(block.number));
    last = first_member(of_block(block.number + 1));
  }

  /// What ties take and give: values, or values times the roots where there are some.
  struct Values {
    double* x;
    const double *weights, *root;  ///< the latter null where x has the values themselves
    double* gains;                 ///< gets what x loses; or null
  };
  /// Takes a part of the difference of each pair of a cluster away and keeps its mean, weighted with `weights`.
  KOKKOS_FUNCTION void smooth(int cluster, const Values& of) const {
    for (int k = start(cluster); k < start(cluster + 1); ++k) smooth(ties(k), 0, of);
  }
  /// Smooths all clusters of a block.
  void smooth(BlockOfLines block, const Values& of) const {
    for (int r = first_run(block.number); r < first_run(block.number + 1); ++r) {
      const TieRun run = runs(r);
      const Values values = of;
      if (run.apart == 1) {
        SOFTWET_INDEPENDENT
        for (int k = 0; k < run.count; ++k) smooth(run.tie, k, values);
      } else {
        SOFTWET_INDEPENDENT
        for (int k = 0; k < run.count; ++k) smooth(run.tie, k * run.apart, values);
      }
    }
  }

 private:
  /// One tie, at this distance from another one.
  KOKKOS_FORCEINLINE_FUNCTION void smooth(const EndTie& tie, int distance, const Values& of) const {
    const int i = tie.first + distance, j = i + tie.step, n = tie.node + distance, m = n + tie.step;
    const double a = of.weights[n], b = of.weights[m], at_i = of.root ? of.root[n] : 1.0,
                 at_j = of.root ? of.root[m] : 1.0;
    const double part = (tie.whole ? whole : half) * (of.x[i] * at_j - of.x[j] * at_i) / ((a + b) * at_i * at_j);
    const double loss = b * part * at_i, gain = a * part * at_j;
    of.x[i] -= loss;
    of.x[j] += gain;
    if (!of.gains) return;
    of.gains[i] += loss;
    of.gains[j] -= gain;
  }
};

/// The ties of a scene.   Tested: tests/unit/time/masses/test_mass_inverse.cpp
template <int D>
class EndTies {
 public:
  EndTies(const Layout<D>&, const ConstArray& mask);

  /// W of the components of velocity, and of one scalar.
  const TieClusters& velocities() const { return velocity_; }
  const TieClusters& scalars() const { return scalar_; }
  /// x = W^{-1} x for a scalar, whose array it is alone; `weights` is a by control point.
  void untie_scalars(const Array& x, const ConstArray& weights) const;

 private:
  enum class End { low, high, below_wall, below_joint };
  using Set = std::vector<EndTie>;  ///< of pairs that share no value

  Set make_set(const Layout<D>&, const std::vector<double>& mask, int first_component, int last_component, int axis,
               const std::vector<End>& ends) const;
  static TieClusters clusters(const std::vector<Set>&, const LineBlocks<D>&, int components, double kept);

  TieClusters velocity_, scalar_;
};

}  // namespace softwet
