#pragma once

#include <vector>

#include "shapegauge/pages/collection_page.h"

namespace shapegauge::test_collection {

/// Page of a collection, with the data it refers to.
struct SampleCollection {
  std::vector<RankComparison> ranks;
  CollectionPage page;
};

/// Twelve methods on fourteen data sets, with groups that overlap, two protocols and measures, names that need escaping
/// in markup and scripts, and an omitted data set.
const SampleCollection& sample_collection();

}  // namespace shapegauge::test_collection
