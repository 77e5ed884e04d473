// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "shapegauge/core/base/error.h"

namespace shapegauge::fuzz {

/// Throws std::logic_error if the guarantee is violated.
inline void promise(bool holds, std::string_view what) {
  if (!holds) throw std::logic_error("broken promise: " + std::string(what));
}

/// Runs the function. Returns false on InputError, whose message must be one line that begins with `source`.
template <typename Function>
bool is_accepted(std::string_view source, const Function& function) {
  try {
    function();
    return true;
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    promise(message.starts_with(source), "an error begins with where it is");
    promise(message.find('\n') == std::string_view::npos, "an error is one line");
    promise(message.size() < 1000, "an error is short");
    return false;
  }
}

}  // namespace shapegauge::fuzz
