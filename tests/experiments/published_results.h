#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/engine/experiment.h"

namespace shapegauge::test {

/// Publishes results as a run does (run_into_folder()); `write` writes the files into a folder.
inline void publish_results(const std::filesystem::path& destination, const nlohmann::json& configuration,
                            const std::function<RunOutcome(const std::filesystem::path& folder)>& write) {
  const Experiment experiment{.name = "results", .configuration = configuration, .run = [&](const RunContext& context) {
                                return write(context.results);
                              }};
  Cache none;
  run_into_folder(experiment, destination, true, {}, none);
}

}  // namespace shapegauge::test
