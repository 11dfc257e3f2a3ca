// Units of a laboratory for those of a case, against numbers worked by hand.
#include "observe/host/laboratory_units.hpp"

#include <gtest/gtest.h>

#include <set>

#include "casefile/schema/schema.hpp"
#include "observe/host/table_columns.hpp"

namespace softwet {
namespace {

/// L0 = 1 mm, b = 1000 kg/m^3, a = 1e-3 Pa m^6/kg^2: a b^2 is 1 kPa, sqrt(ab) 1 m/s, L0/sqrt(ab) 1 ms.
constexpr Scales round_scales{1e-3, 1e3, 1e-3};

TEST(LaboratoryUnits, OfEachKindWorkedByHand) {
  const struct {
    const char* unit;
    int dimension;
    const char* name;
    double factor;
  } table[] = {{"L0", 2, "um", 1000},
               {"L0^2", 3, "um^2", 1e6},
               {"L0^d", 2, "um^2", 1e6},
               {"L0^d", 3, "nl", 1000},
               {"L0/sqrt(ab)", 2, "ms", 1},
               {"sqrt(ab)", 2, "mm/s", 1000},
               {"a b^2", 2, "kPa", 1},
               {"a b^2 L0", 2, "mN/m", 1000},
               {"L0 b sqrt(ab)", 2, "mPa.s", 1000},
               {"b", 3, "kg/m3", 1000},
               {"ab/L0", 2, "m/s^2", 1000},
               {"ab", 2, "J/kg", 1},
               {"a b^2 L0^d", 3, "nJ", 1000},
               {"a b^2 L0^d", 2, "uN", 1000},
               {"a b^2 sqrt(ab) L0^(d-1)", 3, "uW", 1000},
               {"a b^2 sqrt(ab) L0^(d-1)", 2, "mW/m", 1000},
               {"a b^2 L0^(d-1)", 3, "uN", 1000},
               {"a b^2 L0^(d-1)", 2, "mN/m", 1000},
               {"b L0^d", 3, "ug", 1000},
               {"b L0^d", 2, "mg/m", 1000},
               {"a b^2/L0^2", 2, "m^-3 s^-2 kg", 1e9}};
  for (const auto& row : table) {
    const auto shown = shown_unit(row.unit, row.dimension, round_scales);
    ASSERT_TRUE(shown) << row.unit;
    EXPECT_EQ(shown->name, row.name) << row.unit;
    EXPECT_NEAR(shown->factor / row.factor, 1, 1e-12) << row.unit << " in " << row.dimension << "D";
  }
  for (const char* none : {"", "degrees", "theta_c", "1", "rho_0^s ab", "hours of wall time"})
    EXPECT_FALSE(shown_unit(none, 3, round_scales)) << none;
}

/// A unit that this place does not know would be shown without notice in the units of the case.
TEST(LaboratoryUnits, EveryUnitOfColumnsAndKeysIsKnownOrHasNoScale) {
  const std::set<std::string> without{
      "", "degrees", "theta_c", "rho_0^s ab", "hours of wall time", "minutes of wall time"};
  for (const ColumnTable& table : column_tables())
    for (const Column& column : table.columns)
      EXPECT_EQ(shown_unit(column.unit, 2, round_scales).has_value(), !without.count(column.unit)) << column.unit;
  for (const Key& key : schema())
    EXPECT_EQ(shown_unit(key.unit, 2, round_scales).has_value(), !without.count(key.unit)) << key.name;
}

TEST(LaboratoryUnits, TheRecordHasEachColumnAndTheScales) {
  Case c;
  c.domain.size = {1, 1};
  c.domain.elements = {4, 4};
  const std::string record = units_record(c, round_scales);
  for (const char* part : {"\"one_unit_in_si\"", "\"history\"", "\"ridge_left\"", "\"interface\"", "\"traction_y\"",
                           "\"fields\"", "\"cauchy_stress\"", "\"kPa\""})
    EXPECT_NE(record.find(part), std::string::npos) << part;
  EXPECT_EQ(record.find("\"angle_left\""), std::string::npos);
}

}  // namespace
}  // namespace softwet
