#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace shapegauge {

/// Text from a file, made fit for a one-line message: control characters replaced by `?`, cut after so many bytes, with
/// `...` in place of the rest.
std::string printable(std::string_view text, std::size_t longest);

}  // namespace shapegauge
