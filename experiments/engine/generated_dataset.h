// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "shapegauge/datasets/generator/generate_dataset.h"
#include "shapegauge/experiments/engine/run_control.h"

namespace shapegauge {

/// Generates a data set in `folder` unless the folder has one that this version and commit generated with the same
/// options. Waits while another process generates a data set there. Throws InputError as generate_dataset() does and
/// for a file "generated.json" that is not the record of a generated data set; throws Interrupted.
void prepare_generated(const std::filesystem::path& folder, const GeneratorOptions& options, const RunControl& control);

}  // namespace shapegauge
