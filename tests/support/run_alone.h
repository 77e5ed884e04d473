// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "shapegauge/experiments/engine/experiment.h"

namespace shapegauge::test {

/// Calls the work with the context of a run in this process alone.
template <typename Work>
auto run_alone(const RunControl& control, Cache& cache, const std::filesystem::path& generated, const Work& work) {
  return work(RunContext{.control = control, .cache = cache, .generated = generated});
}

}  // namespace shapegauge::test
