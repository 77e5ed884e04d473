#pragma once

#include "shapegauge/experiments/datasets/dataset.h"

namespace shapegauge {

/// The layout "folders": a folder for each class, in it the models, or folders train and test with the models. The id
/// of a model is its path below the root without the extension. Throws InputError: no class folders, a class without
/// models, two files of one id, a split that no class has.
Dataset find_folders_dataset(const DatasetLocation& location);

}  // namespace shapegauge
