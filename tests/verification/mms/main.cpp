// softwet_mms: the error of one computation against an exact solution, one csv row per field.
// usage: softwet_mms [name=value ...]; names and defaults in `usage` below.
#include <softwet_configurations.hpp>

#include <cstdio>
#include <cstring>
#include <map>

#include "case/error.hpp"
#include "problem.hpp"
#include "run/machine.hpp"
#include "solver/choose.hpp"

namespace softwet::mms {
namespace {

const char* const usage =
    "usage: softwet_mms [name=value ...]\n"
    "  scene=fluid            fluid, solid or coupled\n"
    "  course=linear          fields linear in time, or harmonic\n"
    "  dimension=2 degree=2   a configuration of this program\n"
    "  quadrature=full        or reduced\n"
    "  elements=8             per axis; even in the scene coupled\n"
    "  coarsest=1             longest element over the shortest; above 1: graded, elements a multiple of 8\n"
    "  dt=0.1 end=0.2         step and end\n"
    "  rho_inf=0.5            of generalized-alpha, 0 .. 1\n"
    "  stabilisation=0.002    C of eps = C h^2 rho^2 / m\n"
    "  preconditioner=automatic   none, lu or schwarz\n"
    "  scheme=generalized_alpha   or kick_drift, rkl2, ssp_rk3\n"
    "  mass=corrected         or lumped, consistent, of the explicit schemes\n"
    "  against=0              a step: errors are differences from a computation with it, else from the exact fields\n"
    "  header=0               1: with the line of column names\n";

/// name=value arguments; a name or value that is not expected throws Error.
class Arguments {
 public:
  Arguments(int count, char** texts) {
    for (int i = 1; i < count; ++i) {
      const char* sign = std::strchr(texts[i], '=');
      if (!sign) throw Error(Exit::invalid_input, std::string("'") + texts[i] + "': expected name=value\n" + usage);
      values_[std::string(static_cast<const char*>(texts[i]), sign)] = sign + 1;
    }
  }
  std::string text(const std::string& name, const std::string& otherwise) {
    const auto found = values_.extract(name);
    return found ? found.mapped() : otherwise;
  }
  double number(const std::string& name, double otherwise, double lowest, double highest) {
    const std::string t = text(name, "");
    if (t.empty()) return otherwise;
    char* end = nullptr;
    const double value = std::strtod(t.c_str(), &end);
    if (*end || !(value >= lowest && value <= highest))
      throw Error(Exit::invalid_input, name + " = '" + t + "': expected a number from " + std::to_string(lowest) +
                                           " to " + std::to_string(highest));
    return value;
  }
  int choice(const std::string& name, const std::vector<std::string>& words) {
    const std::string t = text(name, words.front());
    for (std::size_t i = 0; i < words.size(); ++i)
      if (t == words[i]) return static_cast<int>(i);
    throw Error(Exit::invalid_input, name + " = '" + t + "': not one of its words\n" + usage);
  }
  void expect_no_more() const {
    if (!values_.empty()) throw Error(Exit::invalid_input, "'" + values_.begin()->first + "': no such name\n" + usage);
  }

 private:
  std::map<std::string, std::string> values_;
};

Settings read(Arguments& a) {
  Settings s;
  s.scene = static_cast<SceneKind>(a.choice("scene", {"fluid", "solid", "coupled"}));
  s.course = static_cast<Course>(a.choice("course", {"linear", "harmonic"}));
  s.dimension = static_cast<int>(a.number("dimension", 2, 2, 3));
  s.degree = static_cast<int>(a.number("degree", 2, 2, 3));
  s.elements = static_cast<int>(a.number("elements", 8, 2, 1000));
  s.coarsest = a.number("coarsest", 1, 1, 8);
  s.dt = a.number("dt", 0.1, 1e-8, 1e3);
  s.end = a.number("end", 0.2, 1e-8, 1e3);
  s.rho_inf = a.number("rho_inf", 0.5, 0, 1);
  s.stabilisation = a.number("stabilisation", 0.002, 0, 1e6);
  s.preconditioner = static_cast<PreconditionerKind>(a.choice("preconditioner", words_of(PreconditionerKind{})));
  s.scheme = static_cast<TimeScheme>(a.choice("scheme", {"generalized_alpha", "kick_drift", "rkl2", "ssp_rk3"}));
  s.mass = static_cast<MassKind>(a.choice("mass", words_of(MassKind{})));
  s.against = a.number("against", 0, 0, 1e3);
  s.quadrature = static_cast<softwet::Quadrature>(a.choice("quadrature", words_of(softwet::Quadrature{})));
  if (s.scene == SceneKind::coupled && s.elements % 2)
    throw Error(Exit::invalid_input, "elements = " + std::to_string(s.elements) + ": expected an even number");
  if (s.coarsest > 1 && s.elements % 8)
    throw Error(Exit::invalid_input, "elements = " + std::to_string(s.elements) + ": expected a multiple of 8");
  return s;
}

template <int D, int P>
void measure(const Settings& s) {
  Problem<D, P> problem(s);
  Errors e = problem.run(s.end);
  if (s.against > 0) {
    Settings fine = s;
    fine.dt = s.against;
    Problem<D, P> other(fine);
    other.run(s.end);
    e = problem.difference(other);
  }
  const char* const scenes[] = {"fluid", "solid", "coupled"};
  const std::pair<const char*, double> fields[] = {
      {"velocity", e.velocity}, {"density", e.density}, {"potential", e.potential}, {"displacement", e.displacement}};
  for (const auto& [name, error] : fields)
    if (!std::isnan(error))
      std::printf("%s,%d,%d,%g,%d,%.12g,%s,%.9e\n", scenes[static_cast<int>(s.scene)], D, P, s.rho_inf, s.elements,
                  s.dt, name, error);
}

void run(int count, char** texts) {
  Arguments arguments(count, texts);
  const bool header = arguments.number("header", 0, 0, 1) > 0;
  const Settings s = read(arguments);
  arguments.expect_no_more();
  if (header) std::puts("scene,dimension,degree,rho_inf,elements,dt,field,error");
#define SOFTWET_MEASURE(D, P) \
  if (s.dimension == D && s.degree == P) return measure<D, P>(s);
#ifdef SOFTWET_MMS_3X3
  SOFTWET_MEASURE(3, 3)
#else
  SOFTWET_CONFIGURATIONS(SOFTWET_MEASURE)
#endif
#undef SOFTWET_MEASURE
  throw Error(Exit::invalid_input, "dimension = " + std::to_string(s.dimension) +
                                       ", degree = " + std::to_string(s.degree) + ": not in this program");
}

}  // namespace
}  // namespace softwet::mms

int main(int count, char** texts) {
  try {
    const softwet::ParallelRuntime runtime(1);
    softwet::mms::run(count, texts);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "softwet_mms: %s\n", error.what());
    return 1;
  }
}
