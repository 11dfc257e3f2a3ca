// Integrals by the columns of history.csv.
#include "scene/integrals.hpp"

#include <gtest/gtest.h>

#include "observe/host/table_columns.hpp"

namespace softwet {
namespace {

/// The integrals that are no sums.
std::vector<std::string> parts() {
  std::vector<std::string> all;
  for (const IntegralColumn& one : integral_columns)
    if (!is_sum(one.name)) all.push_back(one.name);
  return all;
}

/// The part number i has the value 2^i, so that a sum shows its parts.
Integrals of_powers() {
  Integrals all;
  double value = 1;
  for (const std::string& part : parts()) {
    all.part(part) = value;
    value *= 2;
  }
  return all;
}

TEST(Integrals, OfAColumnAreTheSumOfItsParts) {
  Integrals all = of_powers();
  EXPECT_EQ(all["mass"], 1);
  EXPECT_EQ(all["energy_free"], all.part("energy_free_bulk") + all.part("energy_free_gradient"));
  EXPECT_EQ(all["energy_surface"], all.part("energy_surface"));
  EXPECT_EQ(all.energy(), 16 + 32 + 64 + 128 + 256 + 4096 + 8192 + 16384 + 32768 + 524288);
  EXPECT_EQ(all.dissipation(), 512 + 1024 + 65536 + 131072);
  EXPECT_EQ(all["dissipation"], all.dissipation());
  EXPECT_EQ(all["dissipation_solid"], 65536);
  EXPECT_EQ(all["dissipation_wall"], 131072);
}

TEST(Integrals, SizeOfEnergiesKnowsNoSigns) {
  Integrals all = of_powers();
  all.part("energy_wall") *= -1;
  const double size = 16 + 32 + 64 + 128 + 256 + 4096 + 8192 + 16384 + 32768 + 524288;
  EXPECT_EQ(all.size(), size);
  EXPECT_EQ(all.energy(), size - 2 * 128);
}

TEST(Integrals, OfAWholeTurnHaveNoMomentumFromTheAxis) {
  const Integrals before = of_powers();
  Integrals all = before;
  all.turn(3);
  for (const std::string& part : parts())
    EXPECT_EQ(all.part(part), part == "momentum_x" ? 0 : 3 * Integrals(before).part(part)) << part;
}

/// As kernels/functional has them.
struct Two {
  static constexpr int count = 2;
  static constexpr const char* column(int integral) { return integral == 0 ? "mass" : "energy_wall"; }
};

TEST(Integrals, AddUpUnderTheNamesOfAFunctional) {
  Integrals all;
  all.add<Two>({1, 2});
  all.add<Two>({10, 20});
  EXPECT_EQ(all["mass"], 11);
  EXPECT_EQ(all["energy_wall"], 22);
  EXPECT_EQ(all.energy(), 22);
}

TEST(Integrals, RefuseForeignNames) {
  Integrals all;
  for (const char* name : {"", "energy", "energy_free", "masses", "energy_bending"})
    EXPECT_THROW(all.part(name), std::logic_error) << name;
  for (const char* name : {"mas", "energy_fre", "energy_total", "energy_bending", "rho_min"}) {
    EXPECT_FALSE(Integrals::has(name)) << name;
    EXPECT_THROW(all[name], std::logic_error) << name;
  }
}

TEST(Integrals, AreAllShown) {
  const std::vector<std::string> columns = history_names(3, 0, 0, 1);
  for (const std::string& part : parts()) {
    bool shown = false;
    for (const std::string& column : columns) shown = shown || belongs(part, column);
    EXPECT_TRUE(shown) << part;
  }
}

}  // namespace
}  // namespace softwet
