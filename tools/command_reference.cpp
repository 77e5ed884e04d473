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

/// Item of a list: names, legal values, default and meaning.
std::string option_item(const CLI::Option& option) {
  std::vector<std::string> remarks;
  if (const std::string values = legal_values(option); !values.empty()) remarks.push_back(in_markdown(values));
  if (option.get_items_expected_max() > 1 || option.get_expected_max() > 1) remarks.emplace_back("list");
  if (option.get_required()) {
    remarks.emplace_back("required");
  } else if (const std::string usual = option.get_default_str(); !usual.empty()) {
    remarks.push_back(fmt::format("default `{}`", usual));
  }
  return fmt::format("- `{}`{}: {}\n", names_of(option),
                     remarks.empty() ? "" : fmt::format(" ({})", fmt::join(remarks, "; ")),
                     in_markdown(option.get_description()));
}

/// Arguments of a command, followed by its options without --help and hidden ones.
std::vector<const CLI::Option*> listed_options(const CLI::App& command) {
  std::vector<const CLI::Option*> listed;
  for (const CLI::Option* option : command.get_options()) {
    const bool is_hidden = !option->get_positional() && option->get_group().empty();
    const bool is_help = option == command.get_help_ptr() || option == command.get_help_all_ptr();
    if (!is_help && !is_hidden) listed.push_back(option);
  }
  std::ranges::stable_partition(listed, &CLI::Option::get_positional);
  return listed;
}

using ItemCounts = std::map<std::string, std::map<std::string, int>>;

void count_items(const CLI::App& command, ItemCounts& counts) {
  for (const CLI::Option* option : listed_options(command)) ++counts[names_of(*option)][option_item(*option)];
  for (const CLI::App* inner : commands_of(command)) count_items(*inner, counts);
}

/// Items of the options that several commands share, by the options' names. Of several items of one name, the one of at
/// least half of the commands that have it.
using SharedItems = std::map<std::string, std::string>;

SharedItems shared_items(const CLI::App& program) {
  ItemCounts counts;
  for (const CLI::App* command : commands_of(program)) count_items(*command, counts);
  SharedItems shared;
  for (const auto& [names, items] : counts) {
    int commands = 0;
    for (const auto& [item, count] : items) commands += count;
    const auto most = std::ranges::max_element(items, {}, [](const auto& item) { return item.second; });
    if (most->second > 1 && 2 * most->second >= commands) shared[names] = most->first;
  }
  return shared;
}

/// List of a command's own arguments and options, and the names of the shared ones.
std::string option_list(const CLI::App& command, const SharedItems& shared) {
  std::string items;
  std::vector<std::string> shared_names;
  for (const CLI::Option* option : listed_options(command)) {
    const std::string item = option_item(*option);
    const auto known = shared.find(names_of(*option));
    if (known != shared.end() && known->second == item) {
      shared_names.push_back(known->first);
    } else {
      items += item;
    }
  }
  if (!items.empty()) items.insert(0, "\n");
  if (!shared_names.empty()) items += fmt::format("\nShared: `{}`.\n", fmt::join(shared_names, "`, `"));
  return items;
}

std::string section(const CLI::App& command, const std::string& path, const SharedItems& shared) {
  std::string text = fmt::format("\n## {}\n\n{}.\n", path, in_markdown(command.get_description()));
  if (text.ends_with("..\n")) text.erase(text.size() - 2, 1);
  text += option_list(command, shared);
  constexpr std::size_t line_width = 100;
  if (const std::string notes = wrapped(command.get_footer(), line_width); !notes.empty())
    text += fmt::format("\n```text\n{}\n```\n", notes);
  for (const CLI::App* inner : commands_of(command)) {
    text += section(*inner, path + " " + inner->get_name(), shared);
  }
  return text;
}

}  // namespace

std::string command_reference(const CLI::App& program) {
  std::string page =
      "# Commands\n\n"
      "<!-- Written by the target update_reference from the program's tables of options. -->\n\n"
      "`-h` prints the options of a command that are needed most, and `--help` all; `shapegauge help COMMAND` is the\n"
      "same. [Shared options](#shared-options) are listed once. See also [exit statuses](definitions.md#exit-status)\n"
      "and [formats of files](file_formats.md).\n\n"
      "| command | purpose |\n|---|---|\n";
  for (const CLI::App* command : commands_of(program)) {
    page +=
        fmt::format("| [{0}](#shapegauge-{0}) | {1} |\n", command->get_name(), in_markdown(command->get_description()));
  }
  const SharedItems shared = shared_items(program);
  page += fmt::format("\n## Options of every command\n{}\n## Shared options\n\n", option_list(program, {}));
  for (const auto& [names, item] : shared) page += item;
  for (const CLI::App* command : commands_of(program)) {
    page += section(*command, "shapegauge " + command->get_name(), shared);
  }
  return page;
}

}  // namespace shapegauge
