#pragma once

#include <filesystem>

#include "shapegauge/experiments/configuration/segmentation_experiment.h"
#include "shapegauge/experiments/segmentation/write_segmentation.h"
#include "tests/experiments/published_results.h"

namespace shapegauge::test {

/// Publishes the results of a segmentation experiment.
inline void publish(const std::filesystem::path& destination, const SegmentationResults& results) {
  publish_results(destination, to_json(results.experiment),
                  [&](const std::filesystem::path& folder) { return write_segmentation(folder, results); });
}

}  // namespace shapegauge::test
