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

/// Text of an option for a parameter.
struct ParameterText {
  std::string option;  ///< name of the option in messages
  std::string text;    ///< empty if not given
};

/// Texts by parameter. References to entries stay valid.
using ParameterTexts = std::map<std::string, ParameterText, std::less<>>;

/// Returns the parameter's meaning and valid values, for --help; with its default if `with_default`.
std::string meaning_of(const Parameter& parameter, bool with_default = true);

/// Returns a description of a registry entry in the form of --help, without its full stop.
std::string without_full_stop(std::string_view sentence);

/// Returns a check of an option's number by closed bounds. Unlike CLI::Range, it refuses NaN.
template <typename Number>
CLI::Validator within(const Bounds& bounds) {
  const CLI::Range range(static_cast<Number>(bounds.low), static_cast<Number>(bounds.high));
  return {[range](std::string& text) {
            const bool is_nan = std::isnan(std::strtod(text.c_str(), nullptr));
            return is_nan ? "Value " + text + " is not a number" : range(text);
          },
          range.get_description()};
}

/// Returns a check that an option's value is one of the words. Its message suggests the word that was meant.
CLI::Validator one_of(std::vector<std::string> words);

/// Adds an option, or a flag for a boolean, that fills `given`. `names` as in CLI11; if empty, `--` and the parameter's
/// name. `meaning` is meaning_of() if empty.
CLI::Option* add_parameter_option(CLI::App& command, const Parameter& parameter, ParameterText& given,
                                  std::string names = {}, std::string meaning = {});

/// Parses the texts of options, with defaults for parameters without one. `subject` follows "applies to" in messages.
/// Throws InputError for an invalid text, and for an option whose parameter is not in the list.
ParameterValues parameter_values(std::span<const Parameter> parameters, const ParameterTexts& given,
                                 std::string_view subject);

}  // namespace shapegauge
