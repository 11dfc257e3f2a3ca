#include "io/hdf5_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <utility>

#include "case/error.hpp"
#include "io/atomic_file.hpp"
#include "io/path_state.hpp"

namespace softwet {
namespace {

constexpr hsize_t chunk_length = 131072;  // elements at most: 1 MiB of doubles, the chunk cache of HDF5

template <class T>
hid_t native_type();
template <>
hid_t native_type<double>() {
  return H5T_NATIVE_DOUBLE;
}
template <>
hid_t native_type<float>() {
  return H5T_NATIVE_FLOAT;
}
template <>
hid_t native_type<std::int64_t>() {
  return H5T_NATIVE_INT64;
}
template <>
hid_t native_type<std::uint8_t>() {
  return H5T_NATIVE_UINT8;
}

herr_t keep_innermost(unsigned, const H5E_error2_t* error, void* text) {
  *static_cast<std::string*>(text) = error->desc != nullptr ? error->desc : "";
  return 1;  // the first entry of an upward walk is the innermost: stop there
}

/// The innermost entry of the HDF5 error stack; of a failed system call only the words of the system.
std::string reason_of_hdf5() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  const std::string marker = "error message = '";
  const auto begin = reason.find(marker);
  if (begin == std::string::npos) return reason;
  const auto end = reason.find('\'', begin + marker.size());
  return reason.substr(begin + marker.size(), end - begin - marker.size());
}

/// The library itself, tidied at exit unless a write has failed: HDF5 then crashes on data it still holds for the file,
/// which would hide the exit code of the program.
struct Library {
  bool write_failed = false;
  Library() { H5dont_atexit(); }
  ~Library() {
    if (!write_failed) H5close();
  }
};

Library& library() {
  static Library instance;
  return instance;
}

/// A list of creation properties without times: the same content has the same bytes, whenever it is written.
Hdf5Handle without_times(hid_t kind) {
  Hdf5Handle properties(H5Pcreate(kind), H5Pclose);
  H5Pset_obj_track_times(properties.get(), false);
  return properties;
}

Hdf5Handle file_access(Hdf5Format format) {
  library();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // failures are reported by our own Errors
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fclose_degree(access.get(), H5F_CLOSE_STRONG);
  H5Pset_file_locking(access.get(), false, true);  // many cluster file systems have no locks; renaming protects readers
  if (format == Hdf5Format::checksummed) H5Pset_libver_bounds(access.get(), H5F_LIBVER_V110, H5F_LIBVER_V110);
  return access;
}

}  // namespace

Hdf5Handle::Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& other) noexcept {
  std::swap(id_, other.id_);
  std::swap(close_, other.close_);
  return *this;
}

bool Hdf5Handle::close() {
  const hid_t id = std::exchange(id_, -1);
  return id < 0 || close_(id) >= 0;
}

Hdf5File::Hdf5File(Hdf5Handle file, std::string path, std::string remedy)
    : file_(std::move(file)), path_(std::move(path)), remedy_(std::move(remedy)) {}

Hdf5File Hdf5File::create(const std::string& path, Hdf5Format format) {
  const Hdf5Handle access = file_access(format), creation = without_times(H5P_FILE_CREATE);
  Hdf5File result({H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.get(), access.get()), H5Fclose}, path, "");
  result.require(result.file_.valid(), "cannot be created");
  return result;
}

Hdf5File Hdf5File::open(const std::string& path, const std::string& remedy) {
  if (const std::string kind = no_regular_file(path); !kind.empty())
    throw Error(Exit::invalid_input, path + ": is " + kind + " and no file; " + remedy);
  if (::access(path.c_str(), R_OK) != 0) {
    if (errno != ENOENT && errno != ENOTDIR) throw_disk_error(path, "cannot be read", errno);
    throw Error(Exit::invalid_input, path + ": there is no such file; " + remedy);
  }
  const Hdf5Handle access = file_access(Hdf5Format::compatible);
  Hdf5File result({H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose}, path, remedy);
  result.require(result.file_.valid(), "is not an HDF5 file, or its beginning or end is damaged");
  return result;
}

void Hdf5File::fail(const std::string& what) const {
  const std::string reason = reason_of_hdf5();
  const std::string told = path_ + ": " + what + (reason.empty() ? "" : " (HDF5: " + reason + ")") + "; ";
  if (!remedy_.empty()) throw Error(Exit::invalid_input, told + remedy_);
  library().write_failed = true;
  throw Error(Exit::machine_failed,
              told +
                  "check free space, the limit of the size of a file (ulimit -f) and write permission, or give a "
                  "folder on another disk with --out (to resume: a copy of this one)");
}

void Hdf5File::require(bool succeeded, const std::string& what) const {
  if (!succeeded) fail(what);
}

Hdf5Handle Hdf5File::checked(hid_t id, Hdf5Handle::Close closer, const std::string& what) const {
  require(id >= 0, what);
  return Hdf5Handle(id, closer);
}

void Hdf5File::make_groups_above(const std::string& name) {
  for (std::size_t end = name.find('/', 1); end != std::string::npos; end = name.find('/', end + 1)) {
    const std::string group = name.substr(0, end);
    if (H5Lexists(file_.get(), group.c_str(), H5P_DEFAULT) <= 0) make_group(group);
  }
}

void Hdf5File::make_group(const std::string& name) {
  make_groups_above(name);
  const Hdf5Handle creation = without_times(H5P_GROUP_CREATE);
  checked(H5Gcreate2(file_.get(), name.c_str(), H5P_DEFAULT, creation.get(), H5P_DEFAULT), H5Gclose,
          "group '" + name + "' cannot be written");
}

template <class T>
void Hdf5File::write(const std::string& name, const std::vector<T>& values, const std::vector<std::size_t>& shape,
                     Hdf5Storage storage) {
  const std::string failure = "dataset '" + name + "' cannot be written";
  const std::vector<hsize_t> extents(shape.begin(), shape.end());
  std::size_t size = 1;
  for (const std::size_t extent : shape) size *= extent;
  if (size != values.size()) {
    throw Error(Exit::computation_failed, path_ + ": " + failure + ": it has " + std::to_string(values.size()) +
                                              " values where its shape has " + std::to_string(size) +
                                              "; this is an error in softwet, please report it");
  }
  const auto space = checked(H5Screate_simple(int(extents.size()), extents.data(), nullptr), H5Sclose, failure);
  make_groups_above(name);
  const Hdf5Handle layout = without_times(H5P_DATASET_CREATE);
  if (storage == Hdf5Storage::checksummed && !values.empty()) {
    std::vector<hsize_t> chunk(extents.size(), 1);
    const hsize_t pieces = (extents.back() + chunk_length - 1) / chunk_length;
    chunk.back() = (extents.back() + pieces - 1) / pieces;
    H5Pset_chunk(layout.get(), int(chunk.size()), chunk.data());
    H5Pset_fletcher32(layout.get());
  }
  Hdf5Handle dataset = checked(
      H5Dcreate2(file_.get(), name.c_str(), native_type<T>(), space.get(), H5P_DEFAULT, layout.get(), H5P_DEFAULT),
      H5Dclose, failure);
  if (!values.empty()) {
    require(H5Dwrite(dataset.get(), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, failure);
  }
  require(dataset.close(), failure);
}

template <class T>
std::vector<T> Hdf5File::read(const std::string& name) const {
  const std::string failure = "dataset '" + name + "' is damaged";
  // A damaged header may claim any size, also one whose product overflows: more than the file can hold is refused
  // before memory is asked for.
  hsize_t bytes_in_file = 0;
  require(H5Fget_filesize(file_.get(), &bytes_in_file) >= 0, failure);
  std::size_t size = 1;
  for (const std::size_t extent : shape(name)) {
    require(extent == 0 || size <= bytes_in_file / extent, failure);
    size *= extent;
  }
  const auto dataset = checked(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose, failure);
  std::vector<T> values(size);
  if (size == 0) return values;
  require(H5Dread(dataset.get(), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, failure);
  return values;
}

bool Hdf5File::has(const std::string& name) const {
  for (std::size_t end = name.find('/', 1); end != std::string::npos; end = name.find('/', end + 1)) {
    if (H5Lexists(file_.get(), name.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
  }
  return H5Lexists(file_.get(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::size_t> Hdf5File::shape(const std::string& name) const {
  const std::string failure = "dataset '" + name + (has(name) ? "' is damaged" : "' is missing");
  const auto dataset = checked(H5Dopen2(file_.get(), name.c_str(), H5P_DEFAULT), H5Dclose, failure);
  const auto space = checked(H5Dget_space(dataset.get()), H5Sclose, failure);
  const int rank = H5Sget_simple_extent_ndims(space.get());
  require(rank >= 0, failure);
  std::vector<hsize_t> extents(static_cast<std::size_t>(rank));
  require(H5Sget_simple_extent_dims(space.get(), extents.data(), nullptr) >= 0, failure);
  return {extents.begin(), extents.end()};
}

void Hdf5File::close() {
  if (!file_.valid()) return;
  const bool flushed = remedy_.empty() ? H5Fflush(file_.get(), H5F_SCOPE_GLOBAL) >= 0 : true;
  require(flushed, "cannot be written");
  require(file_.close(), "cannot be written");
}

template void Hdf5File::write(const std::string&, const std::vector<double>&, const std::vector<std::size_t>&,
                              Hdf5Storage);
template void Hdf5File::write(const std::string&, const std::vector<float>&, const std::vector<std::size_t>&,
                              Hdf5Storage);
template void Hdf5File::write(const std::string&, const std::vector<std::int64_t>&, const std::vector<std::size_t>&,
                              Hdf5Storage);
template void Hdf5File::write(const std::string&, const std::vector<std::uint8_t>&, const std::vector<std::size_t>&,
                              Hdf5Storage);
template std::vector<double> Hdf5File::read(const std::string&) const;
template std::vector<float> Hdf5File::read(const std::string&) const;
template std::vector<std::int64_t> Hdf5File::read(const std::string&) const;
template std::vector<std::uint8_t> Hdf5File::read(const std::string&) const;

}  // namespace softwet
