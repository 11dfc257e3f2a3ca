// The attributes of Hdf5File: scalars, short lists and texts attached to a group or dataset.
#include "io/hdf5_file.hpp"

namespace softwet {
namespace {

/// Fixed-length, null-padded text as VTKHDF wants it; HDF5 has no empty strings, one null stands for them.
Hdf5Handle text_type(std::size_t length, bool ascii) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), length == 0 ? 1 : length);
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  H5Tset_cset(type.get(), ascii ? H5T_CSET_ASCII : H5T_CSET_UTF8);
  return type;
}

bool is_ascii(const std::string& text) {
  for (const char character : text) {
    if (static_cast<unsigned char>(character) > 127) return false;
  }
  return true;
}

}  // namespace

void Hdf5File::write_attribute(const std::string& object, const std::string& name, hid_t type, hid_t space,
                               const void* data) {
  const std::string failure = "attribute '" + name + "' cannot be written";
  Hdf5Handle attribute = checked(
      H5Acreate_by_name(file_.get(), object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose, failure);
  require(H5Awrite(attribute.get(), type, data) >= 0, failure);
  require(attribute.close(), failure);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, double value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  write_attribute(object, name, H5T_NATIVE_DOUBLE, space.get(), &value);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, std::int64_t value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  write_attribute(object, name, H5T_NATIVE_INT64, space.get(), &value);
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name,
                               const std::vector<std::int64_t>& values) {
  const hsize_t length = values.size();
  const Hdf5Handle space(H5Screate_simple(1, &length, nullptr), H5Sclose);
  write_attribute(object, name, H5T_NATIVE_INT64, space.get(), values.data());
}

void Hdf5File::write_attribute(const std::string& object, const std::string& name, const std::string& text) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle type = text_type(text.size(), is_ascii(text));
  write_attribute(object, name, type.get(), space.get(), text.c_str());
}

bool Hdf5File::has_attribute(const std::string& object, const std::string& name) const {
  return H5Aexists_by_name(file_.get(), object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

void Hdf5File::read_attribute(const std::string& object, const std::string& name, H5T_class_t expected, hid_t type,
                              void* value) const {
  const std::string failure = "value '" + name + (has_attribute(object, name) ? "' is damaged" : "' is missing");
  const auto attribute =
      checked(H5Aopen_by_name(file_.get(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, failure);
  const auto stored = checked(H5Aget_type(attribute.get()), H5Tclose, failure);
  const auto space = checked(H5Aget_space(attribute.get()), H5Sclose, failure);
  const H5T_class_t found = H5Tget_class(stored.get());
  const bool whole_as_real = expected == H5T_FLOAT && found == H5T_INTEGER;
  require(found == expected || whole_as_real, "value '" + name + "' has another type than expected");
  require(H5Sget_simple_extent_npoints(space.get()) == 1, "value '" + name + "' is not a single number");
  require(H5Aread(attribute.get(), type, value) >= 0, failure);
}

double Hdf5File::read_double(const std::string& object, const std::string& name) const {
  double value = 0;
  read_attribute(object, name, H5T_FLOAT, H5T_NATIVE_DOUBLE, &value);
  return value;
}

std::int64_t Hdf5File::read_integer(const std::string& object, const std::string& name) const {
  std::int64_t value = 0;
  read_attribute(object, name, H5T_INTEGER, H5T_NATIVE_INT64, &value);
  return value;
}

std::string Hdf5File::read_text(const std::string& object, const std::string& name) const {
  const std::string failure = "text '" + name + (has_attribute(object, name) ? "' is damaged" : "' is missing");
  const auto attribute =
      checked(H5Aopen_by_name(file_.get(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose, failure);
  const auto stored = checked(H5Aget_type(attribute.get()), H5Tclose, failure);
  require(H5Tget_class(stored.get()) == H5T_STRING && H5Tis_variable_str(stored.get()) == 0,
          "text '" + name + "' has another type than expected");
  std::string text(H5Tget_size(stored.get()), '\0');
  require(H5Aread(attribute.get(), stored.get(), text.data()) >= 0, failure);
  text.resize(text.find_last_not_of('\0') + 1);
  return text;
}

}  // namespace softwet
