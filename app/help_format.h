// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <string_view>

namespace shapegauge {

/// Breaks lines at blanks so that they have at most `width` characters, as far as their words permit. Lines that
/// continue an indented line or an "Example: " are indented by two more blanks.
std::string wrapped(std::string_view text, std::size_t width);

/// CLI11 formatter of --help, as wide as the terminal: short value types, and after each description one parenthesis
/// with defaults and conditions: "(default: 25; not with --list)". `-h` (AppFormatMode::Normal) shows the options
/// needed most, and `--help` (AppFormatMode::All) all options.
class HelpFormat : public CLI::Formatter {
 public:
  [[nodiscard]] std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  [[nodiscard]] std::string make_option(const CLI::Option* option, bool is_positional) const override;
  [[nodiscard]] std::string make_subcommand(const CLI::App* command) const override;
  [[nodiscard]] std::string make_footer(const CLI::App* app) const override;
  [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override;
  [[nodiscard]] std::string make_option_desc(const CLI::Option* option) const override;
};

/// Puts the options added to the command from now on under a heading of its --help.
void begin_option_group(CLI::App& command, const std::string& heading);

/// Headings of groups of options in --help that several commands share.
/// @{
inline constexpr const char* input_options = "Input";
inline constexpr const char* output_options = "Output";
inline constexpr const char* computation_options = "Computation";
/// @}

}  // namespace shapegauge
