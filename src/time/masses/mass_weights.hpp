// The weights of the masses that explicit schemes invert: row sums on a moved mesh, and what follows from them.
#pragma once

#include "case/choices.hpp"
#include "scene/mass_products.hpp"
#include "time/masses/mass_series.hpp"
#include "time/masses/smallest_neighbour.hpp"

namespace softwet {

/// Mass weights of the velocities, or of one scalar.
struct MassWeights : WeightedMass {
  int begin, end, first, last;  ///< in a vector of unknowns, and as components
  int nodes() const { return static_cast<int>(sums.extent(0)); }
  Unknowns kind() const { return first == 0 ? Unknowns::velocities : Unknowns::scalars; }
  Array of(const Array& unknowns) const { return Kokkos::subview(unknowns, Kokkos::make_pair(begin, end)); }
};

/// See MassInverse.   Tested: tests/unit/time/masses/test_mass_inverse.cpp
template <int D, int P>
class SceneWeights {
 public:
  SceneWeights(const Regions<D>&, const Coefficients<D>&, MassKind, const MassProduct<D, P>&);

  const MassWeights& scalar() const { return scalar_; }
  const MassWeights& velocity() const { return velocity_; }

  /// Finds the weights of scalars on the mesh of a stage.
  void set_mesh(const Stage&);
  /// Finds the weights of two stages. The first count until `take_other`, then the second; another call switches back.
  void set_meshes(const Stage& now, const Stage& later);
  void take_other();
  /// Finds the weights of velocities by the moments of the density.
  void set_moments(const ConstArray& moments) { prepare(velocity_, row_sums(moments)); }

  // The kernels of `set_moments`, which follow each other. Where nothing has ghosts they may be launched with others.
  auto sums_by_moments(const ConstArray& moments) const { return sums_and_roots(velocity_, rough_, row_sums(moments)); }
  auto roots_by_moments() const { return cut_roots(velocity_, rough_); }
  auto factors_by_moments() const { return factors(velocity_); }

 private:
  MassWeights weights(int begin, int nodes, int first, int last) const;
  void add_solid_sums();
  void set_meshes_together(const Stage& now, const Stage& later);

  /// The operations that take row sums: from an assembled product, which is zero then, and from moments.
  ForEach<mass_kernels::TakeScalarRows> row_sums(const MassWeights&, const Array& rows) const;
  ForEach<mass_kernels::SumVelocityRows> row_sums(const ConstArray& moments) const;
  /// Roots and factors from row sums, which the parts of a launch compute by control point: three kernels.
  template <class... Bodies>
  void prepare(const MassWeights&, const ForEach<Bodies>&... sums);
  template <class... Bodies>
  auto sums_and_roots(const MassWeights& w, const Array& rough, const ForEach<Bodies>&... sums) const {
    return fused(sums..., ForEach{w.nodes(), mass_kernels::FindRoots{rough, w.sums, w.unit}});
  }
  auto cut_roots(const MassWeights& w, const Array& rough) const {
    constexpr double steepest = 1.2;  // ratio of neighbours
    return neighbours_.limit(part_of(rough, w.nodes()), w.root, steepest, w.kind());
  }
  auto factors(const MassWeights& w) const {
    return mass_kernels::FindFactors<D, P>{product_.of(w.root, w.kind()), WeightedPointers(w), w.left.data(),
                                           w.right.data()}
        .on_all();
  }
  static Array part_of(const Array& a, int count) { return Kokkos::subview(a, Kokkos::make_pair(0, count)); }

  const Regions<D>& regions_;
  const Coefficients<D>& coefficients_;
  MassKind kind_;
  const MassProduct<D, P>& product_;
  Masses<D, P> masses_;
  SmallestNeighbour<D, P> neighbours_;
  MassWeights scalar_, later_, velocity_;  ///< `later_` where the mesh moves
  Array solid_sums_;                       ///< by control point of the velocity
  Array ones_, rough_, rough_later_;       ///< the latter before they are cut
  Array rows_, rows_later_;                ///< where moved meshes assemble their row sums; zero in between
  bool has_mesh_ = false;
};

}  // namespace softwet
