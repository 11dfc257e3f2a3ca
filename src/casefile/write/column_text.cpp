#include "casefile/write/column_text.hpp"

#include <fmt/core.h>

#include "casefile/schema/schema.hpp"
#include "io/run_record.hpp"
#include "observe/host/table_columns.hpp"

namespace softwet {
namespace {

/// The name without the number of a droplet behind the first: "velocity" of "velocity_2".
std::string without_number(const std::string& name) {
  const auto end = name.find_last_not_of("0123456789");
  const bool numbered = end != std::string::npos && end > 0 && end + 1 < name.size() && name[end] == '_';
  return numbered ? name.substr(0, end) : name;
}

std::string dimension_note(const Column& column) {
  return column.dimension == 0 ? "" : fmt::format("Only in {}D. ", column.dimension);
}

std::string explain_column(const ColumnTable& table, const Column& column) {
  const std::string unit = column.unit.empty() ? "a pure number" : "unit " + column.unit;
  return fmt::format("{}.{}\n    {}{}\n    in {}, {}\n", table.name, column.name, dimension_note(column),
                     column.meaning, table.file, unit);
}

/// Text for a cell of a Markdown table.
std::string cell(const std::string& text) {
  std::string escaped;
  for (char c : text) {
    if (c == '|' || c == '*' || c == '<' || c == '_') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string code(const std::string& text) {
  if (text.empty()) return "";
  std::string escaped;
  for (char c : text) escaped += c == '|' ? "\\|" : std::string(1, c);
  return "`" + escaped + "`";
}

std::string default_cell(const Key& key) {
  if (key.required) return "required";
  return key.default_note.empty() ? code(default_text(key)) : cell(key.default_note);
}

std::string key_section(const Table& table) {
  std::string text;
  if (!table.name.empty()) {
    const std::string plain = table.name.substr(0, table.name.find('['));
    text = fmt::format("\n### {}\n\n{}.\n", table.repeated ? "[[" + plain + "]]" : "[" + plain + "]", cell(table.help));
  }
  text += "\n| key | meaning | allowed | unit | default |\n|---|---|---|---|---|\n";
  for (const Key& key : schema()) {
    if (key.table() != table.name) continue;
    const std::string reason = key.reason.empty() ? "" : " (" + cell(key.reason) + ")";
    text += fmt::format("| {} | {} | {}{} | {} | {} |\n", code(key.leaf()), cell(key.help), cell(allowed_text(key)),
                        reason, code(key.unit), default_cell(key));
  }
  return text;
}

std::string column_section(const ColumnTable& table) {
  std::string text =
      fmt::format("\n## `{}`\n\n{}\n\n| name | meaning | unit |\n|---|---|---|\n", table.file, cell(table.meaning));
  for (const Column& column : table.columns)
    text += fmt::format("| {} | {}{} | {} |\n", code(column.name), dimension_note(column), cell(column.meaning),
                        code(column.unit));
  return text;
}

}  // namespace

std::string explain_columns(const std::string& name) {
  const std::string plain = without_number(name);
  std::string text;
  for (const ColumnTable& table : column_tables()) {
    const bool whole = name == table.name || name == table.file;
    if (whole) text += fmt::format("{}\n    {}\n\n", table.file, table.meaning);
    for (const Column& column : table.columns)
      if (whole || plain == column.name || plain == table.name + "." + column.name)
        text += explain_column(table, column);
  }
  return text;
}

std::vector<std::string> column_names() {
  std::vector<std::string> names;
  for (const ColumnTable& table : column_tables()) {
    names.push_back(table.name);
    for (const Column& column : table.columns) names.push_back(table.name + "." + column.name);
  }
  return names;
}

std::string columns_json() {
  RecordValue root;
  for (const ColumnTable& table : column_tables()) {
    RecordValue& about = root[table.name];
    about["file"] = table.file;
    about["meaning"] = table.meaning;
    for (const Column& column : table.columns) {
      RecordValue one;
      one["name"] = column.name;
      one["unit"] = column.unit;
      one["meaning"] = column.meaning;
      if (column.dimension != any_dimension) one["dimension"] = column.dimension;
      if (column.needs != Needs::nothing) one["needs"] = column.needs == Needs::fluid ? "fluid" : "solid";
      about["columns"].append(one);
    }
  }
  return root.json() + "\n";
}

std::string reference_page() {
  std::string text =
      "# Reference of keys and columns\n\n"
      "This page is written by `softwet explain --markdown`; do not edit it by hand. `softwet explain KEY` and\n"
      "`softwet explain COLUMN` print the same text in the terminal. The symbols are those of "
      "[theory.md](theory.md).\n"
      "The last sections list the columns of `history.csv` and `interface.csv`, and the fields of `fields/*.hdf`.\n\n"
      "## Keys of a case\n\n"
      "Numbers are 0 or between 1e-30 and 1e30 in size. Ratios in quotes (`\"1/256\"`) are numbers too.\n"
      "[Numbers that vary](varying_numbers.md) shows how expressions and tables look.\n";
  for (const Table& table : tables()) text += key_section(table);
  for (const ColumnTable& table : column_tables()) text += column_section(table);
  return text;
}

}  // namespace softwet
