// The checkpoint: exact round trip, whole or absent, and every kind of damage is reported instead of read.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "expect_error.hpp"
#include "io/checkpoint_file.hpp"
#include "io/hdf5_file.hpp"
#include "scratch_folder.hpp"

namespace softwet {
namespace {

const std::string case_text = "name = \"drop\"\n# \xC3\xA9";

std::vector<double> density() {
  std::vector<double> values;
  for (int i = 0; i < 300; ++i) values.push_back(std::sin(0.1 * i));
  return values;
}

void write_checkpoint(const std::string& path) {
  CheckpointWriter writer(path);
  writer.value("t", 0.1);
  writer.value("step", std::int64_t{1} << 60);
  writer.value("case", case_text);
  writer.value("empty", std::string());
  writer.array("fluid/density", density());
  writer.array("none", {});
  writer.commit();
}

TEST(CheckpointFile, ReadsBackWhatWasWritten) {
  const ScratchFolder folder;
  const std::string path = folder / "new/folder/checkpoint.h5";
  write_checkpoint(path);
  const CheckpointReader reader(path);
  EXPECT_EQ(reader.number("t"), 0.1);
  EXPECT_EQ(reader.integer("step"), std::int64_t{1} << 60);
  EXPECT_EQ(reader.text("case"), case_text);
  EXPECT_EQ(reader.text("empty"), "");
  EXPECT_EQ(reader.array("fluid/density", 300), density());
  EXPECT_TRUE(reader.array("none", 0).empty());
  EXPECT_FALSE(std::filesystem::exists(path + ".partial"));
}

TEST(CheckpointFile, KeepsSpecialNumbersAndManyChunks) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  std::vector<double> values(300000);  // three chunks, the last one not full
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1.0 / double(i + 1);
  values[7] = -0.0;
  values[8] = std::numeric_limits<double>::denorm_min();
  CheckpointWriter writer(path);
  for (int i = 0; i < 100; ++i) writer.value("value_" + std::to_string(i), i);
  writer.array("values", values);
  writer.commit();
  const CheckpointReader reader(path);
  EXPECT_EQ(reader.array("values", values.size()), values);
  EXPECT_TRUE(std::signbit(reader.array("values", values.size())[7]));
  EXPECT_EQ(reader.integer("value_99"), 99);
}

TEST(CheckpointFile, KnowsItsNames) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  write_checkpoint(path);
  const CheckpointReader reader(path);
  for (const char* name : {"t", "step", "case", "fluid/density"}) EXPECT_TRUE(reader.has(name)) << name;
  for (const char* name : {"dt", "solid/density", "fluid/density/x"}) EXPECT_FALSE(reader.has(name)) << name;
}

TEST(CheckpointFile, WithoutCommitTheOldOneStays) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  write_checkpoint(path);
  {
    CheckpointWriter writer(path);
    writer.value("t", 0.2);
    EXPECT_TRUE(std::filesystem::exists(path + ".partial"));
  }
  EXPECT_FALSE(std::filesystem::exists(path + ".partial"));
  EXPECT_EQ(CheckpointReader(path).number("t"), 0.1);
  write_checkpoint(path);
  EXPECT_EQ(CheckpointReader(path).number("t"), 0.1);
}

TEST(CheckpointFile, NamesWhatIsMissingOrOfAnotherKind) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  expect_error(Exit::invalid_input, {path, "no such file", "--resume"}, [&] { CheckpointReader reader(path); });
  write_checkpoint(path);
  const CheckpointReader reader(path);
  expect_error(Exit::invalid_input, {path, "'dt'", "missing"}, [&] { reader.number("dt"); });
  expect_error(Exit::invalid_input, {path, "'t'", "another type"}, [&] { reader.integer("t"); });
  expect_error(Exit::invalid_input, {path, "'/texts/x'", "missing"}, [&] { reader.text("x"); });
  expect_error(Exit::invalid_input, {path, "'/arrays/x'", "missing"}, [&] { reader.array("x", 3); });
  expect_error(Exit::invalid_input, {path, "'fluid/density'", "300", "301", "belongs to another mesh"},
               [&] { reader.array("fluid/density", 301); });
}

TEST(CheckpointFile, RefusesFilesOfOthersAndOtherVersions) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  overwrite(path, "step,t\n1,0.1\n");
  expect_error(Exit::invalid_input, {path, "not an HDF5 file"}, [&] { CheckpointReader reader(path); });
  Hdf5File::create(path, Hdf5Format::compatible).close();
  expect_error(Exit::invalid_input, {path, "not a checkpoint"}, [&] { CheckpointReader reader(path); });
  Hdf5File file = Hdf5File::create(path, Hdf5Format::checksummed);
  file.write_attribute("/", "format", std::string("softwet checkpoint"));
  file.write_attribute("/", "format_version", std::int64_t{99});
  file.close();
  expect_error(Exit::invalid_input, {path, "format 99", "reads format 2", "initial.from"},
               [&] { CheckpointReader reader(path); });
}

TEST(CheckpointFile, RefusesShapesThatNoFileCanHold) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  const std::vector<std::vector<hsize_t>> shapes{{hsize_t{1} << 40, 1}, {hsize_t{1} << 32, hsize_t{1} << 32}};
  for (const std::vector<hsize_t>& shape : shapes) {
    Hdf5File file = Hdf5File::create(path, Hdf5Format::checksummed);
    file.make_group("/texts");
    const Hdf5Handle space(H5Screate_simple(2, shape.data(), nullptr), H5Sclose);
    Hdf5Handle text(
        H5Dcreate2(file.id(), "/texts/case", H5T_NATIVE_UINT8, space.get(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
        H5Dclose);
    ASSERT_TRUE(text.valid() && text.close());
    file.close();
    const Hdf5File again = Hdf5File::open(path, "--resume");
    ASSERT_TRUE(again.has("/texts/case"));
    expect_error(Exit::invalid_input, {path, "damaged"}, [&] { again.read<std::uint8_t>("/texts/case"); });
  }
}

/// Reads everything. @return false when an Error reported damage; a wrong value is a test failure.
bool reads_well(const std::string& path) {
  try {
    const CheckpointReader reader(path);
    EXPECT_EQ(reader.number("t"), 0.1);
    EXPECT_EQ(reader.integer("step"), std::int64_t{1} << 60);
    EXPECT_EQ(reader.text("case"), case_text);
    EXPECT_EQ(reader.array("fluid/density", 300), density());
    return true;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), Exit::invalid_input) << error.what();
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos);
    return false;
  }
}

TEST(CheckpointFile, AnyFlippedByteIsFoundOrHarmless) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  write_checkpoint(path);
  const std::string whole = content_of(path);
  int found = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    overwrite(path, damaged);
    if (!reads_well(path)) ++found;
    ASSERT_FALSE(HasFailure()) << "byte " << at << " of " << whole.size();
  }
  EXPECT_GT(found, 2400);  // at least all bytes of the array
}

TEST(CheckpointFile, ATruncatedFileIsRefused) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  write_checkpoint(path);
  const std::string whole = content_of(path);
  for (std::size_t length = 0; length < whole.size(); length += 97) {
    overwrite(path, whole.substr(0, length));
    expect_error(Exit::invalid_input, {path, "not an HDF5 file, or its beginning or end is damaged"},
                 [&] { CheckpointReader reader(path); });
  }
}

TEST(CheckpointFile, APipeOrADeviceIsNotReadFor) {
  const ScratchFolder folder;
  const std::string path = folder / "checkpoint.h5";
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  expect_error(Exit::invalid_input, {path, "a pipe"}, [&] { CheckpointReader reader(path); });
  expect_error(Exit::invalid_input, {"/dev/zero", "a device"}, [] { CheckpointReader reader("/dev/zero"); });
  ASSERT_EQ(::mkfifo((path + ".partial").c_str(), 0600), 0);
  CheckpointWriter writer(path);
  writer.value("time", 1.0);
  writer.commit();
  EXPECT_EQ(CheckpointReader(path).number("time"), 1.0);
}

}  // namespace
}  // namespace softwet
