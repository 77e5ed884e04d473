// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace shapegauge {

/// Sanitises text from a file, or a file name, for a one-line message on a terminal. Replaces control characters,
/// those that change the direction of text, and invalid UTF-8 by `?`. Truncates text longer than `longest` bytes and
/// appends `...`.
std::string printable(std::string_view text, std::size_t longest = std::string_view::npos);

/// Error caused by input: a file, a configuration or an argument. Base of all errors that a user can correct. The
/// message is one line that names the file, the line, the fault and the remedy, for example "models/T3.off:12: vertex 4
/// has a coordinate that is not a finite number; repair or remove the file". The constructor applies printable().
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::string_view message) : std::runtime_error(printable(message)) {}
};

/// Invalid argument of a library function. The message does not name a file; callers that read the value from a file
/// prefix its name.
class ArgumentError : public InputError {
 public:
  using InputError::InputError;
};

/// Calls `work` and returns its result. Prefixes the message of an InputError that it throws with `source`, such as a
/// file name.
template <typename Work>
auto with_source(const std::string& source, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    throw InputError(source + ": " + error.what());
  }
}

}  // namespace shapegauge
