#include "casefile/checks/field_times.hpp"

#include "io/output_time.hpp"

namespace softwet {

double count_of_multiples(const Case& c) {
  const double interval = c.output.field_every;
  if (interval <= 0) return 0;
  return std::floor(c.time.end / interval * (1 + 1e-9)) + 1;
}

std::vector<double> field_times(const Case& c) {
  std::vector<double> times = c.output.field_times;
  const double count = count_of_multiples(c);
  for (double k = 0; k < count; ++k) times.push_back(short_decimal(k * c.output.field_every));
  std::stable_sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end(), same_time), times.end());
  return times;
}

}  // namespace softwet
