// softwet_energies: the cost of taking the stress of a law from its energy by numbers that know their derivatives, or
// of choosing a material at run time, instead of compiling its closed form. Residual and product of each term alternate
// with the closed form, and the difference of the results is printed. usage: softwet_energies [TURNS] [NAME], 1 thread:
// OMP_NUM_THREADS=1
#include <softwet_configurations.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "kernels/solid/fibres.hpp"
#include "kernels/solid/graded.hpp"
#include "kernels/solid/surface_elasticity.hpp"
#include "kernels/solid/surface_tension.hpp"
#include "laws.hpp"
#include "run/machine.hpp"
#include "scene/equilibrium.hpp"
#include "unit/operator/patch.hpp"

namespace softwet::energies {
namespace {

struct Options {
  int turns = 40;
  const char* only = "";
} options;

/// Milliseconds of residual and product in each turn, and the last results.
struct Measured {
  std::vector<double> milliseconds[2];
  Array result[2];

  double least(int work) const { return *std::min_element(milliseconds[work].begin(), milliseconds[work].end()); }
};

template <int D>
struct Bench {
  testing_tools::Patch<D> patch;
  Array direction;
  Array ones;  ///< a given field

  explicit Bench(const std::array<int, D>& elements) : patch(elements, elements[D - 1] / 2) {
    const double step = 0.05 / elements[0];  // strains of some hundredths
    patch.stage.displacement = patch.draw(patch.layout.solid_size(), -step, step);
    direction = patch.draw(patch.layout.size(), -1, 1);
    ones = patch.draw(patch.layout.rows * patch.layout.row_size, 1, 1);
  }

  template <class Motion, class Term>
  void turn(const Term& term, const Region<D>& region, Measured& measured) const {
    for (int work = 0; work < 2; ++work) {
      const Array out("out", patch.layout.size());
      Evaluation<D> at{patch.layout, patch.stage, work == 1 ? direction : Array(), out};
      at.given = ones.data();
      const auto task = task_of<D, Term, Motion, double>(term, region, at, patch.blend);
      using List = TermList<TermOnMesh<Term, Motion>>;
      const auto start = std::chrono::steady_clock::now();
      work == 1 ? assemble<2, true, List>(task, at) : assemble<2, false, List>(task, at);
      const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
      measured.milliseconds[work].push_back(taken.count());
      measured.result[work] = out;
    }
  }

  /// Two forms of a term alternately: a row of the table.
  template <class Motion, class Closed, class Other>
  void compare(const char* name, const char* how, const Closed& closed, const Other& other,
               const Region<D>& region) const {
    if (*options.only && !std::strstr(name, options.only)) return;
    Measured first, second;
    for (int k = 0; k < options.turns; ++k) {
      turn<Motion>(closed, region, first);
      turn<Motion>(other, region, second);
    }
    row(name, how, first, second);
  }

  void row(const char* name, const char* way, const Measured& closed, const Measured& energy) const {
    std::printf("| %s | %dD | %s |", name, D, way);
    for (int work = 0; work < 2; ++work) {
      std::vector<double> ratio;
      for (int k = 0; k < options.turns; ++k)
        ratio.push_back(energy.milliseconds[work][k] / closed.milliseconds[work][k]);
      std::nth_element(ratio.begin(), ratio.begin() + options.turns / 2, ratio.end());
      std::printf(" %.3f | %.2f | %.2f | %.0e |", closed.least(work), energy.least(work) / closed.least(work),
                  ratio[options.turns / 2], difference(closed.result[work], energy.result[work]));
    }
    std::printf("\n");
    std::fflush(stdout);
  }

  /// Largest difference over the largest entry.
  static double difference(const Array& a, const Array& b) {
    const std::vector<double> x = to_host(a), y = to_host(b);
    double far = 0, size = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      far = std::max(far, std::abs(x[i] - y[i]));
      size = std::max(size, std::abs(x[i]));
    }
    return far / size;
  }

  template <class Material>
  void material(const char* name, ElasticLaw law) const {
    const LameParameters stiffness{0.8, 0.5};
    const Elastodynamics<Material> closed{{stiffness}, 1.3};
    const Region<D> region = patch.solid();
    compare<NoMotion>(name, "by entry", closed, SolidOfEnergy<Material, Way::by_entry>{{{stiffness}}, 1.3}, region);
    compare<NoMotion>(name, "at once", closed, SolidOfEnergy<Material, Way::at_once>{{{stiffness}}, 1.3}, region);
    const Elastodynamics<ChosenMaterial> chosen{{law, stiffness}, 1.3};
    compare<NoMotion>(name, "chosen at run time", closed, chosen, region);
    compare<NoMotion>(name, "and a given field", closed, GradedSolid{chosen}, region);
  }
  template <class Term>
  void term(const char* name, const Term& law, const Region<D>& region) const {
    compare<NoMotion>(name, "by entry", law, TermOfEnergy<Term, Way::by_entry>{law}, region);
    compare<NoMotion>(name, "at once", law, TermOfEnergy<Term, Way::at_once>{law}, region);
  }

  void all() const {
    material<SaintVenantKirchhoff>("`SaintVenantKirchhoff`", ElasticLaw::saint_venant_kirchhoff);
    material<Hooke>("`Hooke`", ElasticLaw::hooke);
    material<NeoHookean>("`NeoHookean`", ElasticLaw::neo_hookean);
    term("`Fibres`", Fibres{0.7, {{0.6, 0, 0.8}}}, patch.solid());
    term("`SurfaceTension`", SurfaceTension{0.6}, patch.top());
    term("`SurfaceElasticity`", SurfaceElasticity{0.6, 0.4}, patch.top());
    const VanDerWaals gas{0.39, 0.0002};
    const NavierStokesKorteweg fluid{gas, 0.1, 0.05, 0.01, 0.01};
    compare<WallMotion<D>>("`VanDerWaals` in `NavierStokesKorteweg`", "by entry", fluid, FluidOfEnergy{fluid},
                           patch.fluid());
    const EnergyWall law{0.4, 0.7, 1e-2, gas, coexistence(0.39)};
    compare<WallMotion<D>>("`EnergyWall`", "by entry", law, WallOfEnergy{WallEnergy::of(law)}, patch.face());
  }
};

template <int D, int P>
void bench() {
  if constexpr (P == 2) {
    std::array<int, D> elements;
    elements.fill(D == 2 ? 96 : 20);
    Bench<D>(elements).all();
  }
}

void run() {
  std::printf(
      "| law | | stress | residual, ms | least | median | difference | product, ms | least | median | difference "
      "|\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n");
#define SOFTWET_BENCH(D, P) bench<D, P>();
  SOFTWET_CONFIGURATIONS(SOFTWET_BENCH)
#undef SOFTWET_BENCH
}

}  // namespace
}  // namespace softwet::energies

int main(int count, char** texts) {
  const softwet::ParallelRuntime runtime(1);
  if (count > 1) softwet::energies::options.turns = std::max(1, std::atoi(texts[1]));
  if (count > 2) softwet::energies::options.only = texts[2];
  softwet::energies::run();
}
