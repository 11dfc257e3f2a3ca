// The terms of a scene as a list, in one precision.
#pragma once

#include "case/case.hpp"
#include "field/vector.hpp"
#include "scene/piece.hpp"

namespace softwet {

template <int D>
class Coefficients;
template <int D>
class Regions;

template <int D, class Real>
struct Pieces {
  /// `exact` takes the place of a piece, except in frozen products. Those feed a preconditioner, whose matrix has the
  /// pattern of the piece.
  struct Entry {
    std::unique_ptr<Piece<D, Real>> piece, exact;
  };

  std::vector<Entry> list;        ///< those of the solid, the viscous ones last, then those of the fluid
  std::size_t first_viscous = 0;  ///< of the solid: linear in its velocities
  std::size_t first_of_fluid = 0;
  std::vector<std::size_t> on_wall;                        ///< forces of the fluid on a soft wall, in the list
  std::unique_ptr<Piece<D, Real>> variational_derivative;  ///< with the wall's law it gives the potential; double alone
  const Piece<D, Real>* wall_law = nullptr;                ///< one of the list, or none at 90 degrees
  std::unique_ptr<Piece<D, Real>> friction_bend;           ///< what Newton's method adds where lines have friction
  std::unique_ptr<Piece<D, Real>> rigid_traction;          ///< of a rigid wall, for output alone

  /// Sets the result of an evaluation to the sum of the pieces from number `first` on: of their products where it has a
  /// tangent, else, in double precision, of their residuals. With a mask, what is prescribed is zero.
  void run(const Evaluation<D, Real>& at, std::size_t first = 0, const ConstArray& mask = {}) const {
    if constexpr (host_algorithms) Kokkos::deep_copy(Exec(), at.test, Real(0));
    TileSums<D, Real> sums(at.layout, at.tangent);
    Evaluation<D, Real> together = at;
    together.sums = &sums;
    for (std::size_t i = first; i < list.size(); ++i) {
      const Entry& entry = list[i];
      const Piece<D, Real>& piece = entry.exact && at.geometry == Geometry::exact ? *entry.exact : *entry.piece;
      if (at.tangent.data()) {
        piece.product(together);
      } else if constexpr (std::is_same_v<Real, double>) {
        piece.residual(together);
      }
    }
    if constexpr (!host_algorithms) {
      sums.store(at.test, mask);
    } else if (mask.data()) {
      multiply(at.test, mask);
    }
  }
};

/// The pieces of a scene from its regions and coefficients. Each precision has a source of its own: pieces.cpp and
/// pieces_single.cpp.
template <int D, int P, class Real>
Pieces<D, Real> make_pieces(const Regions<D>&, const Coefficients<D>&, const Case&);

/// The same in the coordinates (r, z), for D = 2: axisymmetric_pieces.cpp and axisymmetric_pieces_single.cpp.
template <int D, int P, class Real>
Pieces<D, Real> make_axisymmetric_pieces(const Regions<D>&, const Coefficients<D>&, const Case&);

}  // namespace softwet
