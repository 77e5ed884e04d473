#pragma once

#include <filesystem>

#include "shapegauge/experiments/configuration/shape_comparison.h"
#include "shapegauge/experiments/shape_comparison/write_shape_comparison.h"
#include "tests/experiments/published_results.h"

namespace shapegauge::test {

/// Publishes the results of a comparison.
inline void publish(const std::filesystem::path& destination, const ShapeComparisonResults& results) {
  publish_results(destination, to_json(results.comparison),
                  [&](const std::filesystem::path& folder) { return write_shape_comparison(folder, results); });
}

}  // namespace shapegauge::test
