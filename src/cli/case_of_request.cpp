#include "cli/case_of_request.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "case/case.hpp"
#include "case/error.hpp"
#include "casefile/case_file.hpp"
#include "cli/core/dispatch.hpp"
#include "field/ranks.hpp"

namespace softwet {

std::string folder_of(const CaseRequest& request, const Case& c) {
  if (!request.options.out.empty()) return request.options.out;
  return "out/" + c.name + (request.options.steady ? "_steady" : "");
}

LaboratoryCase read_case_of(const CaseRequest& request) {
  const Conversion conversion = conversion_of_quantities();
  const LaboratoryCase read = read_laboratory_case(request.case_path, request.overrides, conversion);
  const Case& c = read.c;
  if (!c.time.automatic || request.options.steady) return read;
  const auto with_scheme = [&](TimeScheme scheme) {
    std::vector<std::string> overrides = request.overrides;
    overrides.push_back("time.scheme=" + word_of(scheme));
    return read_laboratory_case(request.case_path, overrides, conversion);
  };
  const std::string before = folder_of(request, c) + "/case.toml";  // a run goes on with the scheme that it began with
  if (request.options.resume && std::filesystem::exists(before)) return with_scheme(read_case(before).time.scheme);
  const StepsForeseen foreseen = foresee_steps(c);
  const auto tell = [&](TimeScheme scheme, const std::string& why) {
    if (ranks::root())
      std::cerr << fmt::format("softwet: time.scheme = \"automatic\" takes {}: {}\n", word_of(scheme), why);
  };
  const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(std::max(foreseen.steps, 1.0))) - 1));
  const std::string steps =
      fmt::format("about {:.0f} explicit steps, of which up to {:.0f} take less time than implicit ones",
                  std::round(foreseen.steps / unit) * unit, foreseen.most);
  if (foreseen.steps > foreseen.most) {
    tell(TimeScheme::generalized_alpha, steps);
    return read;
  }
  try {
    const LaboratoryCase chosen = with_scheme(TimeScheme::kick_drift);
    tell(TimeScheme::kick_drift, steps);
    return chosen;
  } catch (const Error&) {
    tell(TimeScheme::generalized_alpha, "explicit steps do not support what this case asks for");
    return read;
  }
}

}  // namespace softwet
