// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "shapegauge/retrieval/descriptors/descriptor.h"

namespace shapegauge {

/// Default settings for the given number of fields.
inline DescriptorSettings default_settings(const Descriptor& of, std::size_t fields = 0) {
  return {.values = ParameterValues(of.parameters),
          .axes = std::vector<ParameterValues>(fields, ParameterValues(of.axis_parameters))};
}

}  // namespace shapegauge
