// Rows of tables: cells by name.
#include "io/table_row.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace softwet {
namespace {

using Cells = std::vector<TableRow::Cell>;

const std::vector<std::string> three_columns = {"step", "t", "mass"};

/// What a row is refused with.
std::string refusal(const TableRow& row) {
  try {
    row.in_order_of(three_columns);
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "";
}

TEST(TableRow, HasTheOrderOfTheColumns) {
  const Cells wanted{1.0, 0.5, std::nullopt};
  EXPECT_EQ((TableRow{{"step", 1}, {"t", 0.5}, {"mass", std::nullopt}}.in_order_of(three_columns)), wanted);
  EXPECT_EQ((TableRow{{"mass", std::nullopt}, {"step", 1}, {"t", 0.5}}.in_order_of(three_columns)), wanted);
}

TEST(TableRow, IsRefusedWithoutACell) {
  for (const TableRow& row : {TableRow{{"step", 1}, {"mass", 2}}, TableRow{{"mass", 2}, {"step", 1}, {"masss", 3}}})
    EXPECT_NE(refusal(row).find("'t'"), std::string::npos) << refusal(row);
}

TEST(TableRow, IsRefusedWithAForeignCell) {
  const std::string told = refusal(TableRow{{"step", 1}, {"t", 2}, {"volume", 3}, {"mass", 4}});
  EXPECT_NE(told.find("no column 'volume'"), std::string::npos) << told;
}

TEST(TableRow, IsRefusedWithTwoCellsOfAColumn) {
  const std::string told = refusal(TableRow{{"step", 1}, {"t", 2}, {"mass", 3}, {"t", 2}});
  EXPECT_NE(told.find("two cells for the column 't'"), std::string::npos) << told;
}

TEST(TableRow, IsReadByName) {
  TableRow row{{"t", 0.5}, {"mass", std::nullopt}};
  row.add(TableRow{{"x_left", 2}, {"x_right", std::nullopt}}, "_2");
  EXPECT_EQ(row.cell("t"), 0.5);
  EXPECT_EQ(row.cell("x_left_2"), 2);
  EXPECT_EQ((row.in_order_of({"x_right_2", "x_left_2", "mass", "t"})), (Cells{std::nullopt, 2, std::nullopt, 0.5}));
  for (const char* empty : {"mass", "x_right_2", "x_left"}) EXPECT_EQ(row.cell(empty), std::nullopt) << empty;
}

}  // namespace
}  // namespace softwet
