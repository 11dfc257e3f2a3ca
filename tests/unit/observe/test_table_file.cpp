// Tables: exact numbers, empty cells, and resuming after a checkpoint.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "expect_error.hpp"
#include "observe/host/number_text.hpp"
#include "observe/host/table_file.hpp"
#include "scratch_folder.hpp"

namespace softwet {
namespace {

const std::vector<std::string> columns = {"step", "t", "angle_left"};

TEST(NumberText, IsShortAndReadsBackEqual) {
  EXPECT_EQ(number_text(0.1), "0.1");
  EXPECT_EQ(number_text(1000000), "1000000");
  EXPECT_EQ(number_text(-3), "-3");
  EXPECT_EQ(number_text(1e300), "1e+300");
  EXPECT_EQ(number_text(NAN), "nan");
  for (const double value : {1.0 / 3.0, 5e-324, 9007199254740993.0, std::numeric_limits<double>::max(), -1e-17}) {
    EXPECT_EQ(std::strtod(number_text(value).c_str(), nullptr), value);
  }
}

TEST(TableFile, WritesHeaderNumbersAndEmptyCells) {
  const ScratchFolder folder;
  const std::string path = folder / "out/history.csv";
  {
    TableFile table = TableFile::create(path, columns);
    EXPECT_EQ(content_of(path), "step,t,angle_left\n");
    table.row({1.0, 0.1, std::nullopt});
    table.row({2.0, 1e-20, 74.5});
  }
  EXPECT_EQ(content_of(path), "step,t,angle_left\n1,0.1,\n2,1e-20,74.5\n");
}

TEST(TableFile, FlushHandsOverTheRows) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv";
  TableFile table = TableFile::create(path, columns);
  table.row({1.0, 0.1, 2.0});
  table.flush();
  EXPECT_EQ(content_of(path), "step,t,angle_left\n1,0.1,2\n");
}

TEST(TableFile, RefusesNumbersThatAreNotFiniteAndWrongCounts) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv";
  {
    TableFile table = TableFile::create(path, columns);
    expect_error(Exit::computation_failed, {path, "'t'", "nan", "step 7"}, [&] { table.row({7.0, NAN, 1.0}); });
    expect_error(Exit::computation_failed, {path, "'angle_left'", "inf"}, [&] { table.row({7.0, 1.0, INFINITY}); });
    expect_error(Exit::computation_failed, {path, "2 values", "3 columns"}, [&] { table.row({7.0, 1.0}); });
  }
  EXPECT_EQ(content_of(path), "step,t,angle_left\n");
}

TEST(TableFile, ResumeDropsRowsAfterTheCheckpoint) {
  const ScratchFolder folder;
  const std::string path = folder / "interface.csv";
  overwrite(path, "step,t,angle_left\n8,0.8,\n10,1,75\n10,1,76\n11,1.1,75\n12,1.2");
  {
    TableFile table = TableFile::append_after(path, columns, 10);
    table.row({11.0, 1.05, 77.0});
  }
  EXPECT_EQ(content_of(path), "step,t,angle_left\n8,0.8,\n10,1,75\n10,1,76\n11,1.05,77\n");
}

TEST(TableFile, ResumeDropsALastRowCutShort) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv";
  overwrite(path, "step,t,angle_left\n1,0.1,\n2,0");
  TableFile::append_after(path, columns, 10);
  EXPECT_EQ(content_of(path), "step,t,angle_left\n1,0.1,\n");
}

TEST(TableFile, ResumeStartsAnewWhereThereIsNoTable) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv";
  TableFile::append_after(path, columns, 10);
  EXPECT_EQ(content_of(path), "step,t,angle_left\n");
}

TEST(TableFile, ResumeRefusesAnotherTable) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv";
  for (const std::string header : {"step,t", "step,t,angle_left,angle_right\n", "t,step,angle_left\n"}) {
    overwrite(path, header);
    expect_error(Exit::invalid_input, {path + ":1", "header", "step,t,angle_left"},
                 [&] { TableFile::append_after(path, columns, 1); });
    EXPECT_EQ(content_of(path), header);
  }
  overwrite(path, "step,t,angle_left\n1,0.1,\nx,0.2,\n");
  expect_error(Exit::invalid_input, {path + ":3", "step number"}, [&] { TableFile::append_after(path, columns, 1); });
}

TEST(TableFile, ResumeRefusesARowThatIsNotOne) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv";
  for (const std::string row : {"2,0.2", "2", "2,0.2,75,75", "nan,0.2,75", "inf,0.2,75", ",,", ""}) {
    const std::string text = "step,t,angle_left\n1,0.1,\n" + row + "\n";
    overwrite(path, text);
    expect_error(Exit::invalid_input, {path + ":3", "row"}, [&] { TableFile::append_after(path, columns, 5); });
    EXPECT_EQ(content_of(path), text);
  }
}

TEST(TableFile, ARemovedTableIsPutBackWithAllItsRows) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv";
  TableFile table = TableFile::create(path, {"step", "t"});
  table.row({0.0, 0.0});
  EXPECT_TRUE(table.in_place());
  std::filesystem::remove(path);
  EXPECT_FALSE(table.in_place());
  table.row({1.0, 0.5});
  table.put_back();
  EXPECT_EQ(content_of(path), "step,t\n0,0\n1,0.5\n");
  EXPECT_FALSE(std::filesystem::exists(path + ".replaced"));
}

TEST(TableFile, AReplacedTableIsPutBackAndWhatStoodThereIsKept) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv", other = folder / "edited";
  TableFile::create(path, {"step", "t"}).row({0.0, 0.0});
  TableFile table = TableFile::append_after(path, {"step", "t"}, 0);
  table.row({1.0, 0.5});
  overwrite(other, "edited\n");
  std::filesystem::rename(other, path);
  EXPECT_FALSE(table.in_place());
  table.put_back();
  EXPECT_EQ(content_of(path), "step,t\n0,0\n1,0.5\n");
  EXPECT_EQ(content_of(path + ".replaced"), "edited\n");
}

TEST(TableFile, APipeIsNotWaitedFor) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  expect_error(Exit::invalid_input, {path, "a pipe"}, [&] { TableFile::append_after(path, {"step", "t"}, 0); });
  TableFile::create(path, {"step", "t"});
  EXPECT_EQ(content_of(path), "step,t\n");
}

}  // namespace
}  // namespace softwet
