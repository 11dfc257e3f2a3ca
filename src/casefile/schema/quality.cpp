#include "casefile/schema/quality.hpp"

namespace softwet {

const std::vector<QualityValues>& qualities() {
  static const std::vector<QualityValues> all{
      {Quality::draft,
       "for a first look at a scene",
       {{"time.tolerance", "7e-3"},
        {"solver.newton.rtol", "3e-3"},
        {"domain.grading.fine", "\"automatic\""},
        {"domain.grading.coarsest", "16"},
        {"domain.grading.ratio", "1.5"}}},
      {Quality::standard, "the defaults", {}},
      {Quality::reference,
       "to judge the others by",
       {{"time.tolerance", "1e-5"}, {"solver.newton.rtol", "1e-6"}, {"solver.newton.atol", "1e-11"}}},
  };
  return all;
}

bool set_by_quality(const std::string& key) {
  for (const QualityValues& quality : qualities())
    for (const QualityValue& value : quality.values)
      if (key == value.key) return true;
  return false;
}

std::string describe_qualities() {
  std::string text;
  for (const QualityValues& quality : qualities()) {
    text += (text.empty() ? "\"" : " \"") + word_of(quality.quality) + "\" (" + quality.purpose + ")";
    for (std::size_t i = 0; i < quality.values.size(); ++i)
      text += std::string(i == 0 ? " sets " : ", ") + quality.values[i].key + " = " + quality.values[i].text;
    text += quality.values.empty() ? " sets nothing." : ".";
  }
  return text;
}

}  // namespace softwet
