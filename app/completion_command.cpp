// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"
#include "app/parameter_options.h"
#include "app/terminal.h"

namespace shapegauge {

namespace {

/// Returns the names of an option as typed ("--format", "-o"); none for a positional and for a hidden option.
std::vector<std::string> names_of(const CLI::Option& option) {
  if (is_hidden(option)) return {};
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

/// Returns the choices of an option, listed in its help as {a,b,c}; none for other options.
std::vector<std::string> choices_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{');
  const std::size_t end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos) return {};
  return CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(app)) names.push_back(command->get_name());
  return names;
}

/// Command with the words that lead to it, "dataset info".
struct NamedCommand {
  std::string path;
  const CLI::App* app = nullptr;
};

/// Returns a command and those below it.
std::vector<NamedCommand> all_commands(const CLI::App& app, const std::string& path = "") {
  std::vector<NamedCommand> all{{.path = path, .app = &app}};
  for (const CLI::App* command : commands_of(app)) {
    const std::string below = path.empty() ? command->get_name() : path + " " + command->get_name();
    std::ranges::move(all_commands(*command, below), std::back_inserter(all));
  }
  return all;
}

/// Returns the commands with slashes: "dataset", "dataset/info".
std::vector<std::string> paths_of_commands(const CLI::App& program) {
  std::vector<std::string> paths;
  for (const CLI::App* command : commands_of(program)) {
    paths.push_back(command->get_name());
    for (const std::string& inner : paths_of_commands(*command)) paths.push_back(command->get_name() + "/" + inner);
  }
  return paths;
}

std::string bash_completion(const CLI::App& program) {
  std::string words;
  std::string choices;
  for (const auto& [path, app] : all_commands(program)) {
    std::vector<std::string> next = names_of_commands(*app);
    for (const CLI::Option* option : app->get_options()) {
      const std::vector<std::string> names = names_of(*option);
      next.insert(next.end(), names.begin(), names.end());
      const std::vector<std::string> values = choices_of(*option);
      if (values.empty()) continue;
      for (const std::string& name : names) {
        choices += fmt::format("    '{}:{}') COMPREPLY=($(compgen -W '{}' -- \"$word\")); return ;;\n", path, name,
                               fmt::join(values, " "));
      }
    }
    words += fmt::format("    '{}') words='{}' ;;\n", path, fmt::join(next, " "));
  }
  return fmt::format(R"(# bash completion of shapegauge; made by 'shapegauge completion bash'
_shapegauge() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} previous=${{COMP_WORDS[COMP_CWORD-1]}} command='' words='' i next
  for ((i = 1; i < COMP_CWORD; i++)); do
    next=${{COMP_WORDS[i]}}
    case " {} " in *" ${{command:+$command/}}$next "*) command=${{command:+$command/}}$next ;; esac
  done
  command=${{command//\// }}
  case "$command:$previous" in
{}  esac
  case "$command" in
{}  esac
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  if [[ -n $command && $word != -* ]]; then COMPREPLY+=($(compgen -f -- "$word")); fi
}}
complete -o filenames -F _shapegauge shapegauge
)",
                     fmt::join(paths_of_commands(program), " "), choices, words);
}

/// Text for a description in a specification of zsh's _arguments.
std::string zsh_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c == '\'' ? std::string("'\\''") : std::string(1, c == '\n' ? ' ' : c);
  }
  return escaped;
}

/// Completes one of the words, or the name of a file if there are none.
std::string zsh_action(const std::vector<std::string>& words) {
  return words.empty() ? "_files" : fmt::format("({})", fmt::join(words, " "));
}

/// Formats the options of a command for zsh's _arguments.
std::string zsh_options(const CLI::App& app) {
  std::string options;
  for (const CLI::Option* option : app.get_options()) {
    const std::string value = option->get_items_expected_max() > 0 ? ":value:" + zsh_action(choices_of(*option)) : "";
    for (const std::string& name : names_of(*option)) {
      options += fmt::format(" \\\n        '*{}[{}]{}'", name, zsh_text(option->get_description()), value);
    }
  }
  return options;
}

std::string zsh_completion(const CLI::App& program) {
  std::string steps;
  std::string cases;
  for (const auto& [path, app] : all_commands(program)) {
    const std::vector<std::string> commands = names_of_commands(*app);
    for (const std::string& name : commands) {
      steps += fmt::format("      '{}/{}') command='{}{}{}' ;;\n", path, name, path, path.empty() ? "" : " ", name);
    }
    cases += fmt::format("    '{}') _arguments{} \\\n        '*:argument:{}' ;;\n", path, zsh_options(*app),
                         zsh_action(commands));
  }
  return fmt::format(R"(#compdef shapegauge
# zsh completion of shapegauge; made by 'shapegauge completion zsh'
_shapegauge() {{
  local command='' word
  for word in ${{words[2,CURRENT-1]}}; do
    case "$command/$word" in
{}    esac
  done
  case "$command" in
{}  esac
}}
_shapegauge "$@"
)",
                     steps, cases);
}

/// Quotes a text for fish.
std::string fish_text(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

std::string fish_completion(const CLI::App& program) {
  std::string lines;
  for (const auto& [path, app] : all_commands(program)) {
    const std::string begin = fmt::format("complete -c shapegauge -n '__shapegauge_at {}'", path);
    for (const CLI::App* command : commands_of(*app)) {
      lines += fmt::format("{} -f -a {} -d {}\n", begin, command->get_name(), fish_text(command->get_description()));
    }
    for (const CLI::Option* option : app->get_options()) {
      std::string names;
      for (const std::string& name : option->get_snames()) names += " -s " + name;
      for (const std::string& name : option->get_lnames()) names += " -l " + name;
      if (names_of(*option).empty()) continue;
      const std::vector<std::string> values = choices_of(*option);
      const std::string value = !values.empty() ? fmt::format(" -x -a '{}'", fmt::join(values, " "))
                                : option->get_items_expected_max() > 0 ? " -r"
                                                                       : "";
      lines += fmt::format("{}{}{} -d {}\n", begin, names, value, fish_text(option->get_description()));
    }
  }
  return fmt::format(R"(# fish completion of shapegauge; made by 'shapegauge completion fish'
function __shapegauge_at
    set -l command
    for word in (commandline -opc)[2..]
        contains -- (string join / $command $word) {}; and set -a command $word
    end
    test "$command" = "$argv"
end
{})",
                     fmt::join(paths_of_commands(program), " "), lines);
}

}  // namespace

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

void add_completion_command(CLI::App& app, int& status) {
  CLI::App* command = app.add_subcommand("completion", "Print a completion script for a shell");
  command->footer(
      "Example: shapegauge completion bash > ~/.local/share/bash-completion/completions/shapegauge\n"
      "         shapegauge completion zsh > ~/.zfunc/_shapegauge\n"
      "         shapegauge completion fish > ~/.config/fish/completions/shapegauge.fish");
  const auto shell = std::make_shared<std::string>();
  command->add_option("shell", *shell, "Shell that loads the script")
      ->required()
      ->check(one_of({"bash", "zsh", "fish"}));
  command->callback([&app, shell, &status] {
    const auto script = *shell == "bash" ? bash_completion : *shell == "zsh" ? zsh_completion : fish_completion;
    print_output("{}", script(app));
    status = exit_success;
  });
}

}  // namespace shapegauge
