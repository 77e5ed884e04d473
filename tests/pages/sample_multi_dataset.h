// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/pages/multi_dataset_page.h"

namespace shapegauge::test_multi_dataset {

/// The page of a multi-dataset experiment: twelve methods on fourteen data sets, with groups that overlap, two
/// protocols and measures, names that a page of markup and scripts could trip over, and a data set that was left out.
const MultiDatasetPage& sample_multi_dataset();

}  // namespace shapegauge::test_multi_dataset
