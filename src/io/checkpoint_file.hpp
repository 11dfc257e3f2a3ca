// The checkpoint: named numbers, texts and arrays in one HDF5 file that is whole, or absent, and knows when it is
// damaged.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/atomic_file.hpp"

namespace softwet {

class Hdf5File;

/// Writes PATH.partial; only `commit()` replaces PATH. Every method throws Error (machine_failed) when the disk fails.
/// Each name is used once per kind; "fluid/density" makes a group. Data and metadata carry checksums.
class CheckpointWriter {
 public:
  explicit CheckpointWriter(const std::string& path);
  ~CheckpointWriter();

  void value(const std::string& name, double number);
  void value(const std::string& name, std::int64_t number);
  void value(const std::string& name, int number) { value(name, std::int64_t(number)); }
  void value(const std::string& name, const std::string& text);
  void array(const std::string& name, const std::vector<double>& values);
  void single_array(const std::string& name, const std::vector<float>& values);  ///< read by `array` too

  /// Flushes, closes, brings the file to the disk and renames it. Nothing can be added afterwards.
  void commit();

 private:
  AtomicFile target_;
  std::unique_ptr<Hdf5File> file_;
};

/// Reads what CheckpointWriter wrote. Every method throws Error (invalid_input) naming the path, the fault and the
/// remedy: missing file or name, not HDF5, not a checkpoint, unknown format version, damage, another size or type.
class CheckpointReader {
 public:
  /// Formats that are read: 1 has other names than 2, but for the arrays of the state.
  static constexpr std::int64_t format_of_runs = 2, format_of_states = 1;

  /// @param oldest  format that will do
  explicit CheckpointReader(const std::string& path, std::int64_t oldest = format_of_runs);
  ~CheckpointReader();

  double number(const std::string& name) const;
  std::int64_t integer(const std::string& name) const;
  std::string text(const std::string& name) const;
  /// @param expected_size  number of values this case needs; another size means a checkpoint of another mesh
  std::vector<double> array(const std::string& name, std::size_t expected_size) const;
  bool has(const std::string& name) const;  ///< a number, text or array of this name exists

 private:
  std::string path_;
  std::unique_ptr<Hdf5File> file_;
};

}  // namespace softwet
