#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace shapegauge {

/// Layout of --help: short value types, and after each description one parenthesis with defaults and conditions:
/// "(default: 25; not with --list)".
class HelpFormat : public CLI::Formatter {
 public:
  [[nodiscard]] std::string make_option_opts(const CLI::Option* option) const override;
  [[nodiscard]] std::string make_option_desc(const CLI::Option* option) const override;
};

/// Puts the options added to the command from now on under a heading of its --help.
void begin_option_group(CLI::App& command, const std::string& heading);

/// Headings that several commands share.
/// @{
inline constexpr const char* input_options = "Input";
inline constexpr const char* output_options = "Output";
inline constexpr const char* computation_options = "Computation";
/// @}

}  // namespace shapegauge
