// What `softwet explain` says of the columns of the tables.
#include <gtest/gtest.h>

#include "case/error.hpp"
#include "casefile/case_file.hpp"
#include "casefile/schema/schema.hpp"
#include "casefile/write/column_text.hpp"
#include "observe/host/table_columns.hpp"

namespace softwet {
namespace {

TEST(ExplainColumns, KnowsEveryColumnThatIsWritten) {
  for (int dimension : {2, 3}) {
    for (const std::string& name : history_names(dimension, 12, 0, 3))
      EXPECT_NE(explain("history." + name), "") << name;
    for (const std::string& name : interface_names(dimension)) EXPECT_NE(explain("interface." + name), "") << name;
  }
}

TEST(ExplainColumns, ShowsMeaningAndUnit) {
  EXPECT_NE(explain("history.velocity").find("sqrt(ab)"), std::string::npos);
  EXPECT_EQ(explain("history.velocity_2"), explain("history.velocity"));
  EXPECT_EQ(explain("mass"), explain("history.mass"));
  EXPECT_NE(explain("history.contact_area").find("Only in 3D"), std::string::npos);
}

TEST(ExplainColumns, ListsATable) {
  EXPECT_NE(explain("history").find("history.energy_total"), std::string::npos);
  EXPECT_EQ(explain("history").find("interface."), std::string::npos);
  EXPECT_NE(explain("interface.csv").find("interface.density"), std::string::npos);
  EXPECT_NE(explain("fields").find("fields.cauchy_stress"), std::string::npos);
}

TEST(ExplainColumns, KnowsNothingElse) {
  for (const char* name : {"", "_2", "mass_", "history.", "history.mas", "table"}) EXPECT_EQ(explain_columns(name), "");
  try {
    explain("history.mas");
    FAIL() << "an unknown column was explained";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("history.mass"), std::string::npos) << error.what();
  }
}

TEST(ColumnsJson, HasEveryColumnWithItsUnit) {
  const std::string text = columns_json();
  for (const ColumnTable& table : column_tables())
    for (const Column& column : table.columns)
      EXPECT_NE(text.find("\"name\": \"" + column.name + "\""), std::string::npos) << column.name;
  EXPECT_NE(text.find("\"unit\": \"b L0^d\""), std::string::npos);
  EXPECT_NE(text.find("\"needs\": \"solid\""), std::string::npos);
  EXPECT_NE(text.find("\"dimension\": 3"), std::string::npos);
}

TEST(ReferencePage, HasEveryKeyAndColumnInRowsOfOneLine) {
  const std::string page = reference_page();
  for (const Key& key : schema()) EXPECT_NE(page.find("| `" + key.leaf() + "` |"), std::string::npos) << key.name;
  for (const ColumnTable& table : column_tables())
    for (const Column& column : table.columns)
      EXPECT_NE(page.find("| `" + column.name + "` |"), std::string::npos) << column.name;
}

}  // namespace
}  // namespace softwet
