#include "tools/command_reference.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <string_view>
#include <vector>

#include "app/commands.h"

namespace shapegauge {

namespace {

/// Text for a cell of a Markdown table.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char character : text) {
    if (character == '|' || character == '<' || character == '*') escaped += '\\';
    escaped += character == '\n' ? ' ' : character;
  }
  return escaped;
}

/// Legal values of an option, from the name of its type: a list of words, a range, or the kind of value.
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
  std::string kind = type.substr(0, type.find(':'));
  std::ranges::transform(kind, kind.begin(), [](unsigned char character) { return std::tolower(character); });
  if (kind == "int" || kind == "uint") kind = "integer";
  if (kind == "float") kind = "number";
  if (range == std::string::npos) return kind;
  const std::string bounds = type.substr(range + 5, type.rfind(']') - range - 5);
  const std::size_t dash = bounds.find(" - ");
  return fmt::format("{} from {} to {}", kind, bounds.substr(0, dash), bounds.substr(dash + 3));
}

std::string names_of(const CLI::Option& option) {
  return option.get_positional() ? option.get_name(true) : option.get_name(false, true);
}

std::string option_row(const CLI::Option& option) {
  const bool is_list = option.get_items_expected_max() > 1 || option.get_expected_max() > 1;
  std::string value = cell(legal_values(option));
  if (is_list) value += " ...";
  const std::string default_value = option.get_default_str();
  return fmt::format("| `{}` | {} | {} | {} |\n", names_of(option), cell(option.get_description()), value,
                     option.get_required()   ? "required"
                     : default_value.empty() ? ""
                                             : fmt::format("`{}`", default_value));
}

/// Arguments of a command, followed by its options without --help and hidden ones.
std::vector<const CLI::Option*> listed_options(const CLI::App& command) {
  std::vector<const CLI::Option*> listed;
  for (const CLI::Option* option : command.get_options()) {
    const bool is_hidden = !option->get_positional() && option->get_group().empty();
    if (option != command.get_help_ptr() && !is_hidden) listed.push_back(option);
  }
  std::ranges::stable_partition(listed, &CLI::Option::get_positional);
  return listed;
}

using RowCounts = std::map<std::string, std::map<std::string, int>>;

void count_rows(const CLI::App& command, RowCounts& counts) {
  for (const CLI::Option* option : listed_options(command)) ++counts[names_of(*option)][option_row(*option)];
  for (const CLI::App* inner : commands_of(command)) count_rows(*inner, counts);
}

/// Rows of the options that several commands share, by the options' names. Of several rows of one name, the one of at
/// least half of the commands that have it.
using SharedRows = std::map<std::string, std::string>;

SharedRows shared_rows(const CLI::App& program) {
  RowCounts counts;
  for (const CLI::App* command : commands_of(program)) count_rows(*command, counts);
  SharedRows shared;
  for (const auto& [names, rows] : counts) {
    int commands = 0;
    for (const auto& [row, count] : rows) commands += count;
    const auto most = std::ranges::max_element(rows, {}, [](const auto& row) { return row.second; });
    if (most->second > 1 && 2 * most->second >= commands) shared[names] = most->first;
  }
  return shared;
}

constexpr std::string_view table_head = "\n| name | meaning | values | default |\n|---|---|---|---|\n";

/// Table of a command's own arguments and options, and the names of the shared ones.
std::string option_table(const CLI::App& command, const SharedRows& shared) {
  std::string rows;
  std::vector<std::string> shared_names;
  for (const CLI::Option* option : listed_options(command)) {
    const std::string row = option_row(*option);
    const auto known = shared.find(names_of(*option));
    if (known != shared.end() && known->second == row) {
      shared_names.push_back(known->first);
    } else {
      rows += row;
    }
  }
  std::string table;
  if (!rows.empty()) table += fmt::format("{}{}", table_head, rows);
  if (!shared_names.empty()) table += fmt::format("\nShared: `{}`.\n", fmt::join(shared_names, "`, `"));
  return table;
}

std::string section(const CLI::App& command, const std::string& path, const SharedRows& shared) {
  std::string text = fmt::format("\n## {}\n\n{}.\n", path, cell(command.get_description()));
  if (text.ends_with("..\n")) text.erase(text.size() - 2, 1);
  text += option_table(command, shared);
  if (const std::string notes = command.get_footer(); !notes.empty())
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
      "Every command explains itself with `--help`; `shapegauge help COMMAND` is the same. Options that several "
      "commands\n"
      "have are listed [once](#shared-options). See also [exit statuses](definitions.md#exit-status) and [formats of\n"
      "files](file_formats.md).\n\n"
      "| command | purpose |\n|---|---|\n";
  for (const CLI::App* command : commands_of(program)) {
    page += fmt::format("| [{0}](#shapegauge-{0}) | {1} |\n", command->get_name(), cell(command->get_description()));
  }
  const SharedRows shared = shared_rows(program);
  page +=
      fmt::format("\n## Options of every command\n{}\n## Shared options\n{}", option_table(program, {}), table_head);
  for (const auto& [names, row] : shared) page += row;
  for (const CLI::App* command : commands_of(program)) {
    page += section(*command, "shapegauge " + command->get_name(), shared);
  }
  return page;
}

}  // namespace shapegauge
