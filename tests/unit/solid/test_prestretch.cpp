// A law seen from a stretched state: it has the stress of the whole deformation, and its energy and stress belong
// together.
#include "kernels/solid/prestretch.hpp"

#include "kernels/algebra/dual.hpp"
#include "kernels/solid/fibres.hpp"
#include "kernels/solid/graded.hpp"
#include "material_checks.hpp"

namespace softwet::testing_tools {
namespace {

/// psi^(F_0) is a number that is not 0, as in a scene.
const Prestretch before{true, {{1.3, 0.8, 1.1}}, 0.07};
/// In 2D the third axis is not stretched.
const Prestretch before_in_plane{true, {{1.3, 0.8, 1}}, 0.07};

/// A material of the kind that the checks of materials take.
template <class Law>
struct Stretched : LameParameters {
  Prestretch prestretch;

  template <class M>
  M first_piola(const M& g) const {
    return prestretch.first_piola(Law{*this}.first_piola(prestretch.whole(g)));
  }
  template <class M>
  auto energy(const M& g) const {
    return prestretch.energy(Law{*this}.energy(prestretch.whole(g)));
  }
};

template <class Law, class Test>
void with(const Test& test) {
  test(Law{{1.5, 0.7}}, Stretched<Law>{{1.5, 0.7}, before}, Stretched<Law>{{1.5, 0.7}, before_in_plane});
}
/// Calls test(law, the law stretched along three axes, the law stretched in 2D).
template <class Test>
void with_each_law(const Test& test) {
  with<SaintVenantKirchhoff>(test);
  with<NeoHookean>(test);
}

template <int D, class N = double>
Matrix<N, D> times(const Matrix<N, D>& f, const Vector<double, 3>& l) {
  Matrix<N, D> r = f;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) r(i, j) = l[j] * f(i, j);
  return r;
}

TEST(Prestretch, StressIsTheDerivativeOfTheEnergy) {
  with_each_law([](const auto&, const auto& in_space, const auto& in_plane) {
    expect_stress_of_energy<2>(in_plane);
    expect_stress_of_energy<3>(in_space);
  });
}
TEST(Prestretch, PlaneStrain) {
  with_each_law([](const auto&, const auto&, const auto& in_plane) { expect_plane_strain(in_plane, 1e-14); });
}

// sigma = P F^T / J of the law at F F_0; energies of the same piece of material differ by the energy of the stretched
// state.
TEST(Prestretch, StressAndEnergyAreThoseOfTheWholeDeformation) {
  with_each_law([](const auto& law, const auto& in_space, const auto&) {
    const Matrix<double, 3> g = random_gradient<3>(0.3),
                            whole = add_diagonal(times(add_diagonal(g, 1.0), before.stretch), -1.0);
    const auto sigma = cauchy_stress(in_space.first_piola(g), g),
               expected = cauchy_stress(law.first_piola(whole), whole);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(sigma(i, j), expected(i, j), 1e-13);
    EXPECT_NEAR(in_space.energy(g), (law.energy(whole) - 0.07) / (1.3 * 0.8 * 1.1), 1e-14);
  });
}

// In (r, z) the third stretch is that around the axis.
TEST(Prestretch, AroundAnAxis) {
  with_each_law([](const auto&, const auto& material, const auto&) {
    const Matrix<double, 2> plane = random_gradient<2>(0.3);
    const AxialMatrix<double> axial{plane, 0.15};
    const Matrix<double, 3> full{{{plane(0, 0), plane(0, 1), 0}, {plane(1, 0), plane(1, 1), 0}, {0, 0, 0.15}}};
    const auto p = material.first_piola(axial);
    const auto q = material.first_piola(full);
    EXPECT_NEAR(p.hoop, q(2, 2), 1e-14);
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) EXPECT_NEAR(p(i, j), q(i, j), 1e-14);
    EXPECT_NEAR(material.energy(axial), material.energy(full), 1e-14);
  });
}

TEST(Prestretch, OfOneIsTheLawItself) {
  with_each_law([](const auto& law, auto same, const auto&) {
    const Matrix<double, 3> g = random_gradient<3>(0.3);
    for (const Prestretch& one : {Prestretch{}, Prestretch{true, {{1, 1, 1}}, 0}}) {
      same.prestretch = one;
      const auto p = same.first_piola(g), q = law.first_piola(g);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) EXPECT_NEAR(p(i, j), q(i, j), 1e-15);
      EXPECT_NEAR(same.energy(g), law.energy(g), 1e-15);
    }
  });
}

TEST(Prestretch, RotationsOfTheStretchedStateCostNothing) {
  with_each_law([](const auto&, const auto& material, const auto&) {
    const double c = std::cos(0.7), s = std::sin(0.7);
    const Matrix<double, 3> turn{{{c, 0, -s}, {0, 1, 0}, {s, 0, c}}};
    const Matrix<double, 3> g = random_gradient<3>(0.3);
    const Matrix<double, 3> turned = add_diagonal(product(turn, add_diagonal(g, 1.0)), -1.0);
    EXPECT_NEAR(material.energy(turned), material.energy(g), 1e-14);
    const auto p = material.first_piola(turned), q = product(turn, material.first_piola(g));
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) EXPECT_NEAR(p(i, j), q(i, j), 1e-13);
  });
}

/// The product with the Jacobian, in dual numbers, against differences of fourth order.
template <int D>
void expect_product(ElasticLaw law, const Prestretch& prestretch) {
  const GradedSolid term{{{law, {1.5, 0.7}, prestretch}, 2}};
  const Matrix<double, D> g = random_gradient<D>(0.3), by = random_gradient<D>(0.9);
  GradedSolid::Trial<Dual<double>, D> t;
  for (int i = 0; i < D; ++i) {
    t.trial.acceleration[i] = 0.0;
    for (int j = 0; j < D; ++j) t.trial.displacement_gradient(i, j) = {g(i, j), by(i, j)};
  }
  t.given = 0.4;
  const auto product = term.residual(t).momentum_flux;
  const auto flux = [&](double step) {
    return term.residual(GradedSolid::Trial<double, D>{{{}, g + step * by}, 0.4}).momentum_flux;
  };
  const double e = 3e-4;
  const auto a = flux(e), b = flux(-e), c = flux(2 * e), d = flux(-2 * e);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      EXPECT_NEAR(product(i, j).tangent, (8 * (a(i, j) - b(i, j)) - c(i, j) + d(i, j)) / (12 * e), 1e-9);
}
TEST(Prestretch, ProductsAreExact) {
  for (const ElasticLaw law : {ElasticLaw::saint_venant_kirchhoff, ElasticLaw::neo_hookean}) {
    expect_product<2>(law, before_in_plane);
    expect_product<3>(law, before);
  }
}

// k/2 (|F F_0 a_0|^2 - 1)^2 / J_0, less its value at F = I.
TEST(Prestretch, OfFibres) {
  const Fibres plain{0.7, {{0.48, 0.6, 0.64}}}, stretched = plain.after(before);
  const auto whole = [&](const Matrix<double, 3>& g) {
    const Matrix<double, 3> f = times(add_diagonal(g, 1.0), before.stretch);
    double square = 0;
    for (int i = 0; i < 3; ++i) square += std::pow(f(i, 0) * 0.48 + f(i, 1) * 0.6 + f(i, 2) * 0.64, 2);
    return 0.35 * (square - 1) * (square - 1) / before.volume_ratio();
  };
  const Matrix<double, 3> g = random_gradient<3>(0.3);
  EXPECT_NEAR(stretched.energy(SolidStrain<double, 3>{g}), whole(g) - whole({}), 1e-13);
  EXPECT_EQ(stretched.energy(SolidStrain<double, 3>{{}}), 0);
  const auto p = stretched.residual(SolidStrain<double, 3>{g}).momentum_flux;
  const double e = 1e-3;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto at = [&](double step) {
        Matrix<double, 3> h = g;
        h(i, j) += step;
        return whole(h);
      };
      EXPECT_NEAR((8 * (at(e) - at(-e)) - at(2 * e) + at(-2 * e)) / (12 * e), p(i, j), 1e-10);
    }
  const Fibres same = plain.after({});
  EXPECT_EQ(same.stiffness, 0.7);
  EXPECT_EQ(same.excess, 0);
}

}  // namespace
}  // namespace softwet::testing_tools
