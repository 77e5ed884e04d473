#pragma once

#include <filesystem>

#include "shapegauge/datasets/generator/generate_dataset.h"
#include "shapegauge/experiments/distributed/communicator.h"
#include "shapegauge/experiments/engine/run_control.h"

namespace shapegauge {

/// Makes a data set in the folder unless it was made there before, by this version and commit with these options.
/// Collective: rank 0 makes it. Throws InputError as generate_dataset(), and Interrupted.
void prepare_generated(const std::filesystem::path& folder, const GeneratorOptions& options, const RunControl& control,
                       Communicator& ranks);

}  // namespace shapegauge
