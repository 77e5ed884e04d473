#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace shapegauge {

/// Unusable input: a file, a configuration, an argument. The message is one line that says what, where and what to do,
/// for example "models/T3.off:12: vertex 4 has a coordinate that is not a finite number; repair or remove the file".
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Text from a file, for a one-line message: control characters become `?`, and what exceeds `longest` bytes becomes
/// `...`.
std::string printable(std::string_view text, std::size_t longest);

}  // namespace shapegauge
