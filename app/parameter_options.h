#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "shapegauge/core/base/parameter.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// Options of a command that are made from the parameters of a registry's entries: their names, meanings, legal values
/// and defaults are stated there only.
namespace shapegauge {

/// What was given for a parameter.
struct ParameterText {
  std::string option;  ///< its name in messages
  std::string text;    ///< empty: not given
};

/// By parameter. References to entries stay valid.
using ParameterTexts = std::map<std::string, ParameterText, std::less<>>;

/// The parameter's meaning and legal values, for --help; `with_default`: its default, too.
std::string meaning_of(const Parameter& parameter, bool with_default = true);

/// A description of a registry's entry as --help has them.
std::string without_full_stop(std::string_view sentence);

/// Adds an option, of a boolean a flag, that fills `given`. `names`: as CLI11 takes them; empty: `--` and the
/// parameter's name. `meaning`: empty for meaning_of().
CLI::Option* add_parameter_option(CLI::App& command, const Parameter& parameter, ParameterText& given,
                                  std::string names = {}, std::string meaning = {});

/// The defaults of the parameters and, in their place, what was given. `subject` follows "goes with" in messages.
/// Throws InputError for a text that the parameter does not take, and for one that was given of a parameter that is not
/// in the list.
ParameterValues parameter_values(std::span<const Parameter> parameters, const ParameterTexts& given,
                                 std::string_view subject);

}  // namespace shapegauge
