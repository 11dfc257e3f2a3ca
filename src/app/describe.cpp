#include "app/describe.hpp"

#include <cmath>
#include <iomanip>
#include <string>
#include <vector>

#include "app/host/memory.hpp"
#include "app/machine.hpp"
#include "app/memory_parts.hpp"
#include "model/equilibrium.hpp"
#include "model/model.hpp"
#include "solver/choose.hpp"

namespace softwet {
namespace {

struct Line {
  std::string name, value;
};

void print(std::ostream& out, const std::string& title, const std::vector<Line>& lines) {
  out << title << "\n";
  for (const Line& line : lines) out << "  " << std::left << std::setw(30) << line.name << line.value << "\n";
}

std::string number(double value, const char* format = "%.3g") {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

template <int D, int P>
std::vector<Line> terms(const Case& c, const Model<D, P>& model) {
  std::vector<Line> lines;
  for (const auto& piece : model.pieces())
    lines.push_back({piece->name(), std::to_string(piece->region().elements()) + " elements"});
  if (!model.loads().empty())
    lines.push_back({"body_force", std::to_string(c.loads.size()) + (c.loads.size() == 1 ? " box" : " boxes")});
  return lines;
}

template <int D>
std::vector<Line> unknowns(const Layout<D>& l) {
  std::vector<Line> lines{{"velocity", std::to_string(l.velocity_size())}};
  if (l.has_fluid) {
    lines.push_back({"density", std::to_string(l.scalar_size())});
    lines.push_back({"chemical_potential", std::to_string(l.scalar_size())});
  }
  if (l.has_solid) lines.push_back({"displacement (eliminated)", std::to_string(l.solid_size())});
  lines.push_back({"solved", std::to_string(l.size())});
  return lines;
}

template <int D, int P>
std::vector<Line> memory(const Case& c, const Model<D, P>& model) {
  const auto preconditioner = choose_preconditioner<D>(c.solver.preconditioner, model.layout(), model.mask());
  std::vector<Line> lines;
  for (const auto& [name, bytes] : memory_parts(c, model.layout(), *preconditioner))
    lines.push_back({name, bytes_text(bytes)});
  lines.push_back({"total", bytes_text(total_bytes(c, model.layout(), *preconditioner))});
  lines.push_back({"to be had here", bytes_text(bytes_to_be_had())});
  return lines;
}

/// Largest steps of SSP-RK3 with row-sum lumped mass on uniform quadratics, away from the ends (frozen coefficients).
template <int D, int P>
std::vector<Line> step_limits(const Case& c, const Model<D, P>& model) {
  constexpr double oscillating = 1.73, decaying = 2.51;  // of the stability region: omega dt and s dt
  double h = model.layout().axis[0].spacing();
  for (const Axis& axis : model.layout().axis) h = std::min(h, axis.spacing());
  std::vector<Line> lines;
  const auto limit = [&](const std::string& name, double dt) {
    lines.push_back({name, "dt <= " + number(dt, "%.2g")});
  };
  if (c.fluid) {
    const double liquid = model.state().density_liquid, vapour = model.state().density_vapour;
    const double sound = std::sqrt(liquid * model.fluid().gas.curvature(liquid));
    limit("acoustic (liquid)", oscillating * h / (0.70 * sound));
    limit("capillary (liquid)", oscillating * h * h / (0.97 * c.fluid->capillarity * std::sqrt(liquid)));
    limit("viscous (vapour)", decaying * h * h / (4.0 / 3 * c.fluid->viscosity / vapour * 1.5));
  }
  if (c.substrate) {
    const double nu = c.substrate->poisson;
    const double speed = std::sqrt(c.substrate->young * (1 - nu) / ((1 + nu) * (1 - 2 * nu)));
    limit("elastic", oscillating * h / (speed * std::sqrt(1.5)));
  }
  return lines;
}

}  // namespace

template <int D, int P>
void describe_model(const Case& c, std::ostream& out) {
  const Model<D, P> model(c);
  print(out, "terms", terms(c, model));
  print(out, "unknowns", unknowns(model.layout()));
  print(out, "memory", memory<D, P>(c, model));
  if (c.fluid) {
    print(out, "equilibrium",
          {{"density of the vapour", number(model.state().density_vapour, "%.10g")},
           {"density of the liquid", number(model.state().density_liquid, "%.10g")},
           {"surface tension", number(surface_tension(*c.fluid), "%.10g") + " a b^2 L0"}});
  }
  print(out, "limits of explicit steps (for information; the implicit scheme has none)", step_limits(c, model));
  print(out, "kernel",
        {{"configuration", std::to_string(D) + "D, degree " + std::to_string(P) + ", double"},
         {"backend",
          backend_name() + ", " + std::to_string(lanes()) + " elements per pack (" + instruction_set() + ")"}});
}

template void describe_model<SOFTWET_DIMENSION, SOFTWET_DEGREE>(const Case&, std::ostream&);

}  // namespace softwet
