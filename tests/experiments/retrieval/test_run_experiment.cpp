// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <map>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/datasets/files/csv.h"
#include "shapegauge/experiments/cache/cache_folder.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/retrieval/run_experiment.h"
#include "tests/experiments/retrieval/published_retrieval.h"
#include "tests/support/page_text.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using test::text_of;
using test::write_text;
using testing::AllOf;
using testing::HasSubstr;
using Json = nlohmann::json;

class RunExperiment : public test::FolderTest {
 protected:
  void SetUp() override { test::write_small_dataset(data()); }

  [[nodiscard]] fs::path data() const { return at("data"); }

  [[nodiscard]] Configuration configuration(const Json& changes = Json::object()) const {
    Json document = test::small_configuration(data());
    document.merge_patch(changes);
    return configuration_from_json(document, "test.json", folder_.path());
  }
  [[nodiscard]] ExperimentResults run(const Json& changes = Json::object(), int threads = 2) const {
    return run_experiment(configuration(changes), at("generated"), {.threads = threads});
  }
};

TEST_F(RunExperiment, RetrievesClearlyDifferentClassesPerfectly) {
  const ExperimentResults results = run();
  ASSERT_EQ(results.methods.size(), 4U);
  const Evaluation& psb = results.methods[0].evaluations.at(0);
  EXPECT_EQ(psb.protocol, Protocol::psb);
  EXPECT_EQ(psb.queries.size(), 9U);
  EXPECT_DOUBLE_EQ(psb.micro[0], 1) << "NN";
  EXPECT_DOUBLE_EQ(psb.micro[1], 1) << "FT";
  // E: all 8 other models are within the first 32, 2 of them relevant: 2 * 2 / (8 + 2).
  EXPECT_DOUBLE_EQ(psb.micro[3], 0.4) << "E";
  EXPECT_EQ(results.methods[0].evaluations.at(1).protocol, Protocol::paper);
  EXPECT_TRUE(results.failures.empty());
}

TEST_F(RunExperiment, RetrievesClassesOfPointCloudsPerfectly) {
  for (int i = 0; i < 9; ++i) {
    const fs::path file = data() / fmt::format("T{}.off", i);
    write_off(file, test::random_points(read_shape(file), 1500, static_cast<std::uint64_t>(i)));
  }
  const Json histogram{{"bins", 20}, {"range", {{"fixed", {0, 0.6}}}}};
  const auto signature = [&](const char* site) {
    return Json{
        {"name", site}, {"field", {{"type", "offset_sdf"}, {"offset", 0.08}, {"at", site}}}, {"histogram", histogram}};
  };
  const ExperimentResults results = run({{"signatures", {signature("faces"), signature("vertices")}}});
  EXPECT_TRUE(results.failures.empty());
  EXPECT_DOUBLE_EQ(results.methods.at(0).evaluations.at(0).micro[0], 1) << "NN";
  EXPECT_DOUBLE_EQ(results.methods.at(0).evaluations.at(0).micro[1], 1) << "FT";
  EXPECT_EQ(results.methods.at(0).distances, results.methods.at(1).distances) << "points, whatever the site";
}

TEST_F(RunExperiment, DistancesEqualThoseOfSeparatelyComputedHistograms) {
  const ExperimentResults results = run();
  const auto histogram_of = [&](const char* name) {
    const Shape shape = prepare_shape(read_shape(data() / name), {}).shape;
    const Samples samples = sample_shape(shape, SampleSite::faces);
    const ScalarField field{.values = cone_sdf(shape, samples, {}).values, .weights = samples.weights};
    return histogram(field, {.low = 0, .high = 0.6}, {.bins = 20});
  };
  const double expected = (histogram_of("T0.off").cast<double>() - histogram_of("T4.off").cast<double>()).lpNorm<1>();
  EXPECT_NEAR(results.methods[0].distances(0, 4), expected, 1e-6);
  EXPECT_GT(expected, 0.5);
}

TEST_F(RunExperiment, ConcatenationHasTheMeanDistanceOfItsInputs) {
  const ExperimentResults results = run();
  const auto& both = results.methods[3].distances;
  const DistanceMatrix expected = (results.methods[0].distances + results.methods[1].distances) / 2;
  EXPECT_TRUE(both.isApprox(expected, 1e-5));
}

TEST_F(RunExperiment, HistogramRangeOfTheDataSetEnclosesTheValuesOfAllShapes) {
  // With the range fixed to that of the data set, signatures agree to single precision.
  const ExperimentResults results = run();
  Interval range{.low = 1e9, .high = -1e9};
  for (const Model& model : results.models) {
    const Shape shape = prepare_shape(read_shape(model.file), {}).shape;
    const Samples samples = sample_shape(shape, SampleSite::faces);
    const Eigen::VectorXd values = cone_sdf(shape, samples, {}).values;
    range = {.low = std::min(range.low, values.minCoeff()), .high = std::max(range.high, values.maxCoeff())};
  }
  Json document = test::small_configuration(data());
  document["signatures"][0]["histogram"]["range"]["fixed"] = {range.low, range.high};
  const ExperimentResults fixed =
      run_experiment(configuration_from_json(document, "test.json", "."), at("generated"), {.threads = 1});
  EXPECT_TRUE(fixed.methods[0].distances.isApprox(results.methods[2].distances, 0.02));
}

TEST_F(RunExperiment, ComputesAFieldSharedBySignaturesOnce) {
  const ExperimentResults results = run();
  ASSERT_EQ(results.fields.size(), 1U);
  std::size_t faces = 0;
  for (const Model& model : results.models) faces += static_cast<std::size_t>(read_shape(model.file).triangles.rows());
  EXPECT_EQ(results.fields[0].outcomes.at("total"), faces);
}

TEST_F(RunExperiment, WritesTheSameBytesOnAnyNumberOfThreads) {
  for (const int threads : {1, 3}) test::publish(at(std::to_string(threads)), run(Json::object(), threads));
  for (const char* file : {"summary.csv", "summary.json", "summary.md", "summary.tex", "per_class.csv", "per_query.csv",
                           "pr_curves.csv", "report.html", "shapes.csv", "distances/fixed.npy",
                           "distances/per_shape.npy", "distances/data_set.npy", "distances/both.npy"}) {
    const std::string bytes = text_of(at("1") / file);
    EXPECT_FALSE(bytes.empty()) << file;
    EXPECT_TRUE(bytes == text_of(at("3") / file)) << file;
  }
  EXPECT_THAT(text_of(at("1") / "summary.tex"), testing::Not(HasSubstr("average"))) << "both are equal in all rows";
  Json one = Json::parse(text_of(at("1") / "manifest.json"));
  Json three = Json::parse(text_of(at("3") / "manifest.json"));
  EXPECT_EQ(one["execution"]["threads"], 1);
  EXPECT_EQ(three["execution"]["threads"], 3);
  one.erase("execution");
  three.erase("execution");
  EXPECT_EQ(one, three);
}

TEST_F(RunExperiment, ReportContainsConfidenceIntervalsDistanceFunctionsAndSettings) {
  Json document = test::small_configuration(data());
  document["signatures"].push_back({{"name", "d2"}, {"descriptor", {{"type", "d2"}}}});
  document["signatures"].push_back({{"name", "Sum"}, {"sum", {{{"of", "d2"}, {"weight", 0.5}}, {{"of", "both"}}}}});
  document["perturbations"] = {{{"type", "motion"}}};
  test::publish(at("out"),
                run_experiment(configuration_from_json(document, "test.json", "."), at("generated"), {.threads = 1}));
  const Json report(test::json_of_page(text_of(at("out") / "report.html")));
  const Json row = Json::parse(text_of(at("out") / "summary.json")).at("rows")[1];
  ASSERT_EQ(row["average"], "macro");
  const Json& evaluation = report["methods"][0]["evaluations"][0];
  for (std::size_t k = 0; k < evaluation["measures"].size(); ++k) {
    const std::string measure = evaluation["measures"][k];
    EXPECT_NEAR(100 * evaluation["intervals"]["macro"][k][0].get<double>(), row["intervals"][measure][0], 1e-3);
    EXPECT_NEAR(100 * evaluation["intervals"]["macro"][k][1].get<double>(), row["intervals"][measure][1], 1e-3);
  }
  std::map<std::string, std::map<std::string, std::string>> settings;
  std::map<std::string, std::string> distance;
  for (const Json& method : report["methods"]) {
    distance[method["name"]] = method["distance"];
    for (const Json& pair : method["settings"]) settings[method["name"]][pair[0]] = pair[1];
  }
  EXPECT_EQ(distance["fixed"], "l1");
  EXPECT_EQ(distance["d2"], "l1");
  EXPECT_EQ(distance["Sum"], "sum");
  EXPECT_EQ(settings["fixed"]["type"], "cone_sdf");
  EXPECT_EQ(settings["both"]["concatenate"], "fixed + per shape");
  EXPECT_EQ(settings["Sum"]["sum"], "of d2, weight 0.5; of both, weight 1");
  EXPECT_EQ(report["perturbations"].size(), 1U);
  EXPECT_EQ(report["leaks"], Json::array());
}

TEST_F(RunExperiment, CountsAndReportsTiedDistances) {
  // One-bin histograms of all nine models are equal: all distances tie.
  const Json one_bin{{"name", "one bin"},
                     {"field", {{"type", "cone_sdf"}}},
                     {"histogram", {{"bins", 1}, {"smoothing_bins", 0}, {"range", "dataset"}}}};
  Json document = test::small_configuration(data());
  document["signatures"].push_back(one_bin);
  const ExperimentResults results =
      run_experiment(configuration_from_json(document, "test.json", "."), at("generated"), {.threads = 1});
  EXPECT_THAT(run_warnings(results),
              ElementsAre(AllOf(HasSubstr("\"one bin\": 9 of 9 queries"), HasSubstr("0.0 to 100.0 (psb)"),
                                HasSubstr("33.3 to 100.0 (paper)"))));
  test::publish(at("out"), results);
  const Json tied = Json::parse(text_of(at("out") / "summary.json")).at("tied");
  ASSERT_EQ(tied.size(), 10U) << "five methods under two protocols";
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(tied[i]["queries_with_ties"], 0) << tied[i];
  EXPECT_EQ(tied[8], (Json{{"method", "one bin"},
                           {"protocol", "psb"},
                           {"queries", 9},
                           {"queries_with_ties", 9},
                           {"FT_pessimistic", 0.0},
                           {"FT_optimistic", 100.0}}));
  EXPECT_EQ(tied[9]["queries_with_ties"], 9);
  EXPECT_THAT(text_of(at("out") / "report.html"), HasSubstr("9 of 9 queries"));
}

TEST_F(RunExperiment, StopsAtAnInvalidModelAndNamesIt) {
  write_text(data() / "T4.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n");
  const std::string message = test::input_error_of([&] { static_cast<void>(run()); });
  EXPECT_THAT(message, HasSubstr("model 4: "));
  EXPECT_THAT(message, HasSubstr("T4.off"));
  EXPECT_THAT(message, HasSubstr("\"on_error\""));
}

TEST_F(RunExperiment, SkipsEveryKindOfInvalidModelOnRequest) {
  const Json skip{{"on_error", "skip"}};
  write_text(data() / "T1.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n");  // not a number
  write_text(data() / "T2.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");    // index out of range
  write_text(data() / "T3.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");    // zero area
  write_text(data() / "T4.off", "no shape at all");                               // header
  fs::remove(data() / "T5.off");                                                  // absent
  const ExperimentResults results = run(skip);
  ASSERT_EQ(results.failures.size(), 5U);
  EXPECT_EQ(results.models.size(), 4U);
  EXPECT_EQ(results.methods[0].distances.rows(), 4);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(results.failures[i].id, std::to_string(i + 1));
  EXPECT_THAT(results.failures[2].message, HasSubstr("area"));
  EXPECT_THAT(results.failures[4].message, HasSubstr("T5.off"));
  test::publish(at("out"), results);
  EXPECT_EQ(Json::parse(text_of(at("out") / "manifest.json"))["failed_models"].size(), 5U);
}

TEST_F(RunExperiment, ReportsAMissingFileBeforeComputing) {
  fs::remove(data() / "T8.off");
  bool began = false;
  RunControl control;
  control.progress = [&](std::string_view, std::size_t, std::size_t) { began = true; };
  const std::string message = test::input_error_of([&] { run_experiment(configuration(), at("generated"), control); });
  EXPECT_THAT(message, HasSubstr("model 8: "));
  EXPECT_FALSE(began);
}

TEST_F(RunExperiment, StopsIfAllModelsAreSkipped) {
  for (int i = 0; i < 9; ++i) fs::remove(data() / ("T" + std::to_string(i) + ".off"));
  EXPECT_THAT(test::input_error_of([&] {
                static_cast<void>(run({{"on_error", "skip"}}));
              }),
              AllOf(HasSubstr("9 models"), HasSubstr("T0.off")));
}

TEST_F(RunExperiment, ExcludesTheModelOfASingletonClassFromQueries) {
  write_text(data() / "test.cla", "PSB 1\n2 4\nsphere 0 3\n0\n3\n6\nbox 0 1\n1\n");
  const ExperimentResults results = run();
  EXPECT_EQ(results.methods[0].evaluations[0].queries.size(), 3U);
  EXPECT_EQ(results.methods[0].evaluations[0].excluded_models, 1);
  EXPECT_EQ(results.methods[0].distances.rows(), 4);
}

TEST_F(RunExperiment, StopsSoonIfInterrupted) {
  std::atomic<int> asked = 0;
  std::size_t most_done = 0;
  RunControl control;
  control.threads = 1;
  control.interrupted = [&] { return ++asked > 2; };
  control.progress = [&](std::string_view, std::size_t done, std::size_t) { most_done = std::max(most_done, done); };
  EXPECT_THROW(run_experiment(configuration(), at("generated"), control), Interrupted);
  EXPECT_LE(most_done, 2U);
}

TEST_F(RunExperiment, RemovesFilesOfAnEarlierRunByItsManifest) {
  test::publish(at("out"), run());
  write_text(at("out") / "distances/mine.npy", "x");
  Json document = test::small_configuration(data());
  document["signatures"].erase(1);
  document["signatures"][2]["concatenate"] = {"fixed"};
  test::publish(at("out"), run_experiment(configuration_from_json(document, "test.json", "."), at("generated"), {}));
  EXPECT_FALSE(fs::exists(at("out") / "distances/per_shape.npy"));
  EXPECT_TRUE(fs::exists(at("out") / "distances/fixed.npy"));
  EXPECT_TRUE(fs::exists(at("out") / "distances/mine.npy"));
}

TEST_F(RunExperiment, PerturbsModelsEquallyOnAnyNumberOfThreads) {
  const Json changes = Json::parse(R"({"seed": 3, "perturbations": [
    {"type": "one_of", "assign": "in_turn", "choices": [[], [{"type": "vertex_noise", "amplitude": 0.01}]]},
    {"type": "motion", "scale": 10}]})");
  const ExperimentResults results = run(changes, 1);
  EXPECT_EQ(results.methods[0].distances, run(changes, 3).methods[0].distances);
  EXPECT_NE(results.methods[0].distances, run().methods[0].distances);
  EXPECT_NE(results.methods[0].distances,
            run({{"seed", 4}, {"perturbations", changes["perturbations"]}}).methods[0].distances);
}

TEST_F(RunExperiment, ReportsAFailedPerturbationAsAFailureOfItsModel) {
  // The second model becomes a point cloud, which cannot be decimated.
  const Json changes = Json::parse(R"({"on_error": "skip", "perturbations": [
    {"type": "one_of", "assign": "in_turn", "choices": [
      [], [{"type": "sample_points", "points": 100}, {"type": "decimate", "faces": 10}], [], [], [], [], [], [], []]}]})");
  const ExperimentResults results = run(changes);
  ASSERT_EQ(results.failures.size(), 1U);
  EXPECT_EQ(results.failures[0].id, "1");
  EXPECT_THAT(results.failures[0].message, HasSubstr("a point cloud cannot be decimated"));
}

TEST_F(RunExperiment, NotesModelsThatAreNotPerturbedAsRequested) {
  const Json changes = Json::parse(R"({"perturbations": [
    {"type": "one_of", "assign": "in_turn", "choices": [[], [{"type": "decimate", "faces": 1}], []]}]})");
  const auto notes_of = [&](const Json& with) { return test::publish(at("notes"), run(with)).notes; };
  EXPECT_THAT(notes_of(changes), testing::ElementsAre(testing::MatchesRegex(
                                     "3 of 9 models were not perturbed as requested; the first, 1: decimated to "
                                     "[0-9]+ faces instead of 1: no valid collapse is left")));
  EXPECT_THAT(notes_of(Json::object()), testing::IsEmpty());
}

TEST_F(RunExperiment, ReportsTheDiagnosticsOfPerturbedShapes) {
  const Json changes = Json::parse(R"({"perturbations": [
    {"type": "one_of", "assign": "in_turn", "choices": [[], [{"type": "remove_faces", "fraction": 0.1}]]}]})");
  test::publish(at("out"), run(changes));
  const std::vector<CsvRow> rows = parse_csv(text_of(at("out") / "shapes.csv"), "shapes.csv");
  ASSERT_EQ(rows.size(), 10U);
  const auto cell = [&](std::size_t row, const std::string& column) {
    const auto found = std::ranges::find(rows[0].cells, column);
    return found == rows[0].cells.end() ? "no such column"
                                        : rows[row].cells[static_cast<std::size_t>(found - rows[0].cells.begin())];
  };
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(cell(i + 1, "id"), std::to_string(i));
    EXPECT_EQ(cell(i + 1, "choices"), i % 2 == 0 ? "0" : "1");
    EXPECT_EQ(cell(i + 1, "closed"), i % 2 == 0 ? "true" : "false");
    EXPECT_EQ(
        cell(i + 1, "cone_sdf at=faces engine=embree opening_angle_degrees=60.0 postprocess=false rays=25: total"),
        cell(i + 1, "triangles"));
  }
  EXPECT_EQ(parse_csv(text_of(at("out") / "shape_seconds.csv"), "shape_seconds.csv").size(), 10U);
}

TEST_F(RunExperiment, ManifestListsProgramConfigurationSeedAndInputs) {
  test::publish(at("out"), run({{"seed", 5}}));
  const Json manifest = Json::parse(text_of(at("out") / "manifest.json"));
  for (const char* key : {"shapegauge", "commit", "compiler", "libraries", "configuration", "seed", "inputs"}) {
    EXPECT_TRUE(manifest.contains(key)) << key;
  }
  EXPECT_EQ(manifest["seed"], 5);
  EXPECT_EQ(manifest["configuration"]["perturbations"], Json::array());
  EXPECT_EQ(manifest["configuration"]["signatures"][0]["field"]["rays"], 25);
  EXPECT_EQ(manifest["inputs"]["models"].size(), 9U);
  EXPECT_EQ(manifest["inputs"]["models"]["0"].get<std::string>().size(), 64U);
  for (const auto& file : manifest["files"]) EXPECT_TRUE(fs::exists(at("out") / file.get<std::string>())) << file;
}

}  // namespace

}  // namespace shapegauge
