// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/datasets/files/npy.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/metrics/evaluation.h"
#include "tests/experiments/retrieval/published_retrieval.h"
#include "tests/support/csv_records.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::Pointwise;

/// Results made by hand: models on a line at 0, 1, 2.5 (class a) and 4.2, 9 (class b), under "line" by their distances,
/// of which NN is 1, 1, 1, 0, 1 and FT 1, 1, 1/2, 0, 1, and under "perfect/2", a descriptor, by their classes.
class WriteResults : public test::FolderTest {
 protected:
  WriteResults() {
    for (const std::string& name : names_) write_off(at("T" + name + ".off"), test::box({1, 1, 1}, 1));
    test::write_text(at("test.cla"), "PSB 1\n2 5\na 0 3\n0\n1\n2\nb 0 2\n3\n4\n");
    results_.configuration =
        configuration_from_json({{"name", "by hand"},
                                 {"dataset", {{"layout", "shrec11"}, {"root", folder_.path().string()}}},
                                 {"report", false},
                                 {"signatures",
                                  {{{"name", "line"},
                                    {"field", {{"type", "cone_sdf"}}},
                                    {"histogram", {{"bins", 3}, {"range", {{"fixed", {0, 1}}}}}}},
                                   {{"name", "perfect/2"}, {"descriptor", {{"type", "d2"}}}}}}},
                                "test.json", folder_.path());
    results_.classes = {"a", "b"};
    const Eigen::VectorXd positions = (Eigen::VectorXd(5) << 0, 1, 2.5, 4.2, 9).finished();
    line_ = (positions.replicate(1, 5) - positions.transpose().replicate(5, 1)).cwiseAbs();
    DistanceMatrix perfect(5, 5);
    for (int i = 0; i < 5; ++i) {
      for (int j = 0; j < 5; ++j) perfect(i, j) = i == j ? 0 : labels_[i] == labels_[j] ? 1 + i + j : 100 + i + j;
    }
    for (std::size_t i = 0; i < names_.size(); ++i) {
      results_.models.push_back({.id = names_[i], .file = at("T" + names_[i] + ".off"), .label = labels_[i]});
      ModelDescription& shape = results_.shapes.emplace_back();
      shape.area = 2.0 + static_cast<double>(i);
      shape.features = {{}, {.features = {}, .seconds = 0.25 * static_cast<double>(i)}};
    }
    add("line", line_);
    add("perfect/2", perfect);
    results_.methods[1].signatures = features_;
  }

  void add(const std::string& name, const DistanceMatrix& distances) {
    EvaluationOptions options;
    options.measures = results_.configuration.evaluation.measures;
    MethodResults& method = results_.methods.emplace_back();
    method.name = name;
    method.distances = distances;
    method.evaluations = {evaluate(distances, labels_, options)};
  }
  [[nodiscard]] std::filesystem::path out(const std::string& name) const { return folder_.path() / "out" / name; }
  void write() const { test::publish(at("out"), results_); }
  std::vector<std::string> names_{"0", "1", "2", "3", "4"};
  std::vector<int> labels_{0, 0, 0, 1, 1};
  DistanceMatrix line_;
  Signatures features_ = Signatures::Random(5, 7);
  ExperimentResults results_;
};

TEST_F(WriteResults, SummaryHasTheAveragesOfEachMethodInPercent) {
  write();
  const auto of = [&](const char* method, const char* average) {
    return test::csv_numbers(test::csv_record(out("summary.csv"), {{"method", method}, {"average", average}}),
                             {"NN", "FT"});
  };
  EXPECT_THAT(of("line", "micro"), Pointwise(DoubleNear(1e-4), {80.0, 70.0}));
  EXPECT_THAT(of("line", "macro"), Pointwise(DoubleNear(1e-4), {75.0, 200.0 / 3}));
  EXPECT_THAT(of("perfect/2", "micro"), ElementsAre(100, 100));
  const auto json = nlohmann::json::parse(test::text_of(out("summary.json")));
  EXPECT_EQ(json.at("name"), "by hand");
  ASSERT_EQ(json.at("rows").size(), 4U);
  EXPECT_NEAR(json["rows"][0].at("FT").get<double>(), 70, 1e-12);
  EXPECT_EQ(json["rows"][1].at("average"), "macro");
  EXPECT_NEAR(json["rows"][1].at("NN").get<double>(), 75, 1e-12);
  const auto interval = json["rows"][0].at("intervals").at("FT");
  EXPECT_LT(interval[0], 70);
  EXPECT_GT(interval[1], 70);
}

TEST_F(WriteResults, WritesScoresPerClassAndQuery) {
  write();
  const auto of_class = test::csv_record(out("per_class.csv"), {{"method", "line"}, {"class", "a"}});
  EXPECT_EQ(of_class.at("queries"), "3");
  EXPECT_NEAR(std::stod(of_class.at("FT")), 250.0 / 3, 1e-4);
  const std::vector<double> first_tiers{100, 100, 50, 0, 100};
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const auto query = test::csv_record(out("per_query.csv"), {{"method", "line"}, {"id", names_[i]}});
    EXPECT_EQ(query.at("class"), labels_[i] == 0 ? "a" : "b");
    EXPECT_EQ(std::stod(query.at("FT")), first_tiers[i]) << i;
  }
  for (const auto& level : test::csv_records(out("pr_curves.csv"))) {
    if (level.at("method") == "line") continue;
    EXPECT_THAT(test::csv_numbers(level, {"precision", "macro_precision"}), ElementsAre(1, 1));
  }
  const auto shown =
      test::csv_record(out("intervals.csv"), {{"method", "line"}, {"average", "macro"}, {"measure", "NN"}});
  EXPECT_THAT(test::csv_numbers(shown, {"value"}), ElementsAre(75));
  EXPECT_LT(std::stod(shown.at("low")), 75);
}

TEST_F(WriteResults, WritesDistancesAndFeaturesOfTheMethods) {
  write();
  EXPECT_EQ(parse_npy(test::text_of(out("distances/line.npy")), "distances/line.npy", TableShape::square), line_);
  EXPECT_EQ(parse_npy(test::text_of(out("distances/perfect_2.npy")), "distances/perfect_2.npy", TableShape::square),
            results_.methods[1].distances);
  EXPECT_EQ(parse_npy(test::text_of(out("features/perfect_2.npy")), "features", TableShape::any),
            features_.cast<double>());
  EXPECT_FALSE(std::filesystem::exists(out("features/line.npy"))) << "a histogram is no descriptor";
  for (const char* ids : {"distances/ids.txt", "features/ids.txt"})
    EXPECT_EQ(test::text_of(out(ids)), "0\n1\n2\n3\n4\n");
}

TEST_F(WriteResults, WritesNoDistancesIfDisabled) {
  results_.configuration.keep_distances = false;
  write();
  EXPECT_FALSE(std::filesystem::exists(out("distances")));
  const auto manifest = nlohmann::json::parse(test::text_of(out("manifest.json")));
  for (const std::string file : manifest.at("files")) {
    EXPECT_TRUE(std::filesystem::exists(out(file))) << file;
    EXPECT_FALSE(file.starts_with("distances")) << file;
  }
}

TEST_F(WriteResults, ListsShapesWithClassAreaAndRunTime) {
  results_.failures.push_back({.id = "7", .message = "it is broken", .file = at("absent.off")});
  write();
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const auto shape = test::csv_record(out("shapes.csv"), {{"id", names_[i]}});
    EXPECT_EQ(shape.at("class"), labels_[i] == 0 ? "a" : "b");
    EXPECT_EQ(std::stod(shape.at("area scaled to 1")), results_.shapes[i].area);
    const auto seconds = test::csv_record(out("shape_seconds.csv"), {{"id", names_[i]}});
    EXPECT_EQ(std::stod(seconds.at("perfect/2")), 0.25 * static_cast<double>(i));
  }
  const auto manifest = nlohmann::json::parse(test::text_of(out("manifest.json")));
  EXPECT_EQ(manifest.at("models"), 5);
  ASSERT_EQ(manifest.at("failed_models").size(), 1U);
  EXPECT_EQ(manifest["failed_models"][0].at("model"), "7");
  EXPECT_EQ(manifest["failed_models"][0].at("error"), "it is broken");
}

}  // namespace

}  // namespace shapegauge
