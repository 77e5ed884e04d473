// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/environment.h"

#include <cstdlib>

namespace shapegauge {

std::optional<std::string> environment_variable(const std::string& name) {
  const char* value = std::getenv(name.c_str());  // NOLINT(concurrency-mt-unsafe): nothing here changes the environment
  if (value == nullptr) return std::nullopt;
  return value;
}

}  // namespace shapegauge
