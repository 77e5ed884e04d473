// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/retrieval/write_results.h"
#include "tests/experiments/published_results.h"

namespace shapegauge::test {

/// Publishes the results of a retrieval run, whose distances are in memory.
inline RunOutcome publish(const std::filesystem::path& destination, const ExperimentResults& results) {
  return publish_results(destination, to_json(results.configuration), [&](const RunResults& to) {
    const std::vector<std::string> files = distance_files(results.configuration);
    for (std::size_t i = 0; i < files.size(); ++i) {
      make_folder(to.folder / "distances");
      write_npy(to.folder / files[i], results.methods[i].distances);
    }
    return write_results(to, results);
  });
}

}  // namespace shapegauge::test
