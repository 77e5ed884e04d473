#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace shapegauge {

/// Sanitises text from a file, or the name of one, for a terminal and a one-line message. Control characters, which a
/// terminal would obey, and bytes that are not UTF-8 become `?`. What exceeds `longest` bytes becomes `...`.
std::string printable(std::string_view text, std::size_t longest = std::string_view::npos);

/// Unusable input: a file, a configuration, an argument. All errors of the library that a user can mend are of this
/// type or derive from it. The message is one line that says what, where and what to do,
/// for example "models/T3.off:12: vertex 4 has a coordinate that is not a finite number; repair or remove the file". It
/// is sanitised by printable().
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::string_view message) : std::runtime_error(printable(message)) {}
};

/// Values that a function of the library cannot use. The message does not say where they come from: who read them from
/// a file can put its name in front.
class ArgumentError : public InputError {
 public:
  using InputError::InputError;
};

}  // namespace shapegauge
