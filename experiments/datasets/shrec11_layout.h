#pragma once

#include "shapegauge/experiments/datasets/dataset.h"

namespace shapegauge {

/// The layout "shrec11": one folder of models, T0.off, T1.off, ..., and a .cla file that says which of them are used
/// and their classes. A model of the .cla file without a file gets the name that the file should have. Throws
/// InputError: a .cla file that is absent or wrong, two files for one model.
Dataset find_shrec11_dataset(const DatasetLocation& location);

}  // namespace shapegauge
