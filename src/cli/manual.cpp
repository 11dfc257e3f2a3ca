// The manual page from the definition of the command line and from the schema.
#include "cli/app_parts.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <softwet_version.hpp>
#include <sstream>

#include "casefile/case_file.hpp"
#include "casefile/schema/schema.hpp"

namespace softwet {
namespace {

/// Text that roff prints as it is.
std::string roff_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    const bool first = escaped.empty() || escaped.back() == '\n';
    if (first && (c == '.' || c == '\'')) escaped += "\\&";
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string section(const std::string& title) { return fmt::format(".SH \"{}\"\n", title); }
std::string subsection(const std::string& title) { return fmt::format(".SS \"{}\"\n", roff_text(title)); }
std::string entry(const std::string& head, const std::string& text) {
  return fmt::format(".TP\n{}\n{}\n", head, roff_text(text));
}

/// "CASE", "[KEY]": as a positional argument appears in a line of usage.
std::string placeholder(const CLI::Option& option) {
  const std::string name = option.get_name(true);
  return option.get_required() ? name : "[" + name + "]";
}

std::string option_head(const CLI::Option& option) {
  if (option.get_positional()) return "\\fI" + roff_text(option.get_name(true)) + "\\fR";
  const std::string head = "\\fB" + roff_text(option.get_name()) + "\\fR";
  const std::string type = option.get_type_name();
  const std::string value = type.substr(0, type.find(':'));  // "N" of "N:INT in [1 - 65536]"
  return option.get_items_expected_max() == 0 ? head : head + " \\fI" + roff_text(value) + "\\fR";
}

std::string command_text(const CLI::App& command) {
  const auto options = command.get_options();
  std::string usage = command.get_name();
  for (const CLI::Option* option : options)
    if (option->get_positional()) usage += " " + placeholder(*option);
  std::string text = subsection(usage) + roff_text(command.get_description()) + "\n";
  for (const CLI::Option* option : options)
    if (option != command.get_help_ptr()) text += entry(option_head(*option), option->get_description());
  return text;
}

/// What `explain` says of a key, in one paragraph.
std::string key_text(const Key& key) {
  std::istringstream lines(explain(key.name));
  std::string line, text;
  while (line != key.name && std::getline(lines, line)) {
  }
  while (std::getline(lines, line)) {
    line.erase(0, line.find_first_not_of(' '));
    text += (text.empty() || text.back() == '.' ? "" : ".") + std::string(text.empty() ? "" : " ") + line;
  }
  return text;
}

std::string keys_text() {
  std::string text;
  for (const Table& table : tables()) {
    if (!table.name.empty()) text += subsection(table.name) + roff_text(table.help) + "\n";
    for (const Key& key : schema())
      if (key.table() == table.name) text += entry("\\fB" + roff_text(key.name) + "\\fR", key_text(key));
  }
  return text;
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string text = fmt::format(".TH SOFTWET 1 \"\" \"softwet {}\" \"User Commands\"\n", roff_text(version));
  text += section("NAME") + "softwet \\- droplets on soft solids\n";
  text += section("SYNOPSIS") + "\\fBsoftwet\\fR \\fICOMMAND\\fR [\\fIARGUMENTS\\fR]\n";
  text +=
      section("DESCRIPTION") + roff_text(app.get_description()) +
      "\nA case file in TOML describes a scene. The command run computes it and writes an output folder with tables, "
      "field files for ParaView, a record of the run and a checkpoint. "
      "'softwet explain history' and 'softwet explain interface' list the columns of the tables.\n";
  text += section("COMMANDS");
  for (const CLI::App* command : app.get_subcommands({})) text += command_text(*command);
  text += section("CASE FILES") +
          "A case is a TOML file with these tables and keys. "
          "A name with [] belongs to a table that may stand several times, such as [[droplet]].\n" +
          keys_text();
  text += section("GETTING STARTED AND EXIT STATUS") + ".nf\n" + roff_text(app.get_footer()) + "\n.fi\n";
  text += section("ENVIRONMENT");
  text += entry("\\fBSOFTWET_PYTHON\\fR", "The python3 of the commands that are Python programs.");
  text += entry("\\fBSOFTWET_TOOLS\\fR", "The folder of these programs, where it is not the installed one.");
  text += entry("\\fBOMP_WAIT_POLICY\\fR, \\fBGOMP_SPINCOUNT\\fR",
                "How threads wait for each other, for the OpenMP runtime. Without either of them they poll 3000 times "
                "before they sleep, which suits a machine with or without other work.");
  text += entry("\\fBSOFTWET_PROGRAM\\fR",
                "The program that the Python package softwet starts, where it is not the one beside it.");
  return text;
}

}  // namespace softwet
