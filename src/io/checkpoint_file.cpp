#include "io/checkpoint_file.hpp"

#include "case/error.hpp"
#include "io/hdf5_file.hpp"

namespace softwet {
namespace {

constexpr std::int64_t format_version = CheckpointReader::format_of_runs;
const std::string format_name = "softwet checkpoint";
const std::string values_group = "/values";
const std::string texts_group = "/texts/";
const std::string arrays_group = "/arrays/";
const std::string remedy = "start anew without --resume, or put back the checkpoint.h5 that this case wrote";

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw Error(Exit::invalid_input, path + ": " + what + "; " + remedy);
}

}  // namespace

CheckpointWriter::CheckpointWriter(const std::string& path)
    : target_(path),
      file_(std::make_unique<Hdf5File>(Hdf5File::create(target_.partial_path(), Hdf5Format::checksummed))) {
  file_->write_attribute("/", "format", format_name);
  file_->write_attribute("/", "format_version", format_version);
  file_->make_group(values_group);
}

CheckpointWriter::~CheckpointWriter() = default;

void CheckpointWriter::value(const std::string& name, double number) {
  file_->write_attribute(values_group, name, number);
}

void CheckpointWriter::value(const std::string& name, std::int64_t number) {
  file_->write_attribute(values_group, name, number);
}

void CheckpointWriter::value(const std::string& name, const std::string& text) {
  // A dataset, because an attribute holds 64 KiB at most and a resolved case may be longer.
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  file_->write(texts_group + name, bytes, {bytes.size()}, Hdf5Storage::checksummed);
}

void CheckpointWriter::array(const std::string& name, const std::vector<double>& values) {
  file_->write(arrays_group + name, values, {values.size()}, Hdf5Storage::checksummed);
}

void CheckpointWriter::single_array(const std::string& name, const std::vector<float>& values) {
  file_->write(arrays_group + name, values, {values.size()}, Hdf5Storage::checksummed);
}

void CheckpointWriter::commit() {
  file_->close();
  target_.commit();
}

CheckpointReader::CheckpointReader(const std::string& path, std::int64_t oldest)
    : path_(path), file_(std::make_unique<Hdf5File>(Hdf5File::open(path, remedy))) {
  if (!file_->has_attribute("/", "format") || file_->read_text("/", "format") != format_name) {
    refuse(path, "is not a checkpoint of softwet, or is damaged");
  }
  const std::int64_t version = file_->read_integer("/", "format_version");
  if (version < oldest || version > format_version) {
    refuse(path, "has checkpoint format " + std::to_string(version) + ", this program reads format " +
                     std::to_string(format_version) +
                     " (resume with the program that wrote it, or begin a new run from its last state: initial.from)");
  }
}

CheckpointReader::~CheckpointReader() = default;

double CheckpointReader::number(const std::string& name) const { return file_->read_double(values_group, name); }

std::int64_t CheckpointReader::integer(const std::string& name) const {
  return file_->read_integer(values_group, name);
}

std::string CheckpointReader::text(const std::string& name) const {
  const std::vector<std::uint8_t> bytes = file_->read<std::uint8_t>(texts_group + name);
  return {bytes.begin(), bytes.end()};
}

std::vector<double> CheckpointReader::array(const std::string& name, std::size_t expected_size) const {
  const std::vector<std::size_t> shape = file_->shape(arrays_group + name);
  if (shape != std::vector<std::size_t>{expected_size}) {
    const std::string found = shape.size() == 1 ? std::to_string(shape[0]) + " values" : "another shape";
    refuse(path_, "array '" + name + "' has " + found + " where this case needs " + std::to_string(expected_size) +
                      ": the checkpoint belongs to another mesh, degree or set of fields");
  }
  return file_->read<double>(arrays_group + name);
}

bool CheckpointReader::has(const std::string& name) const {
  return file_->has_attribute(values_group, name) || file_->has(texts_group + name) || file_->has(arrays_group + name);
}

}  // namespace softwet
