#include "casefile/schema/quality.hpp"

namespace softwet {

const std::vector<Quality>& qualities() {
  static const std::vector<Quality> all{
      {"draft", "for a first look at a scene", {{"time.tolerance", "5e-3"}, {"domain.grading.fine", "\"automatic\""}}},
      {"standard", "the defaults", {}},
      {"reference",
       "to judge the others by",
       {{"time.tolerance", "1e-5"}, {"solver.newton.rtol", "1e-6"}, {"solver.newton.atol", "1e-11"}}},
  };
  return all;
}

bool set_by_quality(const std::string& key) {
  for (const Quality& quality : qualities())
    for (const QualityValue& value : quality.values)
      if (key == value.key) return true;
  return false;
}

std::string describe_qualities() {
  std::string text;
  for (const Quality& quality : qualities()) {
    text += (text.empty() ? "\"" : " \"") + std::string(quality.name) + "\" (" + quality.purpose + ")";
    for (std::size_t i = 0; i < quality.values.size(); ++i)
      text += std::string(i == 0 ? " sets " : ", ") + quality.values[i].key + " = " + quality.values[i].text;
    text += quality.values.empty() ? " sets nothing." : ".";
  }
  return text;
}

}  // namespace softwet
