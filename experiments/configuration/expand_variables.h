#pragma once

#include <string>
#include <string_view>

namespace shapegauge {

/// The text with every `${NAME}` replaced by the environment variable NAME. Throws InputError where a variable is not
/// set or is empty (the message says to set it), or where a `${` has no `}`.
std::string expand_variables(std::string_view text);

}  // namespace shapegauge
