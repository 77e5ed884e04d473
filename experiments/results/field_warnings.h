#pragma once

#include <span>
#include <string>
#include <vector>

#include "shapegauge/experiments/fields/field.h"

namespace shapegauge {

/// What a reader of the results should know of the fields: a sentence for each outcome that leaves samples undecided or
/// without a value.
std::vector<std::string> field_warnings(std::span<const FieldReport> fields);

}  // namespace shapegauge
