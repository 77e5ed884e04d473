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
inline void publish(const std::filesystem::path& destination, const ExperimentResults& results) {
  publish_results(destination, to_json(results.configuration), [&](const std::filesystem::path& folder) {
    const std::vector<std::string> files = distance_files(results.configuration);
    for (std::size_t i = 0; i < files.size(); ++i) {
      make_folder(folder / "distances");
      write_npy(folder / files[i], results.methods[i].distances);
    }
    return write_results(folder, results);
  });
}

}  // namespace shapegauge::test
