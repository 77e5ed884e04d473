#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/e_measure.h"

namespace shapegauge {
namespace {

TEST(EMeasure, IsTheHarmonicMeanOfPrecisionAndRecallAmongThirtyTwo) {
  std::vector<bool> hits(100, false);
  for (const std::size_t rank : {1, 5, 20, 32, 33, 50, 60, 70}) hits[rank - 1] = true;
  const double precision = 4.0 / 32;
  const double recall = 4.0 / 8;
  EXPECT_DOUBLE_EQ(e_measure(list_of_hits(hits)), 2 / (1 / precision + 1 / recall));
}

TEST(EMeasure, LooksAtAShorterListAsAWhole) {
  // Four results, two of them relevant, all found: precision 1/2, recall 1.
  EXPECT_DOUBLE_EQ(e_measure(list_of_hits({false, true, false, true})), 2.0 / 3);
}

TEST(EMeasure, IsZeroWithoutHitsInFront) { EXPECT_EQ(e_measure(list_of_runs({{39, 0}, {1, 1}})), 0); }

}  // namespace
}  // namespace shapegauge
