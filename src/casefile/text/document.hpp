// A case file as a list of known keys with values, each with the place it came from: syntax and types, no meaning yet.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "casefile/schema/schema.hpp"
#include "casefile/text/problems.hpp"

namespace softwet {

struct Entry {
  const Key* key = nullptr;
  std::size_t index = 0;  ///< entry of a repeated table
  Value value;
  std::string text;   ///< the value as the user wrote it
  std::string place;  ///< "case.toml:12" or "--set fluid.viscosity=-1"
};

struct Document {
  std::string place;                               ///< name of the file
  std::map<std::string, Entry> entries;            ///< by indexed name, "load[0].box"
  std::map<std::string, std::size_t> table_count;  ///< tables present, by schema name, "fluid", "load[]"
  std::map<std::string, std::string> table_place;  ///< where the tables begin, by indexed name, "load[0]"
};

/// Reads TOML text. Broken lines, unknown keys and values of the wrong type or out of range go to `problems`.
Document read_document(std::string_view text, const std::string& place, Problems& problems);

/// Applies one "key=value" of the command line, as if the file had said so; entries of lists as "load[0].ramp=2". A
/// table is replaced as a whole, "substrate.gel={ exponent = 0.5, time = 1 }"; what is wrong in it goes to `problems`,
/// all else is thrown as CaseError.
void apply_override(Document& document, const std::string& assignment, Problems& problems);

/// An entry for a number that no text has, checked against its key. Throws CaseError.
Entry entry_of_number(const Key& key, std::size_t index, double number, const std::string& place);

/// The value in the text of one TOML value, checked against its key. Throws CaseError.
Value value_from_text(const Key& key, const std::string& text);

}  // namespace softwet
