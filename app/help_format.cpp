// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help_format.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "app/terminal.h"
#include "shapegauge/core/base/text.h"

namespace shapegauge {

namespace {

constexpr std::size_t description_column = 26;

/// Options that -h shows, by command. It shows all options of other commands.
const std::map<std::string, std::vector<std::string>>& options_needed_most() {
  static const std::map<std::string, std::vector<std::string>> options{
      {"run", {"--output", "--set", "--replace", "--threads", "--part", "--dry-run"}},
      {"sdf", {"--output", "--method", "--offset", "--unit", "--summary", "--below", "--plot", "--replace"}},
      {"check", {"--min-wall", "--min-gap", "--unit", "--output", "--format"}},
      {"normals", {"--output", "--offset", "--replace"}},
      {"perturb", {"--output", "--noise", "--remove-faces", "--flip", "--decimate", "--seed", "--replace"}},
      {"segment", {"--output", "--parts", "--method", "--replace"}},
      {"view", {"--output", "--field", "--offset", "--unit", "--below", "--replace"}},
      {"search", {"--output", "--count", "--articulated", "--index"}},
      {"describe", {"--output", "--descriptor", "--set", "--list", "--replace"}},
      {"rerank", {"--output", "--method", "--replace"}},
      {"evaluate",
       {"--labels", "--order", "--qrels", "--distance", "--protocol", "--measures", "--confidence", "--format",
        "--report"}},
      {"compare", {"--labels", "--measures", "--reference", "--test", "--format", "--plot", "--report"}},
      {"audit", {"--labels", "--format"}},
      {"leaderboard", {"--labels", "--output", "--measures", "--rank-by"}},
      {"generate", {"--classes", "--models-per-class", "--faces", "--seed", "--replace"}}};
  return options;
}

/// Indentation of the lines that continue a line.
std::size_t continuation_indent(std::string_view line) {
  constexpr std::string_view example = "Example: ";
  if (line.starts_with(example)) return example.size() + 2;
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  return indent == 0 ? 0 : indent + 2;
}

std::string wrapped_line(std::string_view line, std::size_t width) {
  const std::string indent = "\n" + std::string(continuation_indent(line), ' ');
  std::string text;
  std::size_t column = 0;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' ', line.find_first_not_of(' ')), line.size());
    std::string_view word = line.substr(0, end);  // with the blanks before it
    if (column > 0 && column + end > width) {
      text += indent;
      column = indent.size() - 1;
      word = trim(word);
    }
    text += word;
    column += word.size();
    line.remove_prefix(end);
  }
  return text;
}

/// Entry of a list: a name, and a description in its own column.
std::string entry(const std::string& name, const std::string& description) {
  const std::string indent(description_column, ' ');
  const std::string text =
      CLI::detail::find_and_replace(wrapped(description, terminal_width() - description_column), "\n", "\n" + indent);
  const bool fits = name.size() + 3 < description_column;
  return fits ? fmt::format("  {:<{}}{}\n", name, description_column - 2, text)
              : fmt::format("  {}\n{}{}\n", name, indent, text);
}

/// Returns the names of the options that are not hidden.
std::vector<std::string> sorted_names(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) {
    if (!is_hidden(*option)) names.push_back(option->get_name());
  }
  std::ranges::sort(names);
  return names;
}

/// Returns the type of an option's values. CLI11 joins the type and the description of checks: "INT:INT in [1 - 1024]",
/// "TEXT:{faces,vertices}".
std::string type_of(const CLI::Option& option) {
  const std::string joined = option.get_type_name();
  const std::size_t colon = joined.find(':');
  const std::string type = colon == std::string::npos ? joined : joined.substr(colon + 1);
  return type == "NONNEGATIVE" ? joined.substr(0, colon) + " >= 0" : type;
}

/// Returns true for a list of words that is too long to be a type.
bool is_long_list(const std::string& type) {
  constexpr std::size_t max_size = 24;
  return type.starts_with('{') && type.size() > max_size;
}

}  // namespace

std::string wrapped(std::string_view text, std::size_t width) {
  std::string lines;
  for (const std::string_view line : split_lines(text)) {
    lines += (lines.empty() ? "" : "\n") + wrapped_line(line, width);
  }
  return lines;
}

std::string HelpFormat::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  const auto needed = options_needed_most().find(app->get_name());
  const bool is_short = mode == CLI::AppFormatMode::Normal && needed != options_needed_most().end();
  std::string text = wrapped(make_description(app), terminal_width()) + "\n\n" + make_usage(app, name);
  text += make_positionals(app);
  if (is_short) {
    std::vector<const CLI::Option*> options;
    for (const std::string& option : needed->second) options.push_back(app->get_option(option));
    text += make_group("Options", false, options);
  } else {
    text += make_groups(app, mode);
  }
  text += make_subcommands(app, CLI::AppFormatMode::Normal) + "\n" + make_footer(app);
  if (is_short) text += fmt::format("All options: {} --help\n", name);
  return CLI::detail::find_and_replace(text, "\n\n\n", "\n\n");
}

std::string HelpFormat::make_option(const CLI::Option* option, bool is_positional) const {
  return entry(make_option_name(option, is_positional) + make_option_opts(option), make_option_desc(option));
}

std::string HelpFormat::make_group(std::string heading, bool is_positional,
                                   std::vector<const CLI::Option*> options) const {
  return heading == hidden_options ? ""
                                   : CLI::Formatter::make_group(std::move(heading), is_positional, std::move(options));
}

std::string HelpFormat::make_subcommand(const CLI::App* command) const {
  return entry(command->get_name(), command->get_description());
}

std::string HelpFormat::make_footer(const CLI::App* app) const {
  return app->get_footer().empty() ? "" : wrapped(app->get_footer(), terminal_width()) + "\n";
}

std::string HelpFormat::make_option_opts(const CLI::Option* option) const {
  if (option->get_type_size() == 0) return {};
  const std::string type = type_of(*option);
  return fmt::format(" {}{}", is_long_list(type) ? "WORD" : type,
                     option->get_expected_max() == CLI::detail::expected_max_vector_size ? " ..." : "");
}

std::string HelpFormat::make_option_desc(const CLI::Option* option) const {
  std::vector<std::string> notes;
  if (const std::string type = type_of(*option); option->get_type_size() != 0 && is_long_list(type)) {
    notes.push_back("one of " + CLI::detail::find_and_replace(type.substr(1, type.size() - 2), ",", ", "));
  }
  if (!option->get_default_str().empty() && !option->get_required()) {
    notes.push_back("default: " + option->get_default_str());
  }
  if (option->get_required()) notes.emplace_back("required");
  const auto add_names = [&](const char* words, const std::set<CLI::Option*>& options) {
    const std::vector<std::string> names = sorted_names(options);
    if (!names.empty()) notes.push_back(fmt::format("{} {}", words, fmt::join(names, ", ")));
  };
  add_names("needs", option->get_needs());
  add_names("not with", option->get_excludes());
  std::string text = option->get_description();
  if (notes.empty()) return text;
  const bool continues = text.ends_with(')') && text.find("default: ") != std::string::npos;
  if (continues) text.pop_back();
  return fmt::format("{}{}{})", text, continues ? "; " : " (", fmt::join(notes, "; "));
}

void begin_option_group(CLI::App& command, const std::string& heading) { command.option_defaults()->group(heading); }

bool is_hidden(const CLI::Option& option) { return option.get_group() == hidden_options; }

}  // namespace shapegauge
