// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shapegauge/pages/multi_dataset_page.h"
#include "tests/pages/sample_multi_dataset.h"
#include "tests/support/page_text.h"

namespace shapegauge {

namespace {

using testing::HasSubstr;
using testing::Not;

TEST(MultiDatasetPage, EscapesMarkupInNames) {
  const std::string page = multi_dataset_page(test_multi_dataset::sample_multi_dataset());
  EXPECT_EQ(test::occurrences(page, "</script>"), 3U) << "the library, the data, the scripts";
  EXPECT_EQ(test::occurrences(page, "</title>"), 1U);
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page, Not(HasSubstr("{{")));
}

TEST(MultiDatasetPage, ContainsValuesRanksAndGroupsOfEachTable) {
  const MultiDatasetPage& sample = test_multi_dataset::sample_multi_dataset();
  const auto json = test::json_of_page(multi_dataset_page(sample));
  ASSERT_EQ(json["tables"].size(), 8U);
  const auto& table = json["tables"][5];
  EXPECT_EQ(table["average"], "micro");
  EXPECT_NEAR(table["values"][3][2].get<double>(), sample.tables[5].values(3, 2), 1e-5);
  EXPECT_NEAR(table["mean_ranks"][4].get<double>(), sample.tables[5].ranks.mean_ranks[4], 1e-4);
  EXPECT_EQ(table["groups"].size(), sample.tables[5].ranks.groups.size());
  EXPECT_EQ(table["pairs"].size(), 66U);
  EXPECT_EQ(table["rank_intervals"][11][1], sample.tables[5].rank_intervals[11].worst);
  EXPECT_EQ(json["failures"][0][1], "no such folder </script>");
}

TEST(MultiDatasetPage, OmitsTheCriticalDifferenceForOneDataSet) {
  const Eigen::MatrixXd values{{1, 0}};
  const MultiDatasetPage one{.title = "one",
                             .description = {},
                             .methods = {"a", "b"},
                             .datasets = {{.name = "set", .page = {}, .models = 2, .queries = 2}},
                             .tables = {{.protocol = "psb",
                                         .average = Average::micro,
                                         .measure = "NN",
                                         .values = values,
                                         .ranks = compare_by_ranks(values)}},
                             .words = {""},
                             .main_measure = "NN",
                             .failures = {}};
  EXPECT_THAT(multi_dataset_page(one), HasSubstr("\"critical_difference\":null"));
}

}  // namespace

}  // namespace shapegauge
