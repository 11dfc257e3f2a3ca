// HDF5 through its C API: a handle that closes itself, and a file of named datasets and attributes.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace softwet {

/// Owns one HDF5 identifier together with the function that closes it. Move only.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Close closer) : id_(id), close_(closer) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept;
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;
  ~Hdf5Handle() { close(); }

  hid_t get() const { return id_; }
  bool valid() const { return id_ >= 0; }
  /// Closes now. @return false when HDF5 reports a failure (unwritten data, for a file)
  bool close();

 private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// How a dataset lies in the file: one block, or chunks each with a fletcher32 checksum that reading verifies.
enum class Hdf5Storage { contiguous, checksummed };

/// What may read the file: every HDF5 library (needed by VTK), or 1.10 and newer, which checksums its metadata too.
enum class Hdf5Format { compatible, checksummed };

/// An HDF5 file open for writing or for reading. Names are paths ("/VTKHDF/Points"); missing groups on the way are
/// made. Nothing in a file shows when it was written: the same content has the same bytes. Failures are Errors naming
/// the path of the file: machine_failed when writing, invalid_input when reading.
class Hdf5File {
 public:
  /// Creates or truncates.
  static Hdf5File create(const std::string& path, Hdf5Format format);
  /// Opens for reading. @param remedy  what the user should do when the file is missing or damaged; ends the messages
  static Hdf5File open(const std::string& path, const std::string& remedy);

  void make_group(const std::string& name);

  /// Writes a dataset. @param values  size = product of shape, last index fastest. T: double, float, int64, uint8.
  template <class T>
  void write(const std::string& name, const std::vector<T>& values, const std::vector<std::size_t>& shape,
             Hdf5Storage storage = Hdf5Storage::contiguous);

  /// Reads a whole dataset, converted to T. `shape(name)` gives the shape.
  template <class T>
  std::vector<T> read(const std::string& name) const;

  hid_t id() const { return file_.get(); }                        ///< for objects this class does not know; stays owned
  bool has(const std::string& name) const;                        ///< a dataset or group of this name exists
  std::vector<std::size_t> shape(const std::string& name) const;  ///< extents of a dataset

  /// Attributes of a group or dataset (`object`, "/" for the root). Texts are ASCII or UTF-8 of fixed length.
  void write_attribute(const std::string& object, const std::string& name, double value);
  void write_attribute(const std::string& object, const std::string& name, std::int64_t value);
  void write_attribute(const std::string& object, const std::string& name, const std::vector<std::int64_t>& values);
  void write_attribute(const std::string& object, const std::string& name, const std::string& text);
  bool has_attribute(const std::string& object, const std::string& name) const;
  double read_double(const std::string& object, const std::string& name) const;         ///< an integer is converted
  std::int64_t read_integer(const std::string& object, const std::string& name) const;  ///< a double is refused
  std::string read_text(const std::string& object, const std::string& name) const;

  /// Writes everything out and closes. Throws Error (machine_failed) when the disk did not take it.
  void close();

  /// Throws the Error of this file: "PATH: what (reason of HDF5); remedy".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  Hdf5File(Hdf5Handle file, std::string path, std::string remedy);
  void make_groups_above(const std::string& name);
  Hdf5Handle checked(hid_t id, Hdf5Handle::Close closer, const std::string& what) const;
  void require(bool succeeded, const std::string& what) const;
  void write_attribute(const std::string& object, const std::string& name, hid_t type, hid_t space, const void* data);
  void read_attribute(const std::string& object, const std::string& name, H5T_class_t expected, hid_t type,
                      void* value) const;

  Hdf5Handle file_;
  std::string path_;
  std::string remedy_;  ///< empty: the file is being written
};

}  // namespace softwet
