#pragma once

#include <string>
#include <string_view>

namespace shapegauge {

/// A word of a file, made fit for a one-line error message: in quotation marks, control characters replaced by `?`, cut
/// after 40 bytes.
std::string quoted_word(std::string_view word);

}  // namespace shapegauge
