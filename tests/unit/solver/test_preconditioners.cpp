// Block LU and Schwarz against products.
#include "scene/initial.hpp"
#include "solver/direct/host/block_lu.hpp"
#include "solver/krylov/gmres.hpp"
#include "solver/schwarz/patches.hpp"
#include "solver/schwarz/schwarz.hpp"
#include "time/implicit/implicit_scheme.hpp"
#include "time/stepper.hpp"
#include "unit/field/kept_memory.hpp"
#include "unit/scene/scenes.hpp"
#include "unit/solver/random_matrix.hpp"

namespace softwet::testing_tools {
namespace {

using Make = std::unique_ptr<StencilSolver<2>>;
Assembled<2> assembled(RandomScene& s, Make solver) { return {s.layout(), s.scene.mask(), std::move(solver)}; }

int iterations(RandomScene& s, Make solver, double tolerance) {
  Assembled<2> p = assembled(s, std::move(solver));
  p.build(s.jacobian());
  const Array b = to_device<Array>(s.product(s.direction(), Geometry::frozen));
  const Array x("x", s.layout().size());
  Gmres gmres(s.layout().space(), s.layout().size(), 150);
  const auto product = [&](const Array& z, const Array& out) {
    s.scene.equations().product(s.stage(), z, out, Geometry::frozen);
  };
  const auto r = gmres.solve(
      product, [&](const Array& a, const Array& z) { p.apply(a, z); }, b, x, tolerance, 150);
  EXPECT_TRUE(r.converged);
  return r.iterations;
}

/// Relative error with which the preconditioner undoes the matrix that it is built from.
double error_of(Preconditioner& p, RandomScene& s) {
  const Array z = s.direction();
  const Array product("product", s.layout().size()), found("found", s.layout().size());
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  matrix.fill(s.jacobian());
  matrix.multiply(z, product);
  p.build(s.jacobian());
  p.apply(product, found);
  return distance(to_host(found), to_host(z));
}

Case longer(Case c, int nx, int ny) {
  c.domain.elements = {nx, ny};
  return c;
}

/// Rounding errors grow by the condition of the fronts, 1e4 and less here: from 2^-24 in single precision, and from
/// 2^-11 of half precision by as much as GMRES mends in one iteration.
TEST(BlockLu, SolvesEverySceneToItsPrecision) {
  std::vector<Case> cases{small_case(SceneKind::coupled), longer(small_case(SceneKind::coupled), 31, 18),
                          small_case(SceneKind::rigid), small_case(SceneKind::solid),
                          longer(small_case(SceneKind::rigid, WallLaw::energy, true), 23, 12)};
  for (int n : {3, 4, 5})
    cases.push_back(longer(small_case(SceneKind::rigid, WallLaw::gradient, true), n, 4));  // short axes
  for (const Case& c : cases)
    for (const auto& [precision, tolerance] :
         {std::pair{FactorPrecision::single, 1e-3}, {FactorPrecision::half, 0.05}}) {
      RandomScene s(c);
      Assembled<2> lu = assembled(s, make_block_lu<2>(s.layout(), s.scene.mask(), precision));
      EXPECT_LT(error_of(lu, s), tolerance);
      s.stage().rate_scale *= 3;  // a second build reuses the tree
      EXPECT_LT(error_of(lu, s), tolerance);
    }
}

/// || b - A M^-1 b || / || b || for the factors M of a matrix A, with the product in double precision.
template <int D>
double exact_defect(StencilSolver<D>& lu, const StencilMatrix<D>& matrix, const DenseVector& b) {
  const Array z("z", b.size());
  lu.build(matrix);
  lu.apply(to_array(b), z);
  return relative(sparse(matrix) * to_vector(z), b);
}

/// Entries are of single precision, all else is of double.
template <int D>
void expect_solution_in_double(const Shape& shape) {
  RandomMatrix<D> m(shape);
  const auto lu = make_block_lu<D>(m.layout, m.mask, FactorPrecision::full);
  EXPECT_LT(exact_defect(*lu, m.matrix, m.direction()), 1e-13);
  m.fill();  // a second build reuses the tree
  EXPECT_LT(exact_defect(*lu, m.matrix, m.direction()), 1e-13);
}

TEST(BlockLu, SolvesInDoublePrecision) {
  expect_solution_in_double<2>({{31, 18}, 6});
  expect_solution_in_double<2>({{16, 12}, 0, 3, true});
  expect_solution_in_double<3>({{8, 6, 6}, 2});
}

TEST(BlockLu, GmresReachesFullPrecisionInFewIterations) {
  RandomScene s(longer(small_case(SceneKind::coupled), 31, 18));
  const auto count = [&](FactorPrecision precision, double tolerance) {
    return iterations(s, make_block_lu<2>(s.layout(), s.scene.mask(), precision), tolerance);
  };
  EXPECT_LE(count(FactorPrecision::single, 1e-12), 6);
  EXPECT_LE(count(FactorPrecision::half, 1e-12), 12);  // half of the digits an iteration
  EXPECT_LE(count(FactorPrecision::half, 1e-4), count(FactorPrecision::single, 1e-4) + 1);
}

/// At each point the two velocities are coupled by ((1, 1), (1, 1 + gap)): singular without a gap. Else the identity.
Jacobian nearly_singular(const Layout<2>& layout, float gap) {
  return [layout, gap](const StencilValues& values) {
    const Stencil<2> stencil(layout);
    const auto host = Kokkos::create_mirror_view(values);
    Kokkos::deep_copy(host, 0.0f);
    const int middle = stencil.offsets / 2;
    for (int point = 0; point < stencil.points; ++point) {
      for (int a = 0; a < stencil.components; ++a) host(stencil.index(a, a, middle, point)) = 1;
      host(stencil.index(0, 1, middle, point)) = host(stencil.index(1, 0, middle, point)) = 1;
      host(stencil.index(1, 1, middle, point)) = 1 + gap;
    }
    Kokkos::deep_copy(values, host);
  };
}

/// At each point the two velocities are coupled by numbers whose determinant is what their last digit makes of it.
Jacobian singular_in_single(const Layout<2>& layout) {
  return [layout](const StencilValues& values) {
    const Stencil<2> stencil(layout);
    const auto host = Kokkos::create_mirror_view(values);
    Kokkos::deep_copy(host, 0.0f);
    const int middle = stencil.offsets / 2;
    for (int point = 0; point < stencil.points; ++point) {
      const float a = 0.7f + 0.3f * std::sin(point), b = 0.9f + 0.3f * std::cos(3 * point),
                  c = 1.1f + 0.2f * std::sin(7 * point);
      for (int k = 0; k < stencil.components; ++k) host(stencil.index(k, k, middle, point)) = 1;
      host(stencil.index(0, 0, middle, point)) = a;
      host(stencil.index(0, 1, middle, point)) = b;
      host(stencil.index(1, 0, middle, point)) = c;
      host(stencil.index(1, 1, middle, point)) = std::nextafter(float(double(b) * c / a), 2.0f);
    }
    Kokkos::deep_copy(values, host);
  };
}

/// || b - A M^-1 b || / || b || for the factors M of a matrix A.
double defect_of(StencilSolver<2>& lu, const StencilMatrix<2>& matrix, const Array& b) {
  const Array z("z", b.size()), product("product", b.size());
  lu.build(matrix);
  lu.apply(b, z);
  matrix.multiply(z, product);
  return distance(to_host(product), to_host(b));
}

TEST(BlockLu, FactorisesInDoublePrecisionWhereSingleIsNotEnough) {
  RandomScene s(longer(small_case(SceneKind::coupled), 31, 18));
  const auto make = [&](FactorPrecision p) { return make_block_lu<2>(s.layout(), s.scene.mask(), p); };
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  const auto sufficient = make(FactorPrecision::sufficient);
  matrix.fill(nearly_singular(s.layout(), 1));
  const double single = make(FactorPrecision::single)->bytes(), full = make(FactorPrecision::full)->bytes();
  EXPECT_GT(full, 1.4 * single);  // indices take as much in both
  const DenseVector b = to_vector(s.direction());
  EXPECT_LT(exact_defect(*sufficient, matrix, b), 0.01);
  EXPECT_LE(sufficient->bytes(), single);
  matrix.fill(singular_in_single(s.layout()));
  EXPECT_FALSE(exact_defect(*make(FactorPrecision::single), matrix, b) < 0.2);  // it may be no number
  EXPECT_LT(exact_defect(*sufficient, matrix, b), 1e-6);                        // the condition is 1e8
  EXPECT_EQ(sufficient->bytes(), single + full);
  // The next matrix gets another attempt in single precision.
  matrix.fill(nearly_singular(s.layout(), 1));
  EXPECT_LT(exact_defect(*sufficient, matrix, b), 1e-6);
  EXPECT_EQ(sufficient->bytes(), single);
}

TEST(BlockLu, StoresSinglePrecisionWhereHalfIsNotEnough) {
  RandomScene s(longer(small_case(SceneKind::coupled), 31, 18));
  const auto make = [&](FactorPrecision p) { return make_block_lu<2>(s.layout(), s.scene.mask(), p); };
  const auto half = make(FactorPrecision::half), sufficient = make(FactorPrecision::sufficient);
  StencilMatrix<2> matrix(s.layout(), s.scene.mask());
  const Array b = s.direction();
  matrix.fill(nearly_singular(s.layout(), 1));
  EXPECT_LT(defect_of(*sufficient, matrix, b), 0.01);
  EXPECT_EQ(sufficient->bytes(), half->bytes());
  matrix.fill(nearly_singular(s.layout(), 1e-5f));
  const bool narrow = half->bytes() < make(FactorPrecision::single)->bytes();
  EXPECT_TRUE(!narrow || defect_of(*half, matrix, b) > 0.2);
  EXPECT_LT(defect_of(*sufficient, matrix, b), 0.05);
  EXPECT_EQ(sufficient->bytes(), make(FactorPrecision::single)->bytes());
  // From then on it stays so, also behind a checkpoint.
  KeptMemory memory;
  sufficient->visit_memory(memory);
  const auto resumed = make(FactorPrecision::sufficient);
  memory.put_back();
  resumed->visit_memory(memory);
  matrix.fill(nearly_singular(s.layout(), 1));
  EXPECT_EQ(defect_of(*sufficient, matrix, b), defect_of(*resumed, matrix, b));
  EXPECT_EQ(sufficient->bytes(), resumed->bytes());
}

/// Up to the 16 bits of the inverse: 2^-8 in each entry, which sums of large entries that nearly cancel make 1 %.
TEST(Schwarz, OneBoxIsTheInverse) {
  for (const Case& c : {small_case(SceneKind::coupled), small_case(SceneKind::rigid, WallLaw::energy, true)}) {
    RandomScene s(c);
    Assembled<2> p = assembled(s, make_schwarz<2>(s.layout(), s.scene.mask(), {100, 100, false}));
    EXPECT_LT(error_of(p, s), 0.03);
  }
}

TEST(Patches, HoldEveryUnknownAndNeverEndOnTheSharedRow) {
  const RandomScene s(longer(small_case(SceneKind::coupled), 31, 18));
  const UnknownTable<2> table(s.layout(), to_host(s.scene.mask()));
  const int row_size = s.layout().row_size, shared = s.layout().wall_row;
  for (const auto& [width, stride] : {std::pair{3, 2}, {4, 3}, {5, 4}, {6, 5}, {8, 6}, {9, 3}}) {
    const PatchTables t = make_patches(s.layout(), table, width, stride);
    std::vector<int> boxes(s.layout().size(), 0);
    for (int box = 0; box < t.count; ++box)
      for (int i = 0; i < t.size[box]; ++i) {
        const int unknown = t.dof[box * t.unknowns + i], row = table.point(unknown) / row_size;
        ++boxes[unknown];
        const int below = row - t.start[2 * box + 1];
        EXPECT_FALSE(row == shared && (below == 0 || below == width - 1)) << "width " << width << ", box " << box;
      }
    for (int i = 0; i < s.layout().size(); ++i) EXPECT_EQ(boxes[i] > 0, table.component(i) >= 0) << width << " " << i;
  }
}

TEST(Schwarz, WiderBoxesHelp) {
  for (const Case& c : {longer(small_case(SceneKind::coupled), 31, 18),
                        longer(small_case(SceneKind::rigid, WallLaw::energy, true), 31, 18)}) {
    RandomScene s(c);
    int before = 150;
    for (int width : {5, 8, 12}) {
      const int now = iterations(s, make_schwarz<2>(s.layout(), s.scene.mask(), {width, width - 2, false}), 1e-6);
      EXPECT_LT(now, before) << "width " << width;
      before = now;
    }
  }
}

TEST(Schwarz, CoarseSpaceHelps) {
  for (const Case& c : {longer(small_case(SceneKind::coupled), 32, 18),
                        longer(small_case(SceneKind::rigid, WallLaw::energy, true), 32, 16)}) {
    RandomScene s(c);
    const auto count = [&](bool coarse) {
      return iterations(s, make_schwarz<2>(s.layout(), s.scene.mask(), {5, 4, coarse}), 1e-4);
    };
    EXPECT_LT(count(true), 0.8 * count(false));
  }
}

/// A droplet put on a soft layer, after nine steps.
Case soft_droplet() {
  Case c = small_case(SceneKind::coupled);
  c.domain.size = {0.8, 0.4};
  c.domain.elements = {48, 24};
  c.fluid = Fluid{};
  c.fluid->viscosity = 0.01;
  c.fluid->capillarity = 0.025;
  c.fluid->temperature = 0.39;
  c.fluid->contact_angle = 75;
  *c.substrate = {.thickness = 0.4 / 3, .density = 1, .young = 1.9, .poisson = 0.45};
  c.loads.clear();
  c.droplets = {{.centre = {0.4, 0.4 / 3}, .radius = 0.15}};
  c.time.dt_initial = 1e-3;
  c.time.tolerance = 4e-3;
  c.solver.newton_rtol = 1e-4;
  return c;
}

/// The operator moves the mesh, the boxes' matrices do not know.
TEST(Schwarz, HelpsWhereTheMeshMoves) {
  const Case c = soft_droplet();
  const Scene<2, 2> scene(c);
  Stepper<2, 2> stepper(scene, c, {});
  GeneralizedAlpha<2, 2>& scheme = static_cast<ImplicitScheme<2, 2>&>(stepper.scheme()).integrator();
  State state = initial_state<2, 2>(c, scene);
  scheme.initialise(state);
  stepper.start(state);
  for (int i = 0; i < 9; ++i) stepper.step();
  Array r("r", scheme.size()), x("x", scheme.size());
  scheme.begin(stepper.state(), 0.03);
  scheme.residual(stepper.state().unknown, r);
  // Every field starts with the same share of the norm, as in Newton's method.
  const Layout<2>& l = scene.layout();
  const int end[] = {0, l.density_offset(), l.potential_offset(), l.size()};
  double weight[3];
  for (int f = 0; f < 3; ++f) weight[f] = 1 / norm(l.space(), part(r, end[f], end[f + 1]));
  const auto scale = [&](const Array& a, int exponent) {
    for (int f = 0; f < 3; ++f) {
      const Array field = Kokkos::subview(a, Kokkos::make_pair(end[f], end[f + 1]));
      combine(field, std::pow(weight[f], exponent), field, 0);
    }
  };
  Assembled<2> p(l, scene.mask(), make_schwarz<2>(l, scene.mask(), {6, 5}));
  p.build([&](const StencilValues& values) { scheme.jacobian(values); });
  const auto product = [&](const Array& z, const Array& out) {
    scheme.product(z, out);
    scale(out, 1);
  };
  const auto precondition = [&](const Array& a, const Array& z) {
    const Array unscaled("unscaled", a.extent(0));
    Kokkos::deep_copy(unscaled, a);
    scale(unscaled, -1);
    p.apply(unscaled, z);
  };
  scale(r, 1);
  const KrylovResult result = Gmres(l.space(), scheme.size(), 60).solve(product, precondition, r, x, 1e-2, 60);
  std::printf("  %d iterations\n", result.iterations);
  EXPECT_LE(result.iterations, 14);
}

}  // namespace
}  // namespace softwet::testing_tools
