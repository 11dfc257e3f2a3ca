#include "parts/foundation/keys.hpp"

#include "casefile/checks/checker.hpp"
#include "casefile/schema/binding.hpp"

namespace softwet {
namespace {

Key key_of(const char* name, const char* unit, std::vector<double> FoundationPart::*numbers, const char* help) {
  return {.name = name,
          .kind = Kind::numbers,
          .unit = unit,
          .range = {0, infinity, false, true},
          .lengths = {0, 2},
          .help = help,
          .bind = at([numbers](Case & c, std::size_t) -> auto& { return c.parts.foundation.*numbers; }),
          .default_note = "[], none"};
}

/// Springs and dashpots act where nothing holds the bottom.
/// @param numbers  as they are called;  @param what  they are
void check_one(const Checker& check, const std::string& key, const std::vector<double>& values, const char* numbers,
               const char* what) {
  if (values.empty()) return;
  const std::string name = key.substr(key.find('.') + 1);
  if (values.size() != 2)
    check.refuse(key, fmt::format("must be 2 numbers, {}", numbers),
                 fmt::format("write for example {} = [10.0, 0.0]", name));
  if (!check.c.substrate) check.refuse(key, "needs a solid, which rests on it", "add a [substrate] or remove it");
  const Side bottom = check.c.boundary.side[check.vertical()][0];
  if (bottom == Side::free || (bottom == Side::slip && values[0] == 0)) return;
  if (bottom == Side::slip)
    check.refuse(key,
                 fmt::format("has {} against motion through a bottom that is held: boundary.bottom is \"slip\"", what),
                 fmt::format("write bottom = \"free\", or {} = [0, {}] for {} along a roller", name, values[1], what));
  check.refuse(key, fmt::format("has {} below a bottom that is held: boundary.bottom is \"{}\"", what, word_of(bottom)),
               "write bottom = \"free\", or remove them");
}

}  // namespace

std::vector<Key> FoundationPart::keys() {
  return {key_of("boundary.foundation", "a b^2/L0", &FoundationPart::springs,
                 "Springs [kap_n, kap_t] below the solid, on each undeformed area of its bottom: the stress kap_n u_n "
                 "against motion through it and kap_t u_t against motion along it. Needs bottom = \"free\"; with "
                 "bottom = \"slip\" springs along a roller, [0, kap_t]."),
          key_of("boundary.foundation_damping", "b sqrt(ab)", &FoundationPart::dashpots,
                 "Dashpots [c_n, c_t] below the solid, beside the springs of boundary.foundation or alone: the stress "
                 "c_n v_n against velocities through its bottom and c_t v_t against those along it. What they "
                 "dissipate is a part of the column dissipation_solid. Needs bottom = \"free\"; with bottom = \"slip\" "
                 "dashpots along a roller, [0, c_t].")};
}

void FoundationPart::check(const Checker& check) const {
  const auto one = [&](const char* key, const auto&... more) {
    check.with({key, "boundary.bottom", "substrate"}, [&] { check_one(check, key, more...); });
  };
  one("boundary.foundation", springs, "kap_n and kap_t", "springs");
  one("boundary.foundation_damping", dashpots, "c_n and c_t", "dashpots");
}

}  // namespace softwet
