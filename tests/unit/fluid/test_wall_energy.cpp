// The wall energy, its force, and the excess that they are made of, against decimals of 40 digits.
#include "kernels/fluid/wall_energy.hpp"

#include <gtest/gtest.h>

#include "scene/equilibrium.hpp"
#include "spline/axis.hpp"

namespace softwet {
namespace {

/// One density: D, its derivative, and the integral of sqrt(2 D + d^2) - d from the vapour for d = 1e-5 and 1e-3.
struct Row {
  double density, excess, slope, integral_sharp, integral_smooth;
};
struct Scene {
  Coexistence state;
  double theta;
  std::vector<Row> rows;
  VanDerWaals gas() const { return {theta, 0.2 * state.density_vapour}; }
  EnergyWall law(double smoothing) const { return {0.1, 0.5, smoothing, gas(), state}; }
};
// From tests/oracle/wall_energy.py. The first density is continued, the last one is beyond the table.
const std::vector<Scene> scenes = {
    {{0.001352289800692532, 0.86669909966079184, 0.0001546475126558792, -0.65019109012614495},
     0.39,
     {{-0.085182391185317397, 1.5693071249520854, -36.543403167658845, -0.076088870544297346, -0.076003508412204837},
      {0.001265755119706522, 3.2037253547676836e-07, -0.0074887074041582822, -3.3669515829412608e-08,
       -8.4629882683897981e-09},
      {0.0014388244816785419, 3.0670681725350983e-07, 0.0070145527644028963, 3.3172007597177246e-08,
       8.2137376475220248e-09},
      {0.087886970786702462, 0.025812137625968408, 0.33074033952087167, 0.012196497582346904, 0.012111465031717637},
      {0.43393916004975619, 0.08066667098224499, -0.044261760070846062, 0.13526731377695592, 0.13484018792019792},
      {0.43411222941172822, 0.080658993122017117, -0.044464051347755551, 0.13533682599053032, 0.13490952901052808},
      {0.78016441867478192, 0.012943260051229817, -0.23812684661667255, 0.24570237147359172, 0.24493305887433836},
      {0.86661256497980588, 2.0594087226851759e-08, -0.0004758434582935993, 0.25319408830118112, 0.25234055656305288},
      {0.86678563434177791, 2.0616533835073847e-08, 0.0004766216415008592, 0.2531941043165799, 0.25234055774452663},
      {0.88400603585799387, 0.00092356104940154377, 0.11308418886634587, 0.25355872292760651, 0.25268908211164953},
      {0.95323378064680175, 0.04335761704760531, 1.5630080859329161, 0.26423634534248891, 0.26329846253011846}}},
    {{0.042674100555262266, 0.71348084950190427, 0.0074243876697013154, -0.51384678764896652},
     0.7,
     {{-0.024406574339401937, 0.024879911544166366, -1.0287365287570129, -0.006176370671570253, -0.0061114869915861797},
      {0.042607019880367601, 7.4376589574567675e-09, -0.00022183768352654495, -3.5210335717774012e-09,
       -1.6590682357382561e-10},
      {0.042741181230156931, 7.4262697684072805e-09, 0.0002213283328947435, 3.5189636268632636e-09,
       1.6571676349432543e-10},
      {0.10975477544992647, 0.0041248067579057095, 0.09315985176931163, 0.0033322121069600348, 0.0032675488392654773},
      {0.37801039435368861, 0.019727550311508479, -0.012005244066807403, 0.048359868058916303, 0.04803046731718591},
      {0.37814455570347794, 0.019725934436591871, -0.012083284502826846, 0.048386515054396104, 0.048056981830611911},
      {0.64640017460724009, 0.00261888162143526, -0.06727473346227808, 0.089850876246194686, 0.089256704367322456},
      {0.71341376882700958, 3.4662749977694527e-09, -0.00010333164532608894, 0.092394225121830653,
       0.091735965005713654},
      {0.71354793017679896, 3.4682626623445996e-09, 0.00010342053819815759, 0.092394229633281186, 0.091735965160610583},
      {0.72689698448083706, 0.00014692640645732894, 0.022538852197484277, 0.092507983022952239, 0.09183804142338152},
      {0.78056152439656845, 0.0046714751179284045, 0.16108502735202682, 0.095476843782511062, 0.09475437714326658}}},
    {{0.1930049756072503, 0.48724244791899246, 0.030069601606091852, -0.43989578665289253},
     0.95,
     {{0.16358122837607608, 0.00013219565081887112, -0.010061946147849164, -0.0002295897308118775,
       -0.00020429377574066607},
      {0.19297555186001913, 1.0367451421381676e-10, -7.0478695529733598e-06, -8.2293880524754241e-11,
       -1.016736256635926e-12},
      {0.1930343993544815, 1.0362311699307846e-10, 7.0426291713847175e-06, 8.22689182381252e-11, 1.016358208051386e-12},
      {0.22242872283842452, 8.0354768982436942e-05, 0.004745827552577, 0.00019450012226220244, 0.00016943570346693933},
      {0.3400942880158902, 0.00055442499894442282, -0.00033153381140925496, 0.0033393680599533718,
       0.0032001706046190298},
      {0.34015313551035253, 0.00055440531687328228, -0.00033738398673175633, 0.0033413270404456445,
       0.0032020722094240591},
      {0.45781870068781821, 6.9160533349796926e-05, -0.0041829210533731228, 0.0063886304651851527,
       0.0061353446676437051},
      {0.48721302417176127, 8.5370460306079205e-11, -5.802241325310485e-06, 0.0065677453522206917,
       0.0062896745139652491},
      {0.48727187166622365, 8.5404941451422975e-11, 5.8057569698419106e-06, 0.0065677454916751596,
       0.0062896745156401567},
      {0.49312719736522731, 3.5551162682817043e-06, 0.0012322590321137462, 0.0065754812619055027, 0.006294014976474983},
      {0.51666619515016665, 0.00010370985969607451, 0.0077101625558652822, 0.0067727539758596442,
       0.0064696922043443669}}}};

/// What the rounding of the density and of the sums costs D.
double rounding_of_excess(const Row& r, double epsilon, double sums) {
  return epsilon * (std::abs(r.slope * r.density) + sums * r.excess);
}
/// Rounding in double precision, with the rounding of the small coefficients, which are the difference of numbers 1/(1
/// - theta) times larger.
double rounding_of_excess(const Scene& s, const Row& r) { return rounding_of_excess(r, 2.3e-16, 5 / (1 - s.theta)); }

TEST(Excess, AllDigitsCloseToThePhases) {
  for (const Scene& s : scenes)
    for (const Row& r : s.rows)
      EXPECT_NEAR(s.state.excess(s.gas(), r.density), r.excess, rounding_of_excess(s, r)) << r.density;
}

TEST(Excess, SinglePrecisionKeepsItsDigits) {
  using P = Pack<float>;
  for (const Scene& s : scenes)
    for (const Row& r : s.rows) {
      const P excess = s.state.excess(s.gas(), P(static_cast<float>(r.density)));
      EXPECT_NEAR(excess[0], r.excess, rounding_of_excess(r, 1.2e-7, 20)) << r.density;
    }
}

// Compares with the same density in double precision; errors are given as parts of the largest force and of its largest
// derivative.
TEST(Excess, ForceAndDerivativeInSinglePrecision) {
  using P = Pack<float>;
  for (const Scene& s : scenes) {
    const EnergyWall law = s.law(1e-5);
    double force = 0, slope = 0, error = 0, error_of_slope = 0;
    for (int i = 0; i < 20000; ++i) {
      const float rho = static_cast<float>(0.7 * s.state.density_vapour + 4.5e-5 * i);
      if (rho > s.state.density_liquid + 0.02) break;
      const Dual<P> found = law.force(Dual<P>(P(rho), P(1.0f)));
      const Dual<double> exact = law.force(Dual<double>(rho, 1.0));
      force = std::max(force, std::abs(exact.value));
      slope = std::max(slope, std::abs(exact.tangent));
      error = std::max(error, std::abs(found.value[0] - exact.value));
      error_of_slope = std::max(error_of_slope, std::abs(found.tangent[0] - exact.tangent));
    }
    std::printf("  theta = %.2f: force %.1e, derivative %.1e\n", s.theta, error / force, error_of_slope / slope);
    EXPECT_LT(error, 2e-6 * force);
    EXPECT_LT(error_of_slope, 1e-6 * slope);
  }
}

TEST(Excess, TangentIsTheDerivative) {
  for (const Scene& s : scenes)
    for (const Row& r : s.rows) {
      const Dual<double> d = s.state.excess(s.gas(), Dual<double>(r.density, 2.0));
      EXPECT_NEAR(d.value, r.excess, rounding_of_excess(s, r));
      EXPECT_NEAR(d.tangent, 2 * r.slope, 1e-13 * std::abs(r.slope) + 1e-15) << r.density;
    }
}

TEST(WallEnergy, AgainstDecimals) {
  for (const Scene& s : scenes) {
    const WallEnergy sharp = WallEnergy::of(s.law(1e-5)), smooth = WallEnergy::of(s.law(1e-3));
    const double tension = s.rows[8].integral_sharp;
    for (const Row& r : s.rows) {
      const double error = 0.05 * tension * (r.density < 0 ? 1e-8 : 1e-12);  // far below the vapour: by quadrature
      EXPECT_NEAR(sharp.value(r.density), -0.05 * r.integral_sharp, error) << r.density;
      EXPECT_NEAR(smooth.value(r.density), -0.05 * r.integral_smooth, error) << r.density;
    }
  }
}

// Between a tenth and nine tenths of the step in density, where the force is smooth, against Gauss-Legendre quadrature.
TEST(WallEnergy, AtEveryTemperature) {
  for (const double theta : {0.2, 0.3, 0.6, 0.9, 0.99}) {
    const Coexistence s = coexistence(theta);
    const EnergyWall law{0.1, 0.5, 1e-5, {theta, 0.2 * s.density_vapour}, s};
    const WallEnergy wall = WallEnergy::of(law);
    const Gauss rule(20);
    const double step = s.density_liquid - s.density_vapour, from = s.density_vapour + 0.1 * step;
    const double tension = wall.value(s.density_vapour) - wall.value(s.density_liquid);
    const int panels = 16;
    double sum = 0;
    for (int p = 1; p <= panels; ++p) {
      const double width = 0.8 * step / panels, start = from + (p - 1) * width;
      for (int q = 0; q < 20; ++q) sum += rule.weight[q] * width * law.force(start + width * rule.point[q]);
      EXPECT_NEAR(wall.value(from) - wall.value(start + width), sum, 1e-12 * tension) << theta << ", panel " << p;
    }
  }
}

TEST(WallEnergy, IsTheIntegralOfTheForce) {
  for (const double smoothing : {1e-5, 1e-3}) {
    const WallEnergy wall = WallEnergy::of(scenes[0].law(smoothing));
    for (double rho = 0.02; rho < 0.96; rho += 0.043) {
      const double e = 1e-3;
      const double slope =
          (8 * (wall.value(rho + e) - wall.value(rho - e)) - wall.value(rho + 2 * e) + wall.value(rho - 2 * e)) /
          (12 * e);
      EXPECT_NEAR(slope, -wall.law.force(rho), 1e-9) << rho;
    }
    EXPECT_NEAR(wall.value(wall.law.state.density_vapour), 0, 1e-17);
  }
}

TEST(WallEnergy, PacksOfBothPhasesAndOutside) {
  using P = Pack<double>;
  constexpr int lanes = Lanes<P>::count;
  const Scene& s = scenes[0];
  const WallEnergy wall = WallEnergy::of(s.law(1e-5));
  for (std::size_t first = 0; first + 1 < s.rows.size(); ++first) {
    double rho[lanes], one[lanes];
    for (int l = 0; l < lanes; ++l) {
      rho[l] = s.rows[(first + l) % s.rows.size()].density;
      one[l] = 1;
    }
    const P plain = wall.value(load<P>(rho));
    const Dual<P> dual = wall.value(Dual<P>(load<P>(rho), load<P>(one)));
    for (int l = 0; l < lanes; ++l) {
      EXPECT_NEAR(plain[l], wall.value(rho[l]), 1e-17 + 1e-14 * std::abs(wall.value(rho[l])));
      EXPECT_NEAR(dual.value[l], plain[l], 1e-17 + 1e-14 * std::abs(plain[l]));
      EXPECT_NEAR(dual.tangent[l], -wall.law.force(rho[l]), 1e-15);
    }
  }
}

// f_w(liquid) - f_w(vapour) = -cos(alpha) sigma: Young's law. The tension at theta = 0.39, to ten digits:
// equilibrium.py.
TEST(WallEnergy, GivesYoungsLaw) {
  const WallEnergy wall = WallEnergy::of(scenes[0].law(0));
  EXPECT_NEAR(wall.value(wall.law.state.density_liquid), -0.5 * 0.1 * 0.2532027493, 1e-9 * 0.0126);
}

}  // namespace
}  // namespace softwet
