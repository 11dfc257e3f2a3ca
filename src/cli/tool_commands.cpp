// Commands that programs of the folder tools carry out, with the options that tools/softwet/commands.toml declares.
#include "cli/app_parts.hpp"

#include <CLI/CLI.hpp>
#include <softwet_commands.hpp>

#include "casefile/text/toml_reader.hpp"
#include "cli/tool.hpp"

namespace softwet {
namespace {

std::string text_of(const toml::table& declared, const char* key) { return declared[key].value_or(std::string()); }
bool is(const char* key, const toml::table& declared) { return declared[key].value_or(false); }

/// An argument of a command: its words are collected for the program.
void add_argument(CLI::App& command, const toml::table& declared, std::vector<std::string>& words) {
  const auto keep = [&words](const std::vector<std::string>& values) {
    words.insert(words.end(), values.begin(), values.end());
  };
  CLI::Option* argument =
      command.add_option_function<std::vector<std::string>>(text_of(declared, "name"), keep, text_of(declared, "help"));
  argument->type_name("")->required(is("required", declared));
  if (!is("several", declared)) argument->expected(1);
}

/// An option or a flag of a command, collected in the same way.
void add_option(CLI::App& command, const toml::table& declared, std::vector<std::string>& words) {
  const std::string name = text_of(declared, "name"), help = text_of(declared, "help");
  if (!declared.contains("value")) {
    command.add_flag_callback(
        name, [&words, name] { words.push_back(name); }, help);
    return;
  }
  const auto keep = [&words, name](const std::string& value) { words.push_back(name + "=" + value); };
  const bool repeatable = is("repeatable", declared);
  CLI::Option* option = command.add_option_function<std::string>(name, keep, help + (repeatable ? "; repeatable" : ""));
  option->type_name(text_of(declared, "value"));
  if (repeatable) option->trigger_on_parse();
}

void add_command(CLI::App& app, const toml::table& declared, std::vector<std::string>& words) {
  const std::string name = text_of(declared, "name");
  CLI::App& command = *app.add_subcommand(name, text_of(declared, "help"));
  for (const toml::node& node : *declared["option"].as_array()) {
    const toml::table& option = *node.as_table();
    const auto add = text_of(option, "name").front() == '-' ? add_option : add_argument;
    add(command, option, words);
  }
  command.callback([name, &words] { start_tool(name, words); });
}

}  // namespace

void add_tool_commands(CLI::App& app, std::vector<std::string>& words) {
  const toml::table declared = toml::parse(std::string_view(commands_of_tools));
  for (const toml::node& node : *declared["command"].as_array()) add_command(app, *node.as_table(), words);
}

}  // namespace softwet
