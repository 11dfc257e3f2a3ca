#include "cli/core/describe.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "case/mesh.hpp"
#include "case/text.hpp"
#include "machine/memory.hpp"
#include "run/machine.hpp"
#include "run/memory_parts.hpp"
#include "scene/initial.hpp"
#include "scene/scene.hpp"
#include "solver/choose.hpp"
#include "time/explicit/explicit_scheme.hpp"

namespace softwet {
namespace {

/// A part of a case that is small enough to be set up here, and how many times it fits into the whole.
struct Part {
  Case part;
  double times = 1;
};

/// Equal elements, as many as the graded ones, and in the solid too.
void make_equal(Case& c) {
  const int vertical = c.dimension() - 1, rows = solid_elements(c);
  std::vector<int> elements;
  for (int d = 0; d <= vertical; ++d) elements.push_back(elements_along(c, d));
  c.domain.elements = elements;
  c.domain.grading = {};
  if (c.substrate && c.fluid) c.substrate->thickness = rows * fine_length(c, vertical);
}

/// The whole case where this machine surely holds it, else a strip of the same height: a run needs less than
/// `most_over_least` times the least memory, and what it keeps grows like the number of elements.
Part part_of(const Case& c) {
  constexpr double most_over_least = 30;
  Part p{c};
  const auto largest = [&] {
    return std::max_element(p.part.domain.elements.begin(), p.part.domain.elements.end() - 1);
  };
  if (most_over_least * least_bytes(c) > bytes_to_be_had()) make_equal(p.part);
  while (most_over_least * least_bytes(p.part) > bytes_to_be_had() && *largest() >= 4 * c.domain.degree + 2) {
    const auto axis = static_cast<std::size_t>(largest() - p.part.domain.elements.begin());
    int& elements = p.part.domain.elements[axis];
    const double before = elements;
    elements /= 2;
    p.part.domain.size[axis] *= elements / before;
    p.times *= before / elements;
    p.part.loads.clear();
    p.part.needles.clear();
  }
  return p;
}

std::string count(double number) { return std::to_string(std::lround(number)); }

template <int D, int P>
std::vector<Line> terms(const Case& c, const Scene<D, P>& scene, double times) {
  std::vector<Line> lines;
  for (const auto& entry : scene.terms().pieces().list)
    lines.push_back({entry.piece->name(), count(times * entry.piece->region().elements()) + " elements"});
  if (!c.loads.empty())
    lines.push_back({"body_force", std::to_string(c.loads.size()) + (c.loads.size() == 1 ? " box" : " boxes")});
  if (!c.needles.empty())
    lines.push_back({"needles", std::to_string(c.needles.size()) + (c.needles.size() == 1 ? " box" : " boxes")});
  return lines;
}

template <int D>
std::vector<Line> unknowns(const Layout<D>& l, double times) {
  std::vector<Line> lines{{"velocity", count(times * l.velocity_size())}};
  if (l.has_fluid) {
    lines.push_back({"density", count(times * l.scalar_size())});
    lines.push_back({"chemical_potential", count(times * l.scalar_size())});
  }
  if (l.has_solid) lines.push_back({"displacement (eliminated)", count(times * l.solid_size())});
  if (l.branches > 0) lines.push_back({"branches (eliminated)", count(times * l.memory_size())});
  lines.push_back({"solved", count(times * l.size())});
  return lines;
}

template <int D, int P>
void print_memory(const Case& c, const Scene<D, P>& scene, double times, std::ostream& out) {
  const bool large = D == 3 && times * scene.layout().size() > small_in_3d;
  const PreconditionerKind asked = c.solver.preconditioner;
  std::unique_ptr<Preconditioner> preconditioner;
  if (c.time.implicit())
    preconditioner =
        choose_preconditioner<D>(large && asked == PreconditionerKind::automatic ? PreconditionerKind::schwarz : asked,
                                 scene.layout(), scene.mask());
  const double here = bytes_to_be_had();
  double total = 0;
  std::vector<Line> lines;
  for (const auto& [name, bytes] : memory_parts(c, scene.layout(), preconditioner.get())) {
    const double whole = (name == program_part ? 1 : times) * bytes;
    lines.push_back({name, bytes_text(whole)});
    total += whole;
  }
  lines.push_back({"total", bytes_text(total)});
  lines.push_back({"to be had here", bytes_text(here)});
  print_section(out, "memory", lines);
  if (total > here)
    out << "  This is more than this machine has: 'softwet run' would refuse the case here, and needs a larger "
           "machine.\n";
}

/// Largest stable step of each explicit scheme from the first state, and the limit of kick_drift.
template <int D, int P>
std::vector<Line> step_limits(const Case& c, const Scene<D, P>& scene) {
  std::vector<Line> lines;
  const auto limit = [&](const std::string& name, double dt) {
    lines.push_back({name, "dt <= " + formatted(dt, "%.3g")});
  };
  Case probe = c;
  for (const TimeScheme scheme : {TimeScheme::kick_drift, TimeScheme::rkl2, TimeScheme::ssp_rk3}) {
    if (scene.coefficients().solid().branches.count > 0 && scheme != TimeScheme::kick_drift) continue;  // refused
    probe.time.scheme = scheme;
    const Judge<D, P> judge(scene, probe);
    ExplicitScheme<D, P> explicit_scheme(scene, probe, judge);
    State state = initial_state<D, P>(probe, scene);
    explicit_scheme.initialise(state);
    limit(word_of(scheme),
          explicit_scheme.largest_step(state, std::numeric_limits<double>::infinity()) / c.time.safety);
    if (scheme != TimeScheme::kick_drift) continue;
    for (const auto& [name, rate] : lone_rates(explicit_scheme.rates()))
      if (rate > 0) limit("  " + std::string(name) + " alone", 1 / rate);
  }
  return lines;
}

}  // namespace

template <int D, int P>
void describe_discretisation(const Case& c, std::ostream& out) {
  const Part p = part_of(c);
  const Scene<D, P> scene(p.part);
  if ((!c.waves.empty() || c.initial) && p.times == 1)
    initial_state<D, P>(c, scene);  // refuses what a run would refuse
  if (p.times > 1)
    out << "The numbers of elements, unknowns and bytes below are estimates from a part of this large mesh.\n";
  print_section(out, "terms", terms(c, scene, p.times));
  print_section(out, "unknowns", unknowns(scene.layout(), p.times));
  print_memory<D, P>(c, scene, p.times, out);
  if (p.times == 1)
    print_section(out, "explicit steps, bounded at the first state (time.mass = \"" + word_of(c.time.mass) + "\")",
                  step_limits(c, scene));
  print_section(out, "kernel",
                {{"configuration", std::to_string(D) + (c.axisymmetric() ? "D, axisymmetric, degree " : "D, degree ") +
                                       std::to_string(P) + ", " + name_of(scene.equations().precision())},
                 {"backend",
                  backend_name() + ", " + std::to_string(lanes()) + " elements per pack (" + instruction_set() + ")"}});
}

template void describe_discretisation<SOFTWET_DIMENSION, SOFTWET_DEGREE>(const Case&, std::ostream&);

}  // namespace softwet
