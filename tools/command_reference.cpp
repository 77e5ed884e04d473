// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/command_reference.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <string_view>
#include <vector>

#include "app/commands.h"
#include "app/help_format.h"

namespace shapegauge {

namespace {

/// Text in Markdown, also for cells of tables.
std::string in_markdown(std::string_view text) {
  std::string escaped;
  for (const char character : text) {
    if (character == '|' || character == '<' || character == '*') escaped += '\\';
    escaped += character == '\n' ? ' ' : character;
  }
  return escaped;
}

/// Legal values of an option, from the name of its type: a list of words or a range; otherwise empty.
std::string legal_values(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{');
  const std::size_t end = type.rfind('}');
  if (begin != std::string::npos && end != std::string::npos) {
    const std::vector<std::string> words = CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
    return fmt::format("`{}`", fmt::join(words, "`, `"));
  }
  const std::size_t range = type.find(" in [");
  if (range == std::string::npos) return "";
  const std::string bounds = type.substr(range + 5, type.rfind(']') - range - 5);
  const std::size_t dash = bounds.find(" - ");
  return fmt::format("{} to {}", bounds.substr(0, dash), bounds.substr(dash + 3));
}

std::string names_of(const CLI::Option& option) {
  return option.get_positional() ? option.get_name(true) : option.get_name(false, true);
}

/// "required" or the default of an option, otherwise nothing.
std::string default_remark(const CLI::Option& option) {
  if (option.get_required()) return "required";
  const std::string default_value = option.get_default_str();
  return default_value.empty() ? "" : fmt::format("default `{}`", default_value);
}

/// Item of a list: names, legal values, default and meaning.
std::string option_item(const CLI::Option& option, const std::string& default_value) {
  std::vector<std::string> remarks;
  if (const std::string values = legal_values(option); !values.empty()) remarks.push_back(in_markdown(values));
  if (option.get_items_expected_max() > 1 || option.get_expected_max() > 1) remarks.emplace_back("list");
  if (!default_value.empty()) remarks.push_back(default_value);
  return fmt::format("- `{}`{}: {}\n", names_of(option),
                     remarks.empty() ? "" : fmt::format(" ({})", fmt::join(remarks, "; ")),
                     in_markdown(option.get_description()));
}

/// Arguments of a command, followed by its options without --help and hidden ones.
std::vector<const CLI::Option*> listed_options(const CLI::App& command) {
  std::vector<const CLI::Option*> listed;
  for (const CLI::Option* option : command.get_options()) {
    const bool is_help = option == command.get_help_ptr() || option == command.get_help_all_ptr();
    if (!is_help && !is_hidden(*option)) listed.push_back(option);
  }
  // Clang 14 does not compile the version of std::ranges, which returns a subrange.
  std::stable_partition(listed.begin(), listed.end(), [](const auto* option) { return option->get_positional(); });
  return listed;
}

using Options = std::vector<const CLI::Option*>;

/// Options of all commands by their names and their items without defaults.
using OptionGroups = std::map<std::string, std::map<std::string, Options>>;

void group_options(const CLI::App& command, OptionGroups& groups) {
  for (const CLI::Option* option : listed_options(command)) {
    groups[names_of(*option)][option_item(*option, "")].push_back(option);
  }
  for (const CLI::App* inner : commands_of(command)) group_options(*inner, groups);
}

/// An option of each name that several commands share: of the item that at least half of the commands with this name
/// have, and with the most frequent default.
using SharedOptions = std::map<std::string, const CLI::Option*>;

SharedOptions shared_options(const CLI::App& program) {
  OptionGroups groups;
  for (const CLI::App* command : commands_of(program)) group_options(*command, groups);
  SharedOptions shared;
  for (const auto& [names, items] : groups) {
    std::size_t commands = 0;
    for (const auto& [item, options] : items) commands += options.size();
    const Options& most =
        std::ranges::max_element(items, {}, [](const auto& item) { return item.second.size(); })->second;
    if (most.size() < 2 || 2 * most.size() < commands) continue;
    const auto frequency = [&](const CLI::Option* option) {
      return std::ranges::count(most, default_remark(*option),
                                [](const CLI::Option* other) { return default_remark(*other); });
    };
    shared[names] = *std::ranges::max_element(most, {}, frequency);
  }
  return shared;
}

/// Name of a shared option, with its default if that differs here.
std::string reference_to(const CLI::Option& option, const CLI::Option& shared) {
  const std::string default_value = default_remark(option);
  const std::string name = fmt::format("`{}`", names_of(option));
  return default_value == default_remark(shared)
             ? name
             : fmt::format("{} ({})", name, default_value.empty() ? "optional" : default_value);
}

/// List of a command's own arguments and options, and the names of the shared ones.
std::string option_list(const CLI::App& command, const SharedOptions& shared) {
  std::string items;
  std::vector<std::string> shared_names;
  for (const CLI::Option* option : listed_options(command)) {
    const auto known = shared.find(names_of(*option));
    if (known != shared.end() && option_item(*known->second, "") == option_item(*option, "")) {
      shared_names.push_back(reference_to(*option, *known->second));
    } else {
      items += option_item(*option, default_remark(*option));
    }
  }
  if (!items.empty()) items.insert(0, "\n");
  if (!shared_names.empty()) items += fmt::format("\nShared: {}.\n", fmt::join(shared_names, ", "));
  return items;
}

std::string section(const CLI::App& command, const std::string& path, const SharedOptions& shared) {
  std::string text = fmt::format("\n## {}\n\n{}.\n", path, in_markdown(command.get_description()));
  if (text.ends_with("..\n")) text.erase(text.size() - 2, 1);
  text += option_list(command, shared);
  constexpr std::size_t line_width = 100;
  const std::string notes = wrapped(command.get_footer(), line_width);
  if (!notes.empty() && commands_of(command).empty()) text += fmt::format("\n```text\n{}\n```\n", notes);
  for (const CLI::App* inner : commands_of(command)) {
    text += section(*inner, path + " " + inner->get_name(), shared);
  }
  return text;
}

}  // namespace

std::string command_reference(const CLI::App& program) {
  std::string page =
      "# Commands\n\n"
      "<!-- Written by the target update_reference. -->\n\n"
      "`-h` prints the most important options of a command, `--help` all. See\n"
      "[exit statuses](definitions.md#exit-status) and [file formats](file_formats.md).\n";
  std::string group;
  for (const CLI::App* command : commands_of(program)) {
    const std::string separator = command->get_group() == group ? ", " : fmt::format("\n- {}: ", command->get_group());
    page += fmt::format("{0}[{1}](#shapegauge-{1})", separator, command->get_name());
    group = command->get_group();
  }
  const SharedOptions shared = shared_options(program);
  page += fmt::format("\n\n## Options of every command\n{}\n## Shared options\n\n", option_list(program, {}));
  for (const auto& [names, option] : shared) page += option_item(*option, default_remark(*option));
  for (const CLI::App* command : commands_of(program)) {
    page += section(*command, "shapegauge " + command->get_name(), shared);
  }
  return page;
}

}  // namespace shapegauge
