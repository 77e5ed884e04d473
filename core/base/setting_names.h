#pragma once

#include <string>
#include <string_view>

namespace shapegauge {

/// Interface that a message is written for. Determines how the message spells settings.
enum class Audience {
  command_line,  ///< --minimum-size 3
  python         ///< minimum_size=3
};

/// Formats the name of a setting: "--resamples" or "resamples". `name` has underscores.
std::string setting_name(Audience audience, std::string_view name);

/// Formats a setting with a word as its value: "--ties index" or "ties='index'".
std::string setting_with_word(Audience audience, std::string_view name, std::string_view word);

/// Formats a setting with a number as its value: "--offset 0.03" or "offset=0.03".
std::string setting_with_number(Audience audience, std::string_view name, double number);

/// Formats a switch that is on: "--similarity" or "similarity=True".
std::string setting_on(Audience audience, std::string_view name);

}  // namespace shapegauge
