// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/results/multi_dataset_results.h"

namespace shapegauge {

namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Scores of two methods on a data set: three queries, the first two of one class.
EvaluatedDataset small_dataset(const std::string& name, const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
  EvaluatedDataset dataset{.name = name, .folder = name, .page = name + "/report.html", .models = 3, .scores = {}};
  for (const auto& [method, values] : {std::pair{"a", first}, {"b", second}}) {
    dataset.scores.push_back({.method = method,
                              .source = name,
                              .protocol = "psb",
                              .measures = {"NN"},
                              .queries = {"x", "y", "z"},
                              .classes = {"one", "one", "two"},
                              .values = values});
  }
  return dataset;
}

MultiDatasetResults small_results() {
  MultiDatasetResults results;
  results.name = "small";
  results.methods = {"a", "b"};
  results.datasets = {small_dataset("s", {0.2, 0.4, 0.9}, {0.8, 0.8, 0.8}),
                      small_dataset("t", {0.1, 0.1, 0.1}, {0.5, 0.5, 0.2})};
  results.tables = multi_dataset_tables(results.datasets, 0.05);
  results.main_measure = "NN";
  return results;
}

TEST(MultiDatasetResults, AreAveragesOverQueriesAndOverClasses) {
  const MultiDatasetResults results = small_results();
  ASSERT_EQ(results.tables.size(), 2U);
  EXPECT_NEAR(results.tables[0].values(0, 0), 0.5, 1e-12);
  EXPECT_NEAR(results.tables[1].values(0, 0), (0.3 + 0.9) / 2, 1e-12);
  EXPECT_NEAR(results.tables[0].values(1, 1), 0.4, 1e-12);
  EXPECT_EQ(&main_table(results), results.tables.data());
}

TEST(MultiDatasetResults, AreSummarisedByMeanRank) {
  const MultiDatasetResults results = small_results();
  const TextTable table = multi_dataset_summary(results, main_table(results));
  EXPECT_THAT(table.header, ElementsAre("method", "s", "t", "mean", "mean rank", "group"));
  EXPECT_THAT(table.rows[0], ElementsAre("b", "80.00", "40.00", "60.00", "1.00", "a"));
  EXPECT_THAT(table.rows[1], ElementsAre("a", "50.00", "10.00", "30.00", "2.00", "a"));
  EXPECT_THAT(to_latex(table), HasSubstr("\\textbf{80.00}"));
}

TEST(MultiDatasetResults, CsvAndJsonContainAllTablesAndMethodPairs) {
  const MultiDatasetResults results = small_results();
  EXPECT_EQ(multi_dataset_csv_table(results).rows.size(), 4U);
  const TextTable pairs = multi_dataset_pairs_table(results);
  ASSERT_EQ(pairs.rows.size(), 2U);
  EXPECT_THAT(pairs.rows[0], ElementsAre("psb", "micro", "NN", "a", "b", "1.0000", testing::_, "0", "0", "2"));
  const auto json = multi_dataset_json(results);
  EXPECT_EQ(json["tables"][0]["methods"][0]["method"], "b");
  EXPECT_EQ(json["tables"][0]["friedman"]["chi_squared"], 2.0);
  EXPECT_TRUE(json["tables"][0]["friedman"]["f"].is_null()) << "infinite: both data sets rank alike";
}

TEST(MultiDatasetResults, LinkToReportsOnlyIfTheyExist) {
  MultiDatasetResults results = small_results();
  EXPECT_THAT(multi_dataset_html(results), HasSubstr("s/report.html"));
  for (EvaluatedDataset& dataset : results.datasets) dataset.page.clear();
  EXPECT_THAT(multi_dataset_html(results), testing::Not(HasSubstr("s/report.html")));
}

TEST(MultiDatasetResults, ReportTheFriedmanTestOnlyForSeveralDataSets) {
  MultiDatasetResults results = small_results();
  EXPECT_THAT(test_words(results, main_table(results)), HasSubstr("chi-squared 2.00"));
  results.datasets.pop_back();
  results.tables = multi_dataset_tables(results.datasets, 0.05);
  EXPECT_THAT(test_words(results, main_table(results)), testing::Not(HasSubstr("chi-squared")));
}

}  // namespace

}  // namespace shapegauge
