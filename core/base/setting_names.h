#pragma once

#include <string>
#include <string_view>

namespace shapegauge {

/// Reader of a message, which determines how settings are spelled in it.
enum class Audience {
  command_line,  ///< --minimum-size 3
  python         ///< minimum_size=3
};

/// A setting in a message: "--resamples" or "resamples". `name` has underscores.
std::string setting_name(Audience audience, std::string_view name);

/// A setting with a word as its value: "--ties index" or "ties='index'".
std::string setting_with_word(Audience audience, std::string_view name, std::string_view word);

/// A setting with a number as its value: "--offset 0.03" or "offset=0.03".
std::string setting_with_number(Audience audience, std::string_view name, double number);

/// A switch that is on: "--similarity" or "similarity=True".
std::string setting_on(Audience audience, std::string_view name);

}  // namespace shapegauge
