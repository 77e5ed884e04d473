// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace shapegauge {

/// Returns the value of an environment variable, which may be empty; nothing if it is not set.
std::optional<std::string> environment_variable(const std::string& name);

}  // namespace shapegauge
