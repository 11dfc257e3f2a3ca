// The fields of fields/*.hdf: their names, units and where they exist. Case file, writer and documentation share it.
#pragma once

#include <string>
#include <vector>

namespace softwet {

enum class FieldShape { scalar, vector, tensor };

struct FieldInfo {
  std::string name;
  FieldShape shape = FieldShape::scalar;
  bool in_fluid = false, in_solid = false;
  std::string unit;  ///< scale of the numbers; "1": none
  std::string meaning;
};

/// All fields, in the order in which they are written.
const std::vector<FieldInfo>& field_table();

std::vector<std::string> field_names();

/// The field of that name, which is one of the table's.
const FieldInfo& field_info(const std::string& name);

}  // namespace softwet
