// The terms of a scene as a list, in one precision.
#pragma once

#include "app/case.hpp"
#include "model/piece.hpp"

namespace softwet {

template <int D, int P>
class Model;

template <int D, class Real>
struct Pieces {
  std::vector<std::unique_ptr<Piece<D, Real>>> list;  ///< those of the solid, then those of the fluid
  std::size_t first_of_fluid = 0;
  std::unique_ptr<Piece<D, Real>> variational_derivative;  ///< with the wall's law it gives the potential; double alone
  const Piece<D, Real>* wall_law = nullptr;                ///< one of the list, or none at 90 degrees
  std::unique_ptr<Piece<D, Real>> rigid_traction;    ///< of a rigid wall, for output alone
  std::unique_ptr<Piece<D, Real>> blended_traction;  ///< takes the place of the last piece, except in frozen products

  /// The pieces from number `first` on: their products where the binding has a tangent, else their residuals.
  void run(const Binding<D, Real>& binding, std::size_t first = 0) const {
    for (std::size_t i = first; i < list.size(); ++i) {
      const auto& piece = list[i];
      // A frozen product feeds a preconditioner, whose matrix has the pattern of one layer.
      const bool blended = blended_traction && piece == list.back() && binding.geometry == Geometry::exact;
      const Piece<D, Real>& chosen = blended ? *blended_traction : *piece;
      binding.tangent.data() ? chosen.product(binding) : chosen.residual(binding);
    }
  }
};

/// The pieces of a scene from its regions and parameters. Each precision has a source of its own: pieces.cpp, and
/// pieces_single.cpp, which a build may lack (CMake option SOFTWET_SINGLE).
template <int D, int P, class Real>
Pieces<D, Real> make_pieces(const Model<D, P>&, const Case&);

}  // namespace softwet
