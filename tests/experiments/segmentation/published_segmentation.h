// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "shapegauge/experiments/configuration/segmentation_experiment.h"
#include "shapegauge/experiments/segmentation/write_segmentation.h"
#include "tests/experiments/published_results.h"

namespace shapegauge::test {

/// Publishes the results of a segmentation experiment.
inline RunOutcome publish(const std::filesystem::path& destination, const SegmentationResults& results) {
  return publish_results(destination, to_json(results.experiment),
                         [&](const RunResults& to) { return write_segmentation(to, results); });
}

}  // namespace shapegauge::test
