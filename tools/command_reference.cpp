#include "tools/command_reference.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
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

std::string option_row(const CLI::Option& option) {
  const bool is_positional = option.get_positional();
  const std::string names = is_positional ? option.get_name(true) : option.get_name(false, true);
  const bool is_list = option.get_items_expected_max() > 1 || option.get_expected_max() > 1;
  std::string value = cell(legal_values(option));
  if (is_list) value += " ...";
  const std::string default_value = option.get_default_str();
  return fmt::format("| `{}` | {} | {} | {} |\n", names, cell(option.get_description()), value,
                     option.get_required()   ? "required"
                     : default_value.empty() ? ""
                                             : fmt::format("`{}`", default_value));
}

/// Tables of the arguments and options of a command, one for each of its groups.
std::string option_tables(const CLI::App& command) {
  std::string tables;
  const std::string head = "| name | meaning | values | default |\n|---|---|---|---|\n";
  std::string arguments;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) arguments += option_row(*option);
  }
  if (!arguments.empty()) tables += "\nArguments:\n\n" + head + arguments;
  for (const std::string& group : command.get_groups()) {
    std::string rows;
    for (const CLI::Option* option : command.get_options()) {
      const bool is_help = option == command.get_help_ptr();
      if (!option->get_positional() && !is_help && option->get_group() == group) rows += option_row(*option);
    }
    if (!group.empty() && !rows.empty()) tables += fmt::format("\n{}:\n\n{}{}", group, head, rows);
  }
  return tables;
}

std::string section(const CLI::App& command, const std::string& path) {
  std::string text = fmt::format("\n## {}\n\n{}.\n", path, cell(command.get_description()));
  if (text.ends_with("..\n")) text.erase(text.size() - 2, 1);
  text += option_tables(command);
  if (const std::string notes = command.get_footer(); !notes.empty())
    text += fmt::format("\n```text\n{}\n```\n", notes);
  for (const CLI::App* inner : commands_of(command)) text += section(*inner, path + " " + inner->get_name());
  return text;
}

}  // namespace

std::string command_reference(const CLI::App& program) {
  std::string page =
      "# Commands\n\n"
      "<!-- Written by the target update_reference from the program's tables of options. -->\n\n"
      "Every command explains itself with `--help`; `shapegauge help COMMAND` is the same. [Exit\n"
      "statuses](definitions.md#exit-status) and [formats of files](file_formats.md) are described elsewhere.\n\n"
      "| command | purpose |\n|---|---|\n";
  for (const CLI::App* command : commands_of(program)) {
    page += fmt::format("| [{0}](#shapegauge-{0}) | {1} |\n", command->get_name(), cell(command->get_description()));
  }
  page += "\n## Options of every command\n" + option_tables(program);
  for (const CLI::App* command : commands_of(program)) page += section(*command, "shapegauge " + command->get_name());
  return page;
}

}  // namespace shapegauge
