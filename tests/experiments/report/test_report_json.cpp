#include <algorithm>
#include <gmock/gmock.h>

#include "shapegauge/experiments/report/packed_values.h"
#include "shapegauge/experiments/report/report_json.h"
#include "tests/experiments/report/sample_reports.h"

namespace shapegauge {
namespace {

using testing::Contains;
using testing::Not;

TEST(ReportJson, HoldsTheFiguresOfTheEvaluations) {
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

TEST(ReportJson, TheNearestModelsAreInTheirOrder) {
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

TEST(ReportJson, OfALargeDataSetOnlyTheWorstQueriesHaveTheirNearest) {
  const auto models = static_cast<Eigen::Index>(most_models_with_neighbours + 1);
  DistanceMatrix distances(models, models);
  std::vector<int> labels;
  for (Eigen::Index i = 0; i < models; ++i) {
    labels.push_back(static_cast<int>(i % 7));
    for (Eigen::Index j = 0; j < models; ++j) distances(i, j) = static_cast<double>((i * 31 + j * 17) % 101);
  }
  const std::vector<Evaluation> evaluations = {evaluate(distances, labels, {})};
  Report report;
  report.classes = std::vector<std::string>(7, "x");
  report.ids = std::vector<std::string>(static_cast<std::size_t>(models), "x");
  report.labels = labels;
  report.methods.push_back(
      {.name = "x", .description = {}, .distances = &distances, .evaluations = evaluations, .histograms = {}});
  const auto method = report_json(report)["methods"][0];
  EXPECT_EQ(method["nearest"]["models"].size(), 20U);
  EXPECT_EQ(method["evaluations"][0]["worst"].size(), 20U);
  EXPECT_EQ(method["heat_map"]["block"], 3);
}

TEST(ReportJson, HistogramsAreOfTheMethodOrOfItsParts) {
  const test_report::SampleReport& sample = test_report::hostile_report();
  const auto methods = report_json(sample.report)["methods"];
  EXPECT_EQ(methods[0]["histograms"]["bins"], 20);
  EXPECT_EQ(methods[0]["histograms"]["ranges"].size(), 12U);
  EXPECT_TRUE(methods[2]["histograms"].is_null());
  EXPECT_EQ(methods[2]["parts"], (std::vector{0, 1}));
}

TEST(ReportJson, PicturesAreThereOrNot) {
  const test_report::SampleReport& sample = test_report::hostile_report();
  const auto pictures = report_json(sample.report)["pictures"];
  EXPECT_EQ(pictures["png"][7], base64(sample.report.pictures.png[7]));
  EXPECT_TRUE(report_json(test_report::plain_report().report)["pictures"].is_null());
}

}  // namespace
}  // namespace shapegauge
