// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "shapegauge/pages/html_page.h"
#include "shapegauge/pages/report_json.h"
#include "shapegauge/retrieval/distance_matrix.h"
#include "tests/pages/sample_reports.h"

namespace shapegauge {

namespace {

using testing::Contains;
using testing::Not;

TEST(PackedNumbers, AreSixteenBitFractionsOfTheLargestNumber) {
  const double infinity = std::numeric_limits<double>::infinity();
  const nlohmann::ordered_json json = packed_numbers(Eigen::VectorXd{{0, 3, 1.5, infinity, std::nan(""), -1}});
  EXPECT_EQ(json["scale"], 3);
  // 0, 65534, 32767, 65535, 65535, 0
  EXPECT_EQ(json["values"], base64(std::string("\0\0\xfe\xff\xff\x7f\xff\xff\xff\xff\0\0", 12)));
}

TEST(PackedNumbers, HaveScaleOneForZerosAndAreEmptyWithoutNumbers) {
  EXPECT_EQ(packed_numbers(Eigen::VectorXd{{0, 0}})["scale"], 1);
  EXPECT_EQ(packed_numbers(Eigen::VectorXd(0))["values"], "");
}

TEST(HeatMap, OfASymmetricMatrixContainsTheUpperHalfInClassOrder) {
  // Models 1 and 2 are of the first class, 0 of the second.
  const DistanceMatrix distances{{0, 1, 2}, {1, 0, 4}, {2, 4, 0}};
  const auto json = heat_map(overview_of(distances, std::vector<int>{1, 0, 0}));
  EXPECT_EQ(json["side"], 3);
  EXPECT_EQ(json["block"], 1);
  EXPECT_EQ(json["symmetric"], true);
  EXPECT_EQ(json["values"], packed_numbers(Eigen::VectorXd{{0, 4, 1, 0, 2, 0}})["values"]);
  EXPECT_EQ(json["scale"], 4);
}

TEST(HeatMap, OfAnAsymmetricMatrixContainsAllCells) {
  const DistanceMatrix distances{{9, 1}, {3, 9}};
  const auto json = heat_map(overview_of(distances, std::vector<int>{0, 0}));
  EXPECT_EQ(json["symmetric"], false);
  EXPECT_EQ(json["values"], packed_numbers(Eigen::VectorXd{{0, 1, 3, 0}})["values"]);
}

TEST(HeatMap, OfManyModelsContainsMeansOfBlocks) {
  const Eigen::Index models = 2 * max_heat_map_side + 1;
  DistanceMatrix distances = DistanceMatrix::Constant(models, models, 6);
  distances.diagonal().setConstant(1e9);
  const auto json = heat_map(overview_of(distances, std::vector<int>(static_cast<std::size_t>(models), 0)));
  EXPECT_EQ(json["block"], 3);
  const Eigen::Index side = json["side"];
  EXPECT_EQ(side, 667);
  EXPECT_EQ(json["symmetric"], true);
  EXPECT_EQ(json["scale"], 6);
  // In the first cell three of nine pairs are of a model with itself: the mean is 4.
  EXPECT_EQ(json["values"].get<std::string>().substr(0, 4), base64(std::string("\xa9\xaa\xfe", 3)));
}

TEST(ReportJson, ContainsTheScoresOfEachMethod) {
  const test_report::SampleReport& sample = test_report::hostile_report();
  const auto json = report_json(sample.report);
  ASSERT_EQ(json["methods"].size(), 3U);
  const auto& psb = json["methods"][1]["evaluations"][0];
  const Evaluation& evaluation = sample.evaluations[1][0];
  EXPECT_EQ(psb["protocol"], "psb");
  EXPECT_EQ(psb["left_out"], 1) << "the class of one model";
  for (std::size_t i = 0; i < evaluation.measures.size(); ++i) {
    EXPECT_NEAR(psb["micro"][i], evaluation.micro[static_cast<Eigen::Index>(i)], 1e-6);
    EXPECT_NEAR(psb["macro"][i], evaluation.macro[static_cast<Eigen::Index>(i)], 1e-6);
  }
  EXPECT_EQ(psb["per_query"].size(), evaluation.queries.size());
  EXPECT_EQ(json["methods"][0]["evaluations"][1]["protocol"], "paper");
}

TEST(ReportJson, ListsNearestModelsByDistance) {
  const test_report::SampleReport& sample = test_report::plain_report();
  const auto nearest = report_json(sample.report)["methods"][0]["nearest"];
  ASSERT_EQ(nearest["models"].size(), sample.report.ids.size());
  const DistanceMatrix& distances = sample.distances[0];
  for (int model = 0; model < 12; ++model) {
    const auto list = nearest["lists"][static_cast<std::size_t>(model)].get<std::vector<int>>();
    ASSERT_EQ(list.size(), 10U);
    EXPECT_THAT(list, Not(Contains(model)));
    const auto distance = [&](int other) { return distances(model, other); };
    EXPECT_TRUE(std::ranges::is_sorted(list, {}, distance));
  }
}

TEST(ReportJson, ListsNeighboursOfOnlyTheWorstQueriesForLargeDataSets) {
  const auto models = static_cast<Eigen::Index>(max_models_with_neighbours + 1);
  DistanceMatrix distances(models, models);
  std::vector<int> labels;
  for (Eigen::Index i = 0; i < models; ++i) {
    labels.push_back(static_cast<int>(i % 7));
    for (Eigen::Index j = 0; j < models; ++j) distances(i, j) = static_cast<double>((i * 31 + j * 17) % 101);
  }
  const std::vector<Evaluation> evaluations = {evaluate(distances, labels, {})};
  const DistanceOverview overview = overview_of(distances, labels);
  Report report;
  report.classes = std::vector<std::string>(7, "x");
  report.ids = std::vector<std::string>(static_cast<std::size_t>(models), "x");
  report.labels = labels;
  report.methods.push_back({.name = "x",
                            .distance = {},
                            .settings = {},
                            .distances = &overview,
                            .evaluations = evaluations,
                            .intervals = {},
                            .histograms = {}});
  const auto method = report_json(report)["methods"][0];
  EXPECT_EQ(method["nearest"]["models"].size(), 20U);
  EXPECT_EQ(method["evaluations"][0]["worst"].size(), 20U);
  EXPECT_EQ(method["heat_map"]["block"], 3);
}

TEST(ReportJson, ExcludesInfiniteDistancesAndListsTheWorstQueriesByAveragePrecision) {
  const double infinity = std::numeric_limits<double>::infinity();
  const DistanceMatrix distances{
      {0, 1, 2, infinity}, {1, 0, 3, infinity}, {2, 3, 0, infinity}, {infinity, infinity, infinity, 0}};
  const std::vector<int> labels{0, 0, 1, 1};
  const std::vector<Evaluation> evaluations = {evaluate(distances, labels, {})};
  const DistanceOverview overview = overview_of(distances, labels);
  Report report;
  report.classes = {"x", "y"};
  report.ids = {"a", "b", "c", "d"};
  report.labels = labels;
  report.methods.push_back({.name = "x",
                            .distance = {},
                            .settings = {},
                            .distances = &overview,
                            .evaluations = evaluations,
                            .intervals = {},
                            .histograms = {}});
  const auto method = report_json(report)["methods"][0];
  EXPECT_EQ(method["nearest"]["lists"].dump(), "[[1,2],[0,2],[0,1],[]]");
  EXPECT_EQ(method["confusion"].dump(), "[[[0,2]],[[0,1]]]");
  EXPECT_EQ(method["evaluations"][0]["worst"].dump(), "[3,2,0,1]") << "of 3 nothing is found, of 2 at rank 3";
}

TEST(ReportJson, FusedMethodListsItsPartsInsteadOfHistograms) {
  const test_report::SampleReport& sample = test_report::hostile_report();
  const auto methods = report_json(sample.report)["methods"];
  EXPECT_EQ(methods[0]["histograms"]["bins"], 20);
  EXPECT_EQ(methods[0]["histograms"]["ranges"].size(), 12U);
  EXPECT_TRUE(methods[2]["histograms"].is_null());
  EXPECT_EQ(methods[2]["parts"], (std::vector{0, 1}));
}

TEST(ReportJson, ContainsConfidenceIntervalsSettingsAndModelsWithGaps) {
  const Report& report = test_report::hostile_report().report;
  const auto json = report_json(report);
  const auto& method = json["methods"][1];
  EXPECT_EQ(method["distance"], "l1 <b>");
  EXPECT_EQ(method["settings"][1], (std::vector{"offset", "0.03"}));
  const auto& evaluation = method["evaluations"][0];
  EXPECT_EQ(evaluation["intervals"]["confidence"], 0.9);
  ASSERT_EQ(evaluation["intervals"]["macro"].size(), evaluation["measures"].size());
  const double first = evaluation["macro"][0];
  EXPECT_NEAR(evaluation["intervals"]["macro"][0][0], first - 0.01, 1e-6);
  EXPECT_NEAR(evaluation["intervals"]["macro"][0][1], first + 0.01, 1e-6);
  EXPECT_EQ(json["leaks"][0][0], report.leaks[0].id);
  EXPECT_EQ(json["leaks"][0][3], 0.05);
  EXPECT_EQ(json["perturbations"][1][0], "one of");
  EXPECT_FALSE(report_json(test_report::plain_report().report)["methods"][0]["evaluations"][0].contains("intervals"));
}

TEST(ReportJson, ContainsPicturesIfThereAreAny) {
  const test_report::SampleReport& sample = test_report::hostile_report();
  const auto pictures = report_json(sample.report)["pictures"];
  EXPECT_EQ(pictures["png"][7], base64(sample.report.pictures.png[7]));
  EXPECT_TRUE(report_json(test_report::plain_report().report)["pictures"].is_null());
}

TEST(ReportJson, ContainsShapeViewsIfThereAreAny) {
  const test_report::SampleReport& sample = test_report::hostile_report();
  const auto views = report_json(sample.report)["views"];
  ASSERT_EQ(views["shapes"].size(), sample.report.ids.size());
  EXPECT_EQ(views["shapes"][7].dump(), sample.report.views.shapes[7]);
  ASSERT_EQ(views["fields"].size(), views["shapes"][7]["fields"].size());
  EXPECT_EQ(views["fields"][0]["colours"]["to"], sample.report.views.fields[0].colours->high);
  EXPECT_FALSE(views["fields"][1].contains("colours"));
  EXPECT_TRUE(report_json(test_report::plain_report().report)["views"].is_null());
}

}  // namespace

}  // namespace shapegauge
