#include "run/host/earlier_losses.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>

#include "case/gel.hpp"

namespace softwet {
namespace {

std::vector<std::string> cells_of_line(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream rest(line);
  for (std::string cell; std::getline(rest, cell, ',');) cells.push_back(cell);
  return cells;
}

/// A column of history.csv in the row of a time, or in its last row without one. None where there is no such number.
std::optional<double> value_in_history(const std::string& folder, const std::string& name,
                                       const std::vector<double>& time) {
  std::ifstream file(folder + "/history.csv");
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> columns = cells_of_line(line);
  const auto place = [&](const std::string& column) {
    return static_cast<std::size_t>(std::find(columns.begin(), columns.end(), column) - columns.begin());
  };
  const std::size_t wanted = place(name), clock = place("t");
  std::optional<double> value;
  double nearest = INFINITY;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = cells_of_line(line);
    if (std::max(wanted, clock) >= cells.size() || cells[wanted].empty()) continue;
    const double off = time.empty() ? 0 : std::abs(std::atof(cells[clock].c_str()) - time[0]);
    if (off > nearest) continue;
    nearest = off;
    value = std::atof(cells[wanted].c_str());
  }
  return value;
}

std::string stretches_text(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + fmt::format("{:.6g}", number);
  return "[" + text + "]";
}

std::string branches_text(const Case& c) {
  const std::size_t count = c.substrate && c.substrate->has_branches() ? all_branches(*c.substrate).size() : 0;
  return count == 0 ? "no branches" : fmt::format("{} branch{}", count, count == 1 ? "" : "es");
}

}  // namespace

std::vector<std::string> losses_of_earlier(const Case& now, const Case& then, const std::string& folder) {
  std::vector<std::string> found;
  if (!now.substrate || !then.substrate) return found;
  const std::string of_run = fmt::format("initial.from = \"{}\": ", folder);
  const auto stretches = [](const Case& c) {
    std::vector<double> all = c.substrate->prestretch;
    if (all.empty()) all.assign(c.dimension() == 3 ? 2 : 1, 1.0);
    return all;
  };
  if (const auto mine = stretches(now), other = stretches(then); mine != other)
    found.push_back(
        of_run +
        fmt::format("that run has substrate.prestretch = {}, this case has {}: its displacement counts from another "
                    "stretched layer, so that neither the shape nor the stress of the solid is that of the earlier "
                    "run; write prestretch = {}, or time.start = \"equilibrium\" to begin at rest",
                    stretches_text(other), stretches_text(mine), stretches_text(other)));
  if (!then.substrate->has_branches() || now.time.start == StartState::equilibrium) return found;
  const std::optional<double> energy = value_in_history(folder, "energy_branches", now.initial->time);
  if (energy == 0.0) return found;
  found.push_back(of_run +
                  fmt::format("the stress in the branches of its solid is not taken over: that run has {} with "
                              "energy_branches = {}, this case has {}, which begin{} with 0; go on with --resume in "
                              "the folder of that run to keep the stress, or begin where it has relaxed",
                              branches_text(then), energy ? fmt::format("{:.4g}", *energy) : "an unknown value",
                              branches_text(now), branches_text(now) == "1 branch" ? "s" : ""));
  return found;
}

}  // namespace softwet
