#include <gmock/gmock.h>
#include <stdexcept>

#include "shapegauge/metrics/worst_queries.h"

namespace shapegauge {
namespace {

using testing::ElementsAre;

Evaluation evaluation() {
  Evaluation evaluation;
  evaluation.measures = {"NN", "FT"};
  evaluation.queries = {3, 5, 7, 9};
  evaluation.per_query = Eigen::MatrixXd{{1, 0.5}, {0, 0.25}, {1, 0.5}, {0, 0.75}};
  return evaluation;
}

TEST(WorstQueries, LowestFirstAndEqualsInTheirOrder) {
  EXPECT_THAT(worst_queries(evaluation(), "FT", 3), ElementsAre(1, 0, 2));
  EXPECT_THAT(worst_queries(evaluation(), "NN", 4), ElementsAre(1, 3, 0, 2));
}

TEST(WorstQueries, NoMoreThanThereAre) {
  EXPECT_THAT(worst_queries(evaluation(), "FT", 10), ElementsAre(1, 0, 2, 3));
  EXPECT_THAT(worst_queries(evaluation(), "FT", 0), ElementsAre());
}

TEST(WorstQueries, AnUnknownMeasureIsRefused) {
  EXPECT_THROW(worst_queries(evaluation(), "mAP", 1), std::invalid_argument);
}

}  // namespace
}  // namespace shapegauge
