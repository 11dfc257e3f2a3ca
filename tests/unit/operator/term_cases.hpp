// Every term on a patch, in one dimension: residual against the reference assembly, product against differences.
#pragma once

#include <gtest/gtest.h>

#include "naive.hpp"
#include "solver/stencil.hpp"

namespace softwet::testing_tools {

template <int D>
struct TermCases {
  Patch<D> patch;
  Terms terms;

  explicit TermCases(const std::array<int, D>& elements) : patch(elements, 2) {}
  explicit TermCases(const Patch<D>& p) : patch(p) {}

  Component unknown(int c) const {
    const Layout<D>& l = patch.layout;
    if (c < D) return {to_host(patch.stage.unknown), l.velocity_offset(c), 0};
    return {to_host(patch.stage.unknown), c == D ? l.density_offset() : l.potential_offset(), l.wall_row};
  }
  Component acceleration(int d) const {
    return {to_host(patch.stage.acceleration), patch.layout.velocity_offset(d), 0};
  }
  Component displacement(int d) const {
    return {to_host(patch.stage.displacement), patch.layout.displacement_offset(d), 0};
  }
  NaiveMotion<D> motion() const {
    NaiveMotion<D> m;
    for (int d = 0; d < D; ++d) {
      m.displacement.push_back(displacement(d));
      m.displacement_end.push_back({to_host(patch.stage.displacement_end), patch.layout.displacement_offset(d), 0});
      m.velocity.push_back(unknown(d));
    }
    m.blend = patch.blend;
    return m;
  }

  std::vector<Component> slots(const NavierStokesKorteweg&) const {
    std::vector<Component> s;
    for (int d = 0; d < D; ++d) s.push_back(unknown(d));
    for (int d = 0; d < D; ++d) s.push_back(acceleration(d));
    s.push_back(unknown(D));
    s.push_back(unknown(D + 1));
    s.push_back({to_host(patch.stage.density_end), 0, patch.layout.wall_row});
    return s;
  }
  std::vector<Component> slots(const GradientWall&) const { return {unknown(D)}; }
  std::vector<Component> slots(const EnergyWall&) const { return {unknown(D)}; }
  std::vector<Component> slots(const CapillaryTraction&) const { return {unknown(D), unknown(D + 1)}; }
  std::vector<Component> slots(const Elastodynamics&) const {
    std::vector<Component> s;
    for (int d = 0; d < D; ++d) s.push_back(acceleration(d));
    for (int d = 0; d < D; ++d) s.push_back(displacement(d));
    return s;
  }

  /// The term's residual by the reference assembly, from element rows [first, last).
  template <class Term>
  std::vector<double> naive(const Term& term, int first_test, int channels, int first, int last, bool face, bool moves,
                            int only_row = -1) const {
    std::vector<Component> tests;
    for (int c = 0; c < channels; ++c) tests.push_back(unknown(first_test + c));
    const NaiveMotion<D> mesh = moves ? motion() : NaiveMotion<D>{};
    return naive_residual<D, Term>(patch.layout, term, slots(term), tests, first, last, face, moves ? &mesh : nullptr,
                                   only_row);
  }

  template <int QL, class Motion, class Term>
  void check(const char* name, Term term, const Region<D>& region, Components components, int channels, int first,
             int last, int only_row = -1) const {
    const PieceOf<D, 2, QL, Term, Motion> piece(name, region, term, components, patch.blend);
    if constexpr (std::is_same_v<Term, NavierStokesKorteweg>) term.moment_rate = patch.stage.moment_rate;
    constexpr bool moves = std::is_same_v<Motion, WallMotion<D>>;
    const std::vector<double> expected = naive(term, components.test, channels, first, last, QL == 1, moves, only_row);
    const std::vector<double> found = patch.residual(piece, patch.stage);
    ASSERT_GT(largest(expected), 1e-6) << name;
    EXPECT_LT(distance(found, expected), 1e-13) << name << (moves ? ", moving" : ", fixed");
    check_product(piece, moves);
    check_jacobian(piece);
  }

  /// The assembled matrix against the product with frozen geometry; its entries are rounded to single precision.
  void check_jacobian(const Piece<D>& piece) const {
    Patch<D> p = patch;
    const Array z = p.draw(p.layout.size(), -1, 1), free("free", p.layout.size()), y("y", p.layout.size());
    Kokkos::deep_copy(free, 1.0);
    StencilMatrix<D> matrix(p.layout, free);
    const Binding<D> binding{p.layout, p.stage, {}, p.stage.unknown, Geometry::frozen};
    matrix.fill([&](const StencilValues& values) {
      Kokkos::deep_copy(values, 0.0f);
      piece.jacobian(binding, matrix.stencil(), values);
    });
    matrix.multiply(z, y);
    EXPECT_LT(distance(to_host(y), p.product(piece, z, Geometry::frozen)), 1e-6) << piece.name();
  }

  void check_product(const Piece<D>& piece, bool depends_on_mesh) const {
    Patch<D> p = patch;
    const Array z = p.draw(p.layout.size(), -1, 1);
    const std::vector<double> exact = p.product(piece, z), difference = p.difference(piece, z, 1e-4);
    const double error = distance(exact, difference);
    EXPECT_LT(error, 1e-9) << piece.name();
    std::printf("  %d-D %-28s product against differences: %.1e\n", D, piece.name(), error);
    const double frozen = distance(p.product(piece, z, Geometry::frozen), exact);
    if (depends_on_mesh) {
      EXPECT_GT(frozen, 1e-4) << piece.name() << ": the shape derivative is missing";
    }
  }

  template <class Motion>
  void check_fluid() const {
    const int low = patch.layout.solid_elements, high = patch.layout.axis[D - 1].elements();
    check<3, Motion>("navier_stokes_korteweg", terms.fluid, patch.fluid(), {0, 0}, D + 2, low, high);
  }
  template <class Motion>
  void check_wall() const {
    const int low = patch.layout.solid_elements;
    check<1, Motion>("gradient_wall", terms.gradient_wall, patch.face(), {D, D + 1}, 1, low, low + 1);
    check<1, Motion>("energy_wall", terms.energy_wall, patch.face(), {D, D + 1}, 1, low, low + 1);
    check<3, Motion>("capillary_traction", terms.traction, patch.layer(), {D, 0}, D, low, low + 1,
                     patch.layout.wall_row);
  }
  void check_solid() const {
    check<3, NoMotion>("elastodynamics", terms.solid, patch.solid(), {0, 0}, D, 0, patch.layout.solid_elements);
  }
};

}  // namespace softwet::testing_tools
