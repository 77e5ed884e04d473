#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "shapegauge/metrics/evaluation.h"

namespace shapegauge {

/// The `count` queries with the lowest values of a measure, the lowest first and equals in their order, as positions in
/// Evaluation::queries; all of them where there are no more. Throws std::invalid_argument where the evaluation has no
/// measure of that name.
std::vector<std::size_t> worst_queries(const Evaluation& evaluation, std::string_view measure, std::size_t count);

}  // namespace shapegauge
