// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shapegauge/core/base/parameter.h"

/// Options of a command generated from the parameters of registry entries, which define their names, meanings, valid
/// values and defaults.
namespace shapegauge {

/// Unparsed value of a command-line option that sets a Parameter.
struct ParameterText {
  std::string option;  ///< name of the option in messages
  std::string text;    ///< value as text; empty if the option was not given
};

/// Unparsed values of options by parameter name. Adding one does not invalidate references to others.
using ParameterTexts = std::map<std::string, ParameterText, std::less<>>;

/// Returns the parameter's meaning and valid values, for --help; with its default if `with_default`.
std::string parameter_help_text(const Parameter& parameter, bool with_default = true);

/// Returns a sentence without its full stop, as --help prints descriptions of registry entries.
std::string without_full_stop(std::string_view sentence);

/// Returns a validator that an option's number is within closed bounds. Unlike CLI::Range, it refuses NaN.
template <typename Number>
CLI::Validator within(const Bounds& bounds) {
  const CLI::Range range(static_cast<Number>(bounds.low), static_cast<Number>(bounds.high));
  return {[range](std::string& text) {
            const bool is_nan = std::isnan(std::strtod(text.c_str(), nullptr));
            return is_nan ? "Value " + text + " is not a number" : range(text);
          },
          range.get_description()};
}

/// Returns a validator that an option's value is one of the words. Its error message suggests the most similar word.
CLI::Validator one_of(std::vector<std::string> words);

/// Adds an option for a parameter, or a flag for a boolean one, which stores its text in `target`. `names` has CLI11's
/// syntax; if empty, the name is `--` and the parameter's name. `meaning` is the help text; if empty,
/// parameter_help_text().
CLI::Option* add_parameter_option(CLI::App& command, const Parameter& parameter, ParameterText& target,
                                  std::string names = {}, std::string meaning = {});

/// Parses the texts of options to values of `parameters`, with defaults for those without a text. `subject` follows
/// "applies to" in messages. Throws InputError for an invalid text, and for an option whose parameter is not in
/// `parameters`.
ParameterValues parameter_values(std::span<const Parameter> parameters, const ParameterTexts& texts,
                                 std::string_view subject);

}  // namespace shapegauge
