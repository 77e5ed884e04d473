#pragma once

#include <filesystem>

#include "shapegauge/experiments/configuration/configuration.h"
#include "shapegauge/experiments/datasets/dataset.h"
#include "shapegauge/experiments/runner/run_control.h"

namespace shapegauge {

/// The data set of the configuration. One that the program makes lies in the given folder: it is made there unless it
/// was made before, by this version and commit with these settings. Throws InputError as find_dataset and
/// generate_dataset do, and Interrupted.
Dataset prepare_dataset(const Configuration& configuration, const std::filesystem::path& generated_folder,
                        const RunControl& control);

}  // namespace shapegauge
