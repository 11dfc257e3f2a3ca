// The schema as JSON Schema, which editors and validators of TOML files know.
#pragma once

#include <string>

namespace softwet {

/// Name of the file with the schema that `softwet init` writes beside a case and names in its first line.
inline constexpr const char* schema_file = "softwet.schema.json";

/// JSON Schema (draft 7) of a case file: its tables and keys with their help, types, ranges, choices, and what is
/// required. What depends on several keys, or on the value of an expression, is left to `softwet check`; so the schema
/// accepts every case that the program accepts. Tested: tests/regression/json_schema.py
std::string json_schema();

}  // namespace softwet
