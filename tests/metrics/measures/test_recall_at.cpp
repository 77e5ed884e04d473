#include <gtest/gtest.h>

#include "shapegauge/metrics/measures/recall_at.h"

namespace shapegauge {
namespace {

TEST(RecallAt, DividesByAllRelevantModels) {
  const RankedList list = list_of_hits({true, false, true}, false, 2);
  EXPECT_EQ(recall_at(list, 2), 0.25);
  EXPECT_EQ(recall_at(list, 10), 0.5);
}

}  // namespace
}  // namespace shapegauge
