// Every term on a patch, in one dimension: residual against the reference assembly, product against differences.
#pragma once

#include <gtest/gtest.h>

#include "compiled.hpp"
#include "naive.hpp"
#include "solver/matrix/stencil_matrix.hpp"

namespace softwet::testing_tools {

/// Programs can be built without the kernels of reduced quadrature.
class ReducedQuadrature : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_reduced_quadrature) GTEST_SKIP() << "this program has no kernels for reduced quadrature";
  }
};

template <int D, int P = 2>
struct TermCases {
  Patch<D> patch;
  Terms terms;

  explicit TermCases(const std::array<int, D>& elements) : patch(elements, 2, P) {}
  explicit TermCases(const Patch<D>& p) : patch(p) {}

  Grid unknown(int c) const {
    const Layout<D>& l = patch.layout;
    if (c < D) return {to_host(patch.stage.unknown), l.velocity_offset(c), 0};
    return {to_host(patch.stage.unknown), c == D ? l.density_offset() : l.potential_offset(), l.wall_row};
  }
  std::vector<Grid> each(const Array& values, bool of_solid) const {
    const Layout<D>& l = patch.layout;
    std::vector<Grid> g;
    for (int d = 0; d < D; ++d)
      g.push_back({to_host(values), of_solid ? l.displacement_offset(d) : l.velocity_offset(d), 0});
    return g;
  }
  NaiveMotion<D> motion(const Array& displacement) const {
    return {each(displacement, true), each(patch.stage.unknown, false), patch.blend};
  }

  std::vector<Grid> slots(const NavierStokesKorteweg&) const {
    std::vector<Grid> s = each(patch.stage.unknown, false);
    for (const Grid& g : each(patch.stage.acceleration, false)) s.push_back(g);
    s.push_back(unknown(D));
    s.push_back(unknown(D + 1));
    return s;
  }
  std::vector<Grid> slots(const VariationalDerivative&) const { return {unknown(D)}; }
  std::vector<Grid> slots(const GradientWall&) const { return {unknown(D)}; }
  std::vector<Grid> slots(const EnergyWall&) const { return {unknown(D)}; }
  std::vector<Grid> slots(const LineFriction&) const {
    return {unknown(D), {to_host(patch.stage.acceleration), patch.layout.density_offset(), patch.layout.wall_row}};
  }
  std::vector<Grid> slots(const CapillaryTraction&) const { return {unknown(D), unknown(D + 1)}; }
  template <class Law>
  std::vector<Grid> slots(const PaintedWall<Law>&) const {
    return {unknown(D), of_given()};
  }
  std::vector<Grid> slots(const WallTension&) const { return {unknown(D), of_given()}; }
  template <class Law>
  std::vector<Grid> slots(const StretchedWall<Law>& wall) const {
    return slots(wall.law);
  }
  std::vector<Grid> slots(const SurfaceTension&) const { return each(patch.stage.displacement, true); }
  std::vector<Grid> slots(const SurfaceElasticity&) const { return each(patch.stage.displacement, true); }
  std::vector<Grid> slots(const Foundation&) const { return each(patch.stage.displacement, true); }
  std::vector<Grid> slots(const Dashpots&) const { return each(patch.stage.unknown, false); }
  std::vector<Grid> slots(const Fibres&) const { return each(patch.stage.displacement, true); }
  std::vector<Grid> slots(const KelvinVoigt&) const {
    std::vector<Grid> s = each(patch.stage.displacement, true);
    for (const Grid& g : each(patch.stage.unknown, false)) s.push_back(g);
    return s;
  }
  std::vector<Grid> slots(const BranchStress&) const { return each(patch.stage.lag, true); }
  std::vector<Grid> slots(const FiniteBranchStress&) const { return each(patch.stage.displacement, true); }
  std::vector<Grid> slots(const GradedSolid&) const {
    std::vector<Grid> s = slots(terms.solid);
    s.push_back(of_given());
    return s;
  }
  /// A random field on all rows of the patch.
  GivenField<double> given() const {
    Patch<D> p = patch;
    return {p.draw(patch.layout.rows * patch.layout.row_size, 0.4, 1.2), 0};
  }
  Grid of_given() const { return {to_host(given().values), 0, 0}; }
  template <class Material>
  std::vector<Grid> slots(const Elastodynamics<Material>&) const {
    std::vector<Grid> s = each(patch.stage.acceleration, false);
    for (const Grid& g : each(patch.stage.displacement, true)) s.push_back(g);
    return s;
  }
  static std::vector<int> equations(const NavierStokesKorteweg&) { return D == 2 ? from(0, 4) : from(0, 5); }
  static std::vector<int> equations(const VariationalDerivative&) { return {D + 1}; }
  static std::vector<int> equations(const GradientWall&) { return {D + 1}; }
  static std::vector<int> equations(const EnergyWall&) { return {D + 1}; }
  static std::vector<int> equations(const LineFriction&) { return {D + 1}; }
  template <class Law>
  static std::vector<int> equations(const PaintedWall<Law>&) {
    return {D + 1};
  }
  template <class Law>
  static std::vector<int> equations(const StretchedWall<Law>& wall) {
    return equations(wall.law);
  }
  template <class Term>
  static std::vector<int> equations(const Axisymmetric<Term>& term) {
    return equations(static_cast<const Term&>(term));
  }
  /// Equations of all other terms: momentum.
  template <class Term>
  static std::vector<int> equations(const Term&) {
    return from(0, D);
  }
  static std::vector<int> from(int first, int count) {
    std::vector<int> v(count);
    for (int i = 0; i < count; ++i) v[i] = first + i;
    return v;
  }

  /// The term's residual by the reference assembly, from element rows [first, last).
  template <class Term>
  std::vector<double> naive(const Term& term, int first, int last, bool moves, int only_row = -1) const {
    std::vector<Grid> tests;
    for (int c : equations(term)) tests.push_back(unknown(c));
    const NaiveMotion<D> mesh = moves ? motion(patch.stage.displacement) : NaiveMotion<D>{};
    return naive_residual<D, Term>(patch.layout, patch.points, term, slots(term), tests, first, last,
                                   Term::where == Where::wall || Term::where == Where::bottom ? low_face
                                   : Term::where == Where::top                                ? high_face
                                                                                              : no_face,
                                   moves ? &mesh : nullptr, only_row);
  }
  /// Moments of the density at the end of the step, times their rate.
  template <class Term = DensityMoment>
  std::vector<double> naive_moments(int first, int last, bool moves) const {
    const NaiveMotion<D> mesh = moves ? motion(patch.stage.displacement_end) : NaiveMotion<D>{};
    std::vector<double> sum = naive_residual<D>(patch.layout, patch.points, Term{},
                                                {{to_host(patch.stage.density_end), 0, patch.layout.wall_row}},
                                                {unknown(D)}, first, last, false, moves ? &mesh : nullptr);
    for (double& x : sum) x *= patch.stage.moment_rate;
    return sum;
  }

  /// Motion<D, Real> is the motion of the fluid's mesh.
  template <template <int, class> class Motion, class Term>
  void check(const char* name, const Term& term, const Region<D>& region, int first, int last,
             int only_row = -1) const {
    constexpr bool moves = std::is_same_v<Motion<D, double>, WallMotion<D>>;
    check_piece<Motion>(name, term, region, Instant::stage, naive(term, first, last, moves, only_row));
  }
  template <template <int, class> class Motion, class Term>
  void check_piece(const char* name, const Term& term, const Region<D>& region, Instant instant,
                   const std::vector<double>& expected) const {
    constexpr bool moves = std::is_same_v<Motion<D, double>, WallMotion<D>>;
    const PieceOf<D, P, Term, Motion<D, double>, double> piece(name, region, region, term, patch.blend, instant,
                                                               given());
    const PieceOf<D, P, Term, Motion<D, float>, float> single(name, region, region, term, patch.blend, instant,
                                                              given());
    const std::vector<double> found = patch.residual(piece, patch.stage);
    ASSERT_GT(largest(expected), 1e-6) << name;
    EXPECT_LT(distance(found, expected), 1e-13) << name << (moves ? ", moving" : ", fixed");
    check_product(piece, moves);
    if (matrix_points<D, P> != patch.points) return;  // there is no such matrix
    check_jacobian(piece, single);
  }

  /// A term with numbers at the points. A matrix knows none of them, as a product where there are none.
  template <class Term>
  void check_remembering(const Term& term) const {
    TermCases cases(patch.with_point_memory(memory_size_of<typename Term::template Trial<double, D>>));
    cases.patch.stage.branch_weight = 0.7;
    std::vector<double> expected = cases.naive(term, 0, patch.layout.solid_elements, false);
    for (double& x : expected) x *= 0.7;
    const Region<D> solid = patch.solid();
    const PieceOf<D, P, Term, NoMotion, double> piece("branches that remember", solid, solid, term);
    const PieceOf<D, P, Term, NoMotion, float> single("branches that remember", solid, solid, term);
    ASSERT_GT(largest(expected), 1e-6);
    EXPECT_LT(distance(cases.patch.residual(piece, cases.patch.stage), expected), 1e-13);
    cases.check_product(piece, false);
    if (matrix_points<D, P> != patch.points) return;  // there is no such matrix
    TermCases forgotten(cases.patch);
    forgotten.patch.stage.lag = {};
    forgotten.check_jacobian(piece, single);
    const Array z = forgotten.patch.draw(patch.layout.size(), -1, 1);
    EXPECT_GT(distance(forgotten.patch.product(piece, z), cases.patch.product(piece, z)), 1e-4);
    EXPECT_LT(largest(forgotten.patch.residual(piece, forgotten.patch.stage)), 1e-15) << "nothing is carried";
  }

  /// The matrix, which is computed in single precision, against the product with frozen geometry.
  void check_jacobian(const Piece<D>& piece, const Piece<D, float>& single) const {
    Patch<D> p = patch;
    const Array z = p.draw(p.layout.size(), -1, 1), free("free", p.layout.size()), y("y", p.layout.size());
    Kokkos::deep_copy(free, 1.0);
    StencilMatrix<D> matrix(p.layout, free);
    const StageOf<float> stage = single_stage(p.stage);
    const Evaluation<D, float> at{p.layout, stage, {}, stage.unknown, Geometry::frozen};
    matrix.fill([&](const StencilValues& values) {
      Kokkos::deep_copy(values, 0.0f);
      single.jacobian(at, matrix.stencil(), values);
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

  template <template <int, class> class Motion>
  void check_fluid() const {
    const int low = patch.layout.solid_elements, high = patch.layout.axis[D - 1].elements();
    check<Motion>("navier_stokes_korteweg", terms.fluid, patch.fluid(), low, high);
    constexpr bool moves = std::is_same_v<Motion<D, double>, WallMotion<D>>;
    check_piece<Motion>("density_moment", DensityMoment{}, patch.fluid(), Instant::end,
                        naive_moments(low, high, moves));
  }
  template <template <int, class> class Motion>
  void check_wall() const {
    const int low = patch.layout.solid_elements;
    check<Motion>("gradient_wall", terms.gradient_wall, patch.face(), low, low + 1);
    check<Motion>("energy_wall", terms.energy_wall, patch.face(), low, low + 1);
    check<Motion>("capillary_traction", terms.traction, patch.layer(), low, low + 1, patch.layout.wall_row);
    const EnergyWall of_one{0.4, 1, 1e-2, terms.gas, terms.state};
    TermCases(patch.with_rates())
        .template check<Motion>("line_friction", LineFriction{0.3, 0.8, terms.energy_wall}, patch.face(), low, low + 1);
    check<Motion>("painted gradient_wall", PaintedWall<GradientWall>{{0.4, 1, 1e-2}}, patch.face(), low, low + 1);
    check<Motion>("painted energy_wall", PaintedWall<EnergyWall>{of_one}, patch.face(), low, low + 1);
    if constexpr (!std::is_same_v<Motion<D, double>, NoMotion>) {
      const WallTension tension{WallEnergy::of(of_one)};
      check<Motion>("wall_tension", tension, patch.face(), low, low + 1);
      check<Motion>("stretched wall_tension", StretchedWall<WallTension>{tension, 0.7, 0.3}, patch.face(), low,
                    low + 1);
      check<Motion>("stretched energy_wall", StretchedWall<PaintedWall<EnergyWall>>{{of_one}, 0.7}, patch.face(), low,
                    low + 1);
    }
  }
  void check_solid() const {
    check<Still>("saint_venant_kirchhoff", terms.solid, patch.solid(), 0, patch.layout.solid_elements);
    check<Still>("hooke", terms.hooke, patch.solid(), 0, patch.layout.solid_elements);
    check<Still>("neo_hookean", terms.neo_hookean, patch.solid(), 0, patch.layout.solid_elements);
    const int top = patch.layout.solid_elements;
    for (ElasticLaw law : {ElasticLaw::saint_venant_kirchhoff, ElasticLaw::hooke, ElasticLaw::neo_hookean})
      for (const Prestretch& before : {Prestretch{}, Prestretch{true, {{1.2, 0.9, D == 2 ? 1 : 0.95}}, 0.1}})
        check<Still>("graded solid", GradedSolid{{{law, {0.8, 0.5}, before}, 1.3}}, patch.solid(), 0, top);
    check<Still>("fibres", Fibres{0.7, {{0.6, 0, 0.8}}}, patch.solid(), 0, top);
    check<Still>("viscosity", KelvinVoigt{0.4, 0.3}, patch.solid(), 0, top);
    TermCases(patch.with_branches()).template check<Still>("branches", BranchStress{}, patch.solid(), 0, top);
    check_remembering(FiniteBranchStress{});
    if constexpr (D == 2) check_remembering(Axisymmetric<FiniteBranchStress>{});
    check<Still>("surface tension", SurfaceTension{0.6}, patch.top(), top - 1, top);
    check<Still>("foundation", Foundation{0.6, 0.4}, patch.bottom(), 0, 1);
    check<Still>("dashpots", Dashpots{0.6, 0.4}, patch.bottom(), 0, 1);
    check<Still>("surface elasticity", SurfaceElasticity{0.6, 0.4}, patch.top(), top - 1, top);
  }
};

}  // namespace softwet::testing_tools
