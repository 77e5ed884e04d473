// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <string_view>

namespace shapegauge {

/// Breaks lines of a text at blanks so that they have at most `width` characters, except for longer words. Lines that
/// continue an indented line or an "Example: " are indented by two more blanks.
std::string wrapped(std::string_view text, std::size_t width);

/// CLI11 formatter of --help, as wide as the terminal: short value types, and after each description one parenthesis
/// with defaults and conditions: "(default: 25; not with --list)". `-h` (AppFormatMode::Normal) shows the options
/// needed most, and `--help` (AppFormatMode::All) all options.
class HelpFormat : public CLI::Formatter {
 public:
  /// Formats the help of a command: usage, options, subcommands, notes and examples.
  [[nodiscard]] std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  /// Formats an option or, if `is_positional`, an argument, with its description.
  [[nodiscard]] std::string make_option(const CLI::Option* option, bool is_positional) const override;
  /// Formats a group of options; returns nothing for hidden_options.
  [[nodiscard]] std::string make_group(std::string heading, bool is_positional,
                                       std::vector<const CLI::Option*> options) const override;
  [[nodiscard]] std::string make_subcommand(const CLI::App* command) const override;  ///< name and description
  [[nodiscard]] std::string make_footer(const CLI::App* app) const override;  ///< notes and examples, with broken lines
  [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override;  ///< type of an option's value
  [[nodiscard]] std::string make_option_desc(const CLI::Option* option) const override;  ///< description and defaults
};

/// Starts a group of options: those that are added to the command later appear under `heading` in its --help.
void begin_option_group(CLI::App& command, const std::string& heading);

/// Headings of groups of options in --help that several commands share.
/// @{
inline constexpr const char* input_options = "Input";              ///< heading of options on input files
inline constexpr const char* output_options = "Output";            ///< heading of options on output files
inline constexpr const char* computation_options = "Computation";  ///< heading of options on how results are computed
/// @}

/// Group of options that no help shows, such as older names. With CLI11's own hidden group, which is "", an option has
/// no name in error messages.
inline constexpr const char* hidden_options = "Hidden";

/// Returns true for options of the group hidden_options.
bool is_hidden(const CLI::Option& option);

}  // namespace shapegauge
