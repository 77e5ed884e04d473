// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/engine/experiment.h"

namespace shapegauge::test {

/// Publishes results as a run does (run_into_folder()).
inline RunOutcome publish_results(const std::filesystem::path& destination, const nlohmann::json& configuration,
                                  const std::function<RunOutcome(const RunResults& to)>& write) {
  const Experiment experiment{.name = "results",
                              .configuration = [&] { return configuration; },
                              .run = [&](const RunContext&, const RunResults& to) { return write(to); }};
  Cache none;
  return run_into_folder(experiment, destination, true, {}, none);
}

}  // namespace shapegauge::test
