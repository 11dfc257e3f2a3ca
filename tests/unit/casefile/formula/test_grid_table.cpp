// Tables: interpolation, places outside of the grid, and messages about wrong files.
#include "casefile/formula/grid_table.hpp"

#include <gtest/gtest.h>

#include "casefile/formula/expression.hpp"
#include "io/hdf5_file.hpp"
#include "unit/io/scratch_folder.hpp"

namespace softwet {
namespace {

const std::vector<std::string> space{"x", "y", "z"}, time_alone{"t"};

class GridTableFile : public testing::Test {
 protected:
  std::string file(const std::string& text) const {
    overwrite(folder_ / "table.csv", text);
    return folder_ / "table.csv";
  }
  std::string told(const std::string& path, const std::vector<std::string>& variables = space) const {
    try {
      const GridTable table(path, variables);
    } catch (const FormulaError& error) {
      return error.what() + ("; " + error.remedy);
    }
    return "(accepted)";
  }
  ScratchFolder folder_;
};

TEST_F(GridTableFile, IsLinearAlongEachAxisWhateverTheOrderOfTheLines) {
  // 1 + 2 x + 3 y + 4 x y is linear along each axis, so between the points the table is exact.
  const GridTable table(file("# a comment\nx, y ,value\n0,0,1\n1,1,10\r\n\n1,0,3\n0,1,4\n0,2,7\n1,2,17\n"), space);
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {0.3, 0.7}, {1.0, 2.0}, {0.5, 1.75}, {1.0, 1.0}})
    EXPECT_NEAR(table.at({x, y, 9}, 9), 1 + 2 * x + 3 * y + 4 * x * y, 1e-14) << x << " " << y;
  EXPECT_EQ(table.at({-5, 0, 0}, 0), 1) << "outside the value of the border holds";
  EXPECT_EQ(table.at({5, 7, 0}, 0), 17);
  EXPECT_TRUE(table.kinks().empty());
}

TEST_F(GridTableFile, OfOneAxisAndOfOnePoint) {
  const GridTable heights(file("y,value\n0,1\n0.5,3\n"), space);
  EXPECT_DOUBLE_EQ(heights.at({9, 0.125, 9}, 0), 1.5);
  const GridTable one(file("x,value\n0.5,3\n"), space);
  EXPECT_EQ(one.at({-1, 0, 0}, 0), 3);
  EXPECT_EQ(one.at({1, 0, 0}, 0), 3);
}

TEST_F(GridTableFile, OfTimeHasKinksAtItsPoints) {
  const GridTable table(file("t,value\n0,0\n2,1\n3,-1\n"), time_alone);
  EXPECT_DOUBLE_EQ(table.at({0, 0, 0}, 0.5), 0.25);
  EXPECT_DOUBLE_EQ(table.at({0, 0, 0}, 2.5), 0);
  EXPECT_EQ(table.at({0, 0, 0}, 9), -1);
  EXPECT_EQ(table.kinks(), (std::vector<double>{0, 2, 3}));
}

TEST_F(GridTableFile, Hdf5HoldsTheSameFunction) {
  const GridTable text(file("x,y,value\n0,0,1\n0,1,4\n0,2,7\n1,0,3\n1,1,10\n1,2,17\n"), space);
  const std::string path = folder_ / "table.h5";
  Hdf5File made = Hdf5File::create(path, Hdf5Format::compatible);
  made.write<double>("x", {0, 1}, {2});
  made.write<double>("y", {0, 1, 2}, {3});
  made.write<double>("value", {1, 4, 7, 3, 10, 17}, {2, 3});
  made.close();
  const GridTable binary(path, space);
  EXPECT_EQ(binary.identity(), text.identity());
  EXPECT_EQ(binary.at({0.3, 1.2, 0}, 0), text.at({0.3, 1.2, 0}, 0));
}

TEST_F(GridTableFile, WrittenByASpreadsheetIsTheSame) {
  const std::string plain = GridTable(file("t,value\n0,1\n1,2.5\n"), time_alone).identity();
  for (const std::string text :
       {"\xef\xbb\xbft,value\r\n0,1\r\n1,2.5\r\n", "t;value\n0;1\n1;2.5\n", "t\tvalue\n0\t1\n1\t2.5\n",
        "t,value\r0,1\r1,2.5\r", "\"t\",\"value\"\n0,1\n1,2.5\n", "# pulses\nt;value\n0;1\n1;2.5"})
    EXPECT_EQ(GridTable(file(text), time_alone).identity(), plain) << text;
}

TEST_F(GridTableFile, ReportsWhatIsNoTextInUtf8) {
  using namespace std::string_literals;
  for (const std::string& text : {"\xff\xfet\0,\0v\0\n\0"s, "\xfe\xff\0t\0,\0v\0\n"s, "t\0,\0v\0\n\0"s})
    EXPECT_NE(told(file(text), time_alone).find("table.csv:1: the file is in UTF-16; save the table as CSV in UTF-8"),
              std::string::npos);
  EXPECT_NE(told(file("PK\x03\x04\x14"), time_alone).find("a workbook of Excel"), std::string::npos);
  EXPECT_NE(told(file("t;value\n0,5;1\n"), time_alone).find("'0,5' is not a number; decimal numbers have a point"),
            std::string::npos);
  for (const char* name : {"table.xlsx", "a/b.txt", "TABLE.CSV"}) EXPECT_TRUE(GridTable::is_other_file(name)) << name;
  for (const char* name : {"table.csv", "table.h5", "2*x", ".xlsx"})
    EXPECT_FALSE(GridTable::is_other_file(name)) << name;
}

TEST_F(GridTableFile, IdentityFollowsFromTheValues) {
  const std::string one = GridTable(file("x,value\n0,1\n1,2\n"), space).identity();
  EXPECT_EQ(GridTable(file("x,value\n1,2\n0,1\n"), space).identity(), one);
  EXPECT_NE(GridTable(file("x,value\n0,1\n1,2.5\n"), space).identity(), one);
  EXPECT_NE(GridTable(file("y,value\n0,1\n1,2\n"), space).identity(), one);
}

TEST_F(GridTableFile, NamesLineAndColumnOfAMistake) {
  const auto tells = [&](const std::string& text, const std::string& part) {
    const std::string message = told(file(text));
    EXPECT_NE(message.find(part), std::string::npos) << part << "\n" << message;
    EXPECT_NE(message.find("table.csv"), std::string::npos) << message;
  };
  tells("x,value\n0,1\n1,soft\n", "table.csv:3: column 2: 'soft' is not a number");
  tells("x,value\n0,nan\n", "table.csv:2: column 2");
  tells("x,value\n0,1\n0,5,1\n", "table.csv:3: has 3 columns, the first line has 2");
  tells("x,w,value\n0,1,1\n", "table.csv:1: column 2: 'w' is not an axis");
  tells("x,x,value\n0,1,1\n", "table.csv:1: column 2: 'x' is not an axis");
  tells("0,1\n1,2\n", "'0' is not an axis of this table");
  tells("x,y\n0,1\n", "'y' is not 'value'");
  tells("value\n1\n", "'value' is not 'value' after an axis");
  tells("x,value\n", "there are no values");
  tells("", "cannot be read");
  tells("x,y,value\n0,0,1\n1,0,2\n0,1,3\n", "a grid of 4 points, but there are 3 lines");
  tells("x,value\n0,1\n1,2\n0,3\n", "table.csv:4: this point is in line 2 too");
  EXPECT_NE(told(folder_ / "missing.csv").find("missing.csv cannot be read: No such file"), std::string::npos);
  EXPECT_NE(told(folder_ / "missing.h5").find("missing.h5"), std::string::npos);
  EXPECT_NE(told(file("t,value\n0,1\n"), space).find("some of x, y, z"), std::string::npos);
}

}  // namespace
}  // namespace softwet
