#pragma once

#include <vector>

#include "shapegauge/pages/collection_page.h"

namespace shapegauge::test_collection {

/// The page of a collection, and what it points to.
struct SampleCollection {
  std::vector<RankComparison> ranks;
  CollectionPage page;
};

/// Twelve methods on fourteen data sets, with groups that overlap, two protocols and measures, names that a page of
/// markup and scripts could trip over, and a data set that was left out.
const SampleCollection& sample_collection();

}  // namespace shapegauge::test_collection
