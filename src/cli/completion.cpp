// The completion script from the definition of the command line and from the schema.
#include "cli/app_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <map>

#include "casefile/schema/schema.hpp"
#include "casefile/write/column_text.hpp"

namespace softwet {
namespace {

/// "load[].box" as one types it: "load.box", which names the first load.
std::string typed_name(const std::string& name) {
  const auto bracket = name.find("[]");
  return bracket == std::string::npos ? name : name.substr(0, bracket) + name.substr(bracket + 2);
}

std::string key_words() {
  std::vector<std::string> words;
  for (const Key& key : schema()) words.push_back(typed_name(key.name));
  return fmt::format("{}", fmt::join(words, " "));
}

/// Branches "fluid.wall_law) _softwet_words 'gradient energy' ;;" of the keys that have choices.
std::string choice_branches() {
  std::string text;
  for (const Key& key : schema()) {
    if (key.kind != Kind::choice) continue;
    text += fmt::format("    {}) _softwet_words '{}'; return ;;\n", typed_name(key.name), fmt::join(key.choices, " "));
  }
  return text;
}

/// What completes a value, by the word that stands for it in the help: CASE, DIR, KEY=VALUE, ...
std::string completer(const std::string& placeholder) {
  static const std::map<std::string, std::string> known{{"CASE", "_softwet_cases"},   {"FILE", "_softwet_files"},
                                                        {"DIR", "_softwet_folders"},  {"OUT", "_softwet_folders"},
                                                        {"TOPIC", "_softwet_topics"}, {"COMMAND", "_softwet_commands"},
                                                        {"SHELL", "_softwet_shells"}};
  if (placeholder.compare(0, 4, "KEY=") == 0) return "_softwet_assignments";
  const auto found = known.find(placeholder);
  return found == known.end() ? "" : found->second;
}

/// Branches "--out) folders ;;" of all options that take a value, whatever the command.
std::string option_branches(const CLI::App& app) {
  std::map<std::string, std::string> branches;
  for (const CLI::App* command : app.get_subcommands({})) {
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_positional() || option->get_items_expected_max() == 0) continue;
      branches[option->get_name()] = completer(option->get_type_name());
    }
  }
  std::string text;
  for (const auto& [name, action] : branches)
    text += fmt::format("    {}) {}{}return ;;\n", name, action, action.empty() ? "" : "; ");
  return text;
}

/// Branches "run) options='--set --out ...' argument=_softwet_cases ;;" of the commands.
std::string command_branches(const CLI::App& app) {
  std::string text;
  for (const CLI::App* command : app.get_subcommands({})) {
    std::vector<std::string> options;
    std::string argument;
    for (const CLI::Option* option : command->get_options()) {
      if (option->get_positional()) {
        argument = completer(option->get_name(true));
      } else {
        for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
      }
    }
    text +=
        fmt::format("    {}) options='{}' argument={} ;;\n", command->get_name(), fmt::join(options, " "), argument);
  }
  return text;
}

constexpr const char* script = R"(# Completion of softwet for bash; written by `softwet completion bash`.
_softwet() {{
  local IFS=$' \t\n' options= argument= line= table= entry= current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}}
  local commands='{commands}'
  local keys='{keys}'
  COMPREPLY=()
  if [[ $current == = ]]; then  # bash takes "=" for a word
    current=
  elif [[ $before == = ]]; then
    before=${{COMP_WORDS[COMP_CWORD-2]}}
  fi
  # Each line of compgen is a word as it stands: in COMPREPLY=($(compgen ...)) it would be a pattern for names of files.
  _softwet_add() {{ while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen "$@" -- "$current"); }}
  _softwet_words() {{ _softwet_add -W "$1"; }}
  _softwet_paths() {{ _softwet_add "$@"; compopt -o filenames 2>/dev/null; }}
  _softwet_cases() {{ _softwet_paths -d; _softwet_add -f -X '!*.toml'; }}
  _softwet_folders() {{ _softwet_paths -d; }}
  _softwet_files() {{ _softwet_paths -f; }}
  _softwet_assignments() {{  # load[1].fo is completed as load.fo is
    if [[ $current =~ ^([a-z_.]+)(\[[0-9]+\])(.*)$ ]]; then
      table=${{BASH_REMATCH[1]}} entry=${{BASH_REMATCH[2]}} current=${{BASH_REMATCH[1]}}${{BASH_REMATCH[3]}}
    fi
    _softwet_add -W "$keys" -S =
    COMPREPLY=("${{COMPREPLY[@]/#"$table"/"$table$entry"}}")
    compopt -o nospace 2>/dev/null
  }}
  _softwet_topics() {{ _softwet_words "$keys {columns}"; }}
  _softwet_commands() {{ _softwet_words "$commands"; }}
  _softwet_shells() {{ _softwet_words bash; }}
  if [[ $COMP_CWORD == 1 ]]; then
    _softwet_words "$commands --help --version"
    return
  fi
  [[ $before =~ ^([a-z_.]+)\[[0-9]+\](.*)$ ]] && before=${{BASH_REMATCH[1]}}${{BASH_REMATCH[2]}}
  case $before in
{options}{choices}  esac
  case ${{COMP_WORDS[1]}} in
{branches}  esac
  if [[ $current == -* ]]; then
    _softwet_words "$options"
  else
    $argument
  fi
}}
complete -F _softwet softwet
)";

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
  return fmt::format(script, fmt::arg("commands", fmt::join(commands, " ")), fmt::arg("keys", key_words()),
                     fmt::arg("columns", fmt::join(column_names(), " ")), fmt::arg("options", option_branches(app)),
                     fmt::arg("choices", choice_branches()), fmt::arg("branches", command_branches(app)));
}

}  // namespace softwet
