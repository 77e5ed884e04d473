#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "shapegauge/metrics/ranked_list.h"

namespace shapegauge {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using testing::ElementsAre;

constexpr double infinity = std::numeric_limits<double>::infinity();

Matrix every_row(const std::vector<double>& row) {
  const auto count = static_cast<Eigen::Index>(row.size());
  return Eigen::Map<const Eigen::RowVectorXd>(row.data(), count).replicate(count, 1);
}

TEST(RankedModels, NearestFirstAndTiesByIndex) {
  EXPECT_THAT(ranked_models(every_row({0, 3, 1, 2, 1, 3}), 0), ElementsAre(2, 4, 3, 1, 5));
}

TEST(RankedModels, TheQueryIsRemovedByItsIndexNotByItsDistance) {
  EXPECT_THAT(ranked_models(every_row({0, 0, 7, 1}), 2), ElementsAre(0, 1, 3));
  EXPECT_THAT(ranked_models(every_row({0, 0, 7, 1}), 1), ElementsAre(0, 3, 2));
}

TEST(RankedModels, InfinityRanksLastAndMinusInfinityFirst) {
  EXPECT_THAT(ranked_models(every_row({0, infinity, 1e308, -infinity, infinity}), 0), ElementsAre(3, 2, 1, 4));
}

TEST(RankedModels, BothZerosAreEqual) {
  EXPECT_THAT(ranked_models(every_row({9, 0.0, -0.0, 0.0}), 0), ElementsAre(1, 2, 3));
}

TEST(RankedList, UnderPsbIsWithoutTheQuery) {
  const std::vector<int> labels = {5, 8, 5, 8, 5};
  const RankedList list = ranked_list(every_row({0, 1, 2, 3, 4}), labels, 2, Protocol::psb);
  EXPECT_THAT(list.hits, ElementsAre(true, false, false, true));
  EXPECT_EQ(list.relevant, 2U);
  EXPECT_FALSE(list.starts_with_query);
}

TEST(RankedList, UnderPaperBeginsWithTheQueryWhateverItsDistance) {
  const std::vector<int> labels = {5, 8, 5, 8, 5};
  const RankedList list = ranked_list(every_row({0, 1, infinity, 3, 4}), labels, 2, Protocol::paper);
  EXPECT_THAT(list.hits, ElementsAre(true, true, false, false, true));
  EXPECT_EQ(list.relevant, 3U);
  EXPECT_TRUE(list.starts_with_query);
}

TEST(RankedList, CountsAndRanksOfHits) {
  const RankedList list{{false, true, true, false, true}, 3, false};
  EXPECT_EQ(hits_among_first(list, 0), 0U);
  EXPECT_EQ(hits_among_first(list, 2), 1U);
  EXPECT_EQ(hits_among_first(list, 5), 3U);
  EXPECT_EQ(hits_among_first(list, 99), 3U);
  EXPECT_THAT(ranks_of_hits(list), ElementsAre(2, 3, 5));
}

}  // namespace
}  // namespace shapegauge
