// Tables: exact numbers, empty cells, and resuming after a checkpoint.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stdexcept>

#include "expect_error.hpp"
#include "io/number_text.hpp"
#include "io/table_file.hpp"
#include "scratch_folder.hpp"

namespace softwet {
namespace {

const std::vector<std::string> columns = {"step", "t", "angle_left"};

TableRow row(double step, double t, const TableRow::Cell& angle) {
  return {{"step", step}, {"t", t}, {"angle_left", angle}};
}

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
    table.row(row(1.0, 0.1, std::nullopt));
    table.row(row(2.0, 1e-20, 74.5));
  }
  EXPECT_EQ(content_of(path), "step,t,angle_left\n1,0.1,\n2,1e-20,74.5\n");
}

TEST(TableFile, FlushHandsOverTheRows) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv";
  TableFile table = TableFile::create(path, columns);
  table.row(row(1.0, 0.1, 2.0));
  table.flush();
  EXPECT_EQ(content_of(path), "step,t,angle_left\n1,0.1,2\n");
}

TEST(TableFile, OrdersTheCellsOfARow) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv";
  TableFile::create(path, columns).row({{"angle_left", 74.5}, {"step", 2}, {"t", 0.1}});
  EXPECT_EQ(content_of(path), "step,t,angle_left\n2,0.1,74.5\n");
}

TEST(TableFile, RefusesNumbersThatAreNotFiniteAndRowsOfAnotherTable) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv";
  {
    TableFile table = TableFile::create(path, columns);
    expect_error(Exit::computation_failed, {path, "'t'", "nan", "step 7"}, [&] { table.row(row(7.0, NAN, 1.0)); });
    expect_error(Exit::computation_failed, {path, "'angle_left'", "inf"}, [&] { table.row(row(7.0, 1.0, INFINITY)); });
    EXPECT_THROW(table.row({{"step", 7}, {"t", 1}}), std::logic_error);
    EXPECT_THROW(table.row({{"step", 7}, {"t", 1}, {"angle_right", 1}}), std::logic_error);
    EXPECT_THROW(table.row({{"step", 7}, {"t", 1}, {"angle_left", 1}, {"angle_right", 1}}), std::logic_error);
  }
  EXPECT_EQ(content_of(path), "step,t,angle_left\n");
}

/// A table with rows up to a checkpoint and one behind it, and the mark of the checkpoint.
struct MarkedTable {
  static constexpr const char *kept = "step,t,angle_left\n0,0,75\n2,0.2,\n4,0.4,74\n", *rest = "6,0.6,73\n";
  ScratchFolder folder;
  std::string path = folder / "history.csv";
  TableMark mark;

  MarkedTable() {
    TableFile table = TableFile::create(path, columns);
    table.row(row(0.0, 0.0, 75.0));
    table.row(row(2.0, 0.2, std::nullopt));
    table.row(row(4.0, 0.4, 74.0));
    table.keep();
    table.row(row(6.0, 0.6, 73.0));
    table.bring_to_disk();
    mark = table.kept();
  }
};

TEST(TableFile, ResumeGoesOnBehindTheMark) {
  const MarkedTable t;
  EXPECT_EQ(content_of(t.path), std::string(t.kept) + t.rest);
  EXPECT_EQ(t.mark.rows, 3);
  EXPECT_EQ(t.mark.bytes, static_cast<std::int64_t>(std::string(t.kept).size()));
  // Whatever a run that was killed has left behind the mark.
  for (const std::string behind : {"", "6,0.6,73\n", "6,0", "6,0.6,73\n8,0.8", "abc\n"}) {
    overwrite(t.path, t.kept + behind);
    TableFile table = TableFile::append_after(t.path, columns, t.mark);
    EXPECT_EQ(table.kept(), t.mark);
    table.row(row(6.0, 0.7, 72.0));
    table.flush();
    EXPECT_EQ(content_of(t.path), std::string(t.kept) + "6,0.7,72\n");
    table.keep();
    EXPECT_EQ(table.kept().rows, 4);
  }
}

TEST(TableFile, ResumeRefusesRowsThatTheRunHasNotWritten) {
  const MarkedTable t;
  const std::string header = "step,t,angle_left\n";
  const auto refuses = [&](const std::string& text, std::initializer_list<std::string> parts) {
    overwrite(t.path, text);
    expect_error(Exit::invalid_input, parts, [&] { TableFile::append_after(t.path, columns, t.mark); });
    EXPECT_EQ(content_of(t.path), text);
  };
  const std::string remedy = "put back the file";
  refuses(header + "0,0,75\n4,0.4,74\n", {t.path + ":3", "2 of the 3 rows", remedy});  // missing
  refuses(header + "0,0,75\n4,0.4,74\n6,0.6,73\n",
          {t.path + ": ", "lines 2 to 4", "checksum", remedy});  // with a later one
  refuses(header + "0,0,75\n2,0.2,\n2,0.2,\n4,0.4,74\n", {t.path + ":4", "step 2 follows 2", remedy});  // repeated
  refuses(header + "4,0.4,74\n2,0.2,\n0,0,75\n", {t.path + ":3", "step 2 follows 4", remedy});          // reversed
  refuses(header + "0,0,75\n2,0.2\n4,0.4,74\n", {t.path + ":3", "2 cells for 3 columns", remedy});      // cut
  refuses(header + "0,0,75\n2,0.2,\n4,0.4", {t.path + ":3", "2 of the 3 rows", remedy});
  refuses(header + "0,0,75\n2,0.2,\n4.5,0.4,74\n", {t.path + ":4", "4.5", "whole numbers", remedy});
  refuses(header + "0,0,75\nabc,0.2,\n4,0.4,74\n", {t.path + ":3", "step number", remedy});
  refuses(header + "0,0,75\n2,0.3,\n4,0.4,74\n", {t.path + ": ", "checksum", remedy});  // another number
  refuses(header + "0,0,75\r\n2,0.2,\r\n4,0.4,74\r\n", {t.path + ": ", "checksum", remedy});
  refuses("step,t\n0,0\n", {t.path + ":1", "header", remedy});
}

TEST(TableFile, ResumeRefusesAMissingTableAndTakesAnEmptyOne) {
  const MarkedTable t;
  std::filesystem::remove(t.path);
  expect_error(Exit::invalid_input, {t.path, "missing", "3 rows", "an empty file"},
               [&] { TableFile::append_after(t.path, columns, t.mark); });
  EXPECT_FALSE(std::filesystem::exists(t.path));
  overwrite(t.path, "");
  EXPECT_EQ(TableFile::append_after(t.path, columns, t.mark).kept().rows, 0);
  EXPECT_EQ(content_of(t.path), "step,t,angle_left\n");
}

TEST(TableFile, ResumeNamesTheRowThatIsNotOne) {
  const MarkedTable t;
  for (const std::string row :
       {"2,0.2", "2", "2,0.2,75,75", "nan,0.2,75", "inf,0.2,75", ",,", "", "1,0.2,75", "0,0.2,75", "1.5,0.2,75"}) {
    const std::string text = "step,t,angle_left\n1,0.1,\n" + row + "\n";
    overwrite(t.path, text);
    expect_error(Exit::invalid_input, {t.path + ":3"}, [&] { TableFile::append_after(t.path, columns, t.mark); });
    EXPECT_EQ(content_of(t.path), text);
  }
}

TEST(TableFile, ARemovedTableIsPutBackWithAllItsRows) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv";
  TableFile table = TableFile::create(path, {"step", "t"});
  table.row({{"step", 0.0}, {"t", 0.0}});
  EXPECT_TRUE(table.in_place());
  std::filesystem::remove(path);
  EXPECT_FALSE(table.in_place());
  table.row({{"step", 1.0}, {"t", 0.5}});
  table.put_back();
  EXPECT_EQ(content_of(path), "step,t\n0,0\n1,0.5\n");
  EXPECT_FALSE(std::filesystem::exists(path + ".replaced"));
}

TEST(TableFile, AReplacedTableIsPutBackAndWhatStoodThereIsKept) {
  const ScratchFolder folder;
  const std::string path = folder / "history.csv", other = folder / "edited";
  TableFile::create(path, {"step", "t"}).row({{"step", 0.0}, {"t", 0.0}});
  TableMark mark;
  mark.add(content_of(path));
  TableFile table = TableFile::append_after(path, {"step", "t"}, mark);
  table.row({{"step", 1.0}, {"t", 0.5}});
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
  expect_error(Exit::invalid_input, {path, "a pipe"}, [&] { TableFile::append_after(path, {"step", "t"}, {}); });
  TableFile::create(path, {"step", "t"});
  EXPECT_EQ(content_of(path), "step,t\n");
}

}  // namespace
}  // namespace softwet
