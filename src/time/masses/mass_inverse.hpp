// The inverses of the masses that explicit schemes need: of density, chemical potential and velocity.
#pragma once

#include "solver/krylov/conjugate_gradient.hpp"
#include "solver/krylov/kronecker_mass.hpp"
#include "time/masses/mass_weights.hpp"
#include "time/step/sum_of.hpp"

namespace softwet {

/// Approximate inverses S of the mass A of the moved mesh, weighted with J for scalars and with the density for
/// velocities. With the row sums a of A, the ties D of their ends and e = 1 - D^{-1} A,
///   lumped      S = D^{-1}
///   corrected   S = (1 + e + e^2 - 2 e^3) D^{-1}:  A S = 1 - 3 e^3 + ... for smooth fields, and S = D^{-1} for what
///               oscillates from function to function, so that steps are 1.6 to 1.9 times shorter than with lumped
///               masses
///               and not 25 times and more, as with consistent ones
/// Products with A follow from products with the mass M of the fixed mesh, whose row sums are m:
///   A c = a c - s (c (M s) - M (s c)),   s = sqrt(a / m),
/// symmetric, exact on a fixed mesh, and of fourth order else. A 1 = a, so that S a = 1: uniform fields stay uniform,
/// and the moments A S p have the sum of p up to rounding. Velocities that are held are left out.
/// Where s rises by more than a fifth between two functions that overlap, the larger value is cut to this rise. Then S
/// stays positive however much heavier a neighbour is: with random weights in one, two and three dimensions the
/// polynomial was at least 0.7, and without the cut -500. Row sums of the mass of velocities are the moments of the
/// density themselves, (w_i, rho J) = p_i, plus the row sums of the solid. With lumped masses A rho takes their place,
/// which represents the density better.
/// Tested: tests/unit/time/masses/test_mass_inverse.cpp
template <int D, int P>
class MassInverse {
 public:
  MassInverse(const Regions<D>&, const Coefficients<D>&, MassKind);
  MassInverse(const MassInverse&) = delete;

  MassKind kind() const { return kind_; }

  /// Takes the mesh of a stage: it weights scalars.
  void set_mesh(const Stage& stage) { weights_.set_mesh(stage); }
  /// Takes the meshes of two stages: the first until `take_other`, then the second; another call switches back.
  void set_meshes(const Stage& now, const Stage& later) { weights_.set_meshes(now, later); }
  void take_other() { weights_.take_other(); }
  /// Takes the moments and the density that weight velocities. With consistent masses the stage's density does.
  void set_weights(const ConstArray& moments, const ConstArray& density);

  // Arrays of the components alone. `z` is where conjugate gradients begin, which need the stage. They return their
  // iterations; -1: they failed. A right side may be a force, which is taken: zero is left of it.
  using RightSide = mass_kernels::RightSide<D>;
  /// z = factor S b for a scalar.
  int scalar(const Stage&, double factor, const RightSide& b, const Array& z, double tolerance);
  /// Whether a solve can find the weights of velocities in its own launches; and such a solve, with the moments of its
  /// right side.
  bool weighs_beside() const;
  void scalar_and_weights(const RightSide& b, const Array& z);
  /// z = factor S b for velocities.
  int velocity(const Stage&, double factor, const RightSide& b, const Array& z, double tolerance);

  /// What the launches of a solve for accelerations also do: sums with the accelerations, and unrelated rates and
  /// copies.
  struct Companions {
    Kick kick;  ///< by value of z
    ForEach<mass_kernels::TakeRates<D>> rates = {};
    ForEach<Copy> copy = {};
  };
  int velocity(const Stage&, double factor, const RightSide& b, const Array& z, double tolerance, const Companions&);
  /// The moments of which `scalar` finds the density z.
  void find_moments(const Stage&, const ConstArray& z, const Array& out);

  ConstArray scalar_sums() const { return weights_.scalar().sums; }      ///< a by control point
  ConstArray velocity_sums() const { return weights_.velocity().sums; }  ///< of one component

 private:
  /// @param beside  kernels that share launches with the three terms of the series  @param after  called with each
  /// value of z
  template <class First, class Second, class Third, class After>
  int solve(const MassWeights&, double factor, const RightSide&, const Array& z, const Counted<First>& beside,
            const Counted<Second>&, const Counted<Third>&, const After& after);
  int solve(const MassWeights& w, double factor, const RightSide& b, const Array& z) {
    return solve(w, factor, b, z, Counted<Nothing>{}, Counted<Nothing>{}, Counted<Nothing>{}, Nothing{});
  }
  template <class Apply, class Precondition>
  int solve_consistent(const MassWeights&, double factor, const RightSide& b, const Array& z, double tolerance,
                       const Apply&, const Precondition&);
  /// out = A z for scalars.
  void multiply_scalar(const ConstArray& z, const Array& out);
  /// p with S p = z.
  void invert_scalar(const ConstArray& z, const Array& p);

  const Regions<D>& regions_;
  const Coefficients<D>& coefficients_;
  MassKind kind_;
  Masses<D, P> masses_;
  KroneckerMass<D> kronecker_;
  ConjugateGradient solver_;
  MassProduct<D, P> product_;
  SceneWeights<D, P> weights_;
  EndTies<D> ties_;
  Array scaled_, next_scaled_, image_, first_;
};

}  // namespace softwet
