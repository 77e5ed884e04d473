// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/field_settings.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using testing::Eq;
using testing::HasSubstr;
using Json = nlohmann::json;

Json experiment_document() {
  return Json::parse(R"({
    "name": "x",
    "dataset": {"layout": "shrec11", "root": "data"},
    "signatures": [
      {"name": "a", "field": {"type": "offset_sdf", "offset": 0.05}, "histogram": {"range": "dataset"}},
      {"name": "b", "field": {"type": "cone_sdf"}, "histogram": {"bins": 40, "range": {"fixed": [0, 0.6]}}},
      {"name": "c", "concatenate": ["d", "a"]},
      {"name": "d", "concatenate": ["b"]}
    ]})");
}

Configuration configuration_with(const std::string& pointer, const Json& value) {
  Json changed = experiment_document();
  changed[Json::json_pointer(pointer)] = value;
  return configuration_from_json(changed, "x.json", "/configs");
}

std::string experiment_error_with(const std::string& pointer, const Json& value) {
  return test::input_error_of([&] { configuration_with(pointer, value); });
}

TEST(ExperimentConfiguration, UsesTheMeasuresOfItsProtocolsByDefault) {
  const auto names_under = [](const char* protocol) {
    std::vector<std::string> names;
    for (const Measure& measure : configuration_with("/protocol", protocol).evaluation.measures)
      names.push_back(measure.name);
    return names;
  };
  EXPECT_THAT(names_under("psb"), testing::Contains("FT"));
  EXPECT_THAT(names_under("psb"), testing::Not(testing::Contains("nDCG")));
  EXPECT_THAT(names_under("trec"), testing::Contains("nDCG"));
}

TEST(ExperimentConfiguration, WritesAbsolutePaths) {
  Json document = experiment_document();
  document["dataset"]["root"] = "../data";
  const Json written = to_json(configuration_from_json(document, "x.json", "configs/mine"));
  const std::filesystem::path here = std::filesystem::current_path();
  EXPECT_EQ(written["dataset"]["root"], (here / "configs/data").string());
  EXPECT_TRUE(written["dataset"]["classification"].get<std::string>().starts_with((here / "configs/data/").string()));
}

TEST(ExperimentConfiguration, AcceptsShortFormsOfSettings) {
  const auto with = [](const char* defaults, const char* signatures) {
    Json document = experiment_document();
    document["defaults"] = Json::parse(defaults);
    document["signatures"] = Json::parse(signatures);
    return to_json(configuration_from_json(document, "x.json", "/configs"));
  };
  EXPECT_EQ(with(R"({"at": {"surface": 500}})",
                 R"([{"name": "a", "field": "cone_sdf", "histogram": {"range": [0, 0.6]}},
                     {"name": "b", "descriptor": "light_field"},
                     {"name": "c", "descriptor": {"type": "joint_histogram", "fields": [
                       {"type": "cone_sdf"}, {"type": "centricity"}]}},
                     {"name": "d", "field": {"type": "cone_sdf", "at": "vertices"}, "histogram": {"range": "dataset"}},
                     {"name": "e", "sum": ["a", {"of": "b", "weight": 2}]}])"),
            with("{}",
                 R"([{"name": "a", "field": {"type": "cone_sdf", "at": {"surface": 500}},
                      "histogram": {"range": {"fixed": [0, 0.6]}}},
                     {"name": "b", "descriptor": {"type": "light_field"}},
                     {"name": "c", "descriptor": {"type": "joint_histogram", "fields": [
                       {"type": "cone_sdf", "at": {"surface": 500}}, {"type": "centricity", "at": {"surface": 500}}]}},
                     {"name": "d", "field": {"type": "cone_sdf", "at": "vertices"}, "histogram": {"range": "dataset"}},
                     {"name": "e", "sum": [{"of": "a"}, {"of": "b", "weight": 2}]}])"));
  const std::vector<std::pair<std::string, Json>> mistakes{{"/signatures/0/field", "cone"},
                                                           {"/signatures/0/field", "offset_sdf"},
                                                           {"/signatures/1/histogram/range", Json::array({1, 0})},
                                                           {"/defaults", Json{{"at", "edges"}}},
                                                           {"/defaults", Json{{"bins", 3}}},
                                                           {"/defaults", 3}};
  for (const auto& [pointer, value] : mistakes) EXPECT_NE(experiment_error_with(pointer, value), "no error") << pointer;
}

TEST(ExperimentConfiguration, AcceptsSmoothingAsWideAsTheHistogram) {
  EXPECT_EQ(
      configuration_with("/signatures/1/histogram/smoothing_bins", 40).signatures[1].histogram.options.smoothing_bins,
      40);
}

TEST(ExperimentConfiguration, FillsInDefaultsOfOmittedSettings) {
  const Configuration configuration = configuration_from_json(experiment_document(), "x.json", "/configs");
  EXPECT_EQ(configuration.protocols, std::vector{Protocol::psb});
  EXPECT_EQ(configuration.evaluation.minimum_class_size, 2);
  EXPECT_EQ(configuration.evaluation.ties, Ties::index);
  EXPECT_EQ(configuration.evaluation.measures.size(), 6U);
  EXPECT_EQ(configuration.on_error, OnError::stop);
  EXPECT_EQ(configuration.distance, "l1");
  EXPECT_EQ(configuration.seed, 1U);
  EXPECT_TRUE(configuration.perturbations.empty());
  EXPECT_EQ(configuration.signatures[0].histogram.options.bins, 80);
  EXPECT_EQ(configuration.signatures[0].histogram.range, HistogramRange::dataset);
  EXPECT_EQ(configuration.signatures[1].histogram.range, HistogramRange::fixed);
  EXPECT_EQ(configuration.signatures[1].histogram.fixed.high, 0.6);
  EXPECT_EQ(to_json(configuration.signatures[1].field->settings),
            Json::parse(R"({"type": "cone_sdf", "engine": "embree", "opening_angle_degrees": 60.0, "rays": 25,
                            "postprocess": false, "at": "faces"})"));
  EXPECT_EQ(configuration.location->classification, "/configs/data/test.cla");
}

TEST(ExperimentConfiguration, IsReadBackFromJsonAsWritten) {
  Json full = experiment_document();
  full["protocol"] = {"paper", "psb"};
  full["on_error"] = "skip";
  full["report"]["pictures"] = {{"of", "b"}, {"range", {0, 0.25}}};
  full["report"]["views"] = false;
  full["report"]["up"] = "-x";
  full["evaluation"] = {{"minimum_class_size", 3}, {"ties", "expected"}, {"measures", {"P@10", "FT"}}};
  full["description"] = "why";
  full["seed"] = 7;
  full["perturbations"] = Json::parse(R"([
    {"type": "motion"},
    {"type": "one_of", "choices": [[], [{"type": "holes"}, {"type": "one_of", "choices": [[{"type": "decimate", "faces": 9}]]}]]}
  ])");
  const Json filled = to_json(configuration_from_json(full, "x.json", "/configs"));
  EXPECT_EQ(filled["report"], full["report"]);
  EXPECT_EQ(to_json(configuration_from_json(filled, "again.json", "/elsewhere")), filled);
  EXPECT_EQ(filled["evaluation"]["minimum_class_size"], 3);
  EXPECT_EQ(filled["evaluation"]["ties"], "expected");
  EXPECT_EQ(filled["evaluation"]["measures"], Json::parse(R"(["P@10", "FT"])"));
  EXPECT_EQ(filled["seed"], 7);
  EXPECT_EQ(filled["perturbations"][1]["choices"][1][0]["radius"], 0.05);
  EXPECT_EQ(filled["protocol"], Json::parse(R"(["paper", "psb"])"));
}

TEST(ExperimentConfiguration, ResolvesTheRootAgainstTheConfigurationFolderAndClassesAgainstTheRoot) {
  setenv("SHAPEGAUGE_TEST_ROOT", "/data/shapes", 1);
  const auto absolute = configuration_with("/dataset/root", "${SHAPEGAUGE_TEST_ROOT}");
  EXPECT_EQ(absolute.location->root, "/data/shapes");
  const auto elsewhere = configuration_with("/dataset/classification", "../labels/all.cla");
  EXPECT_EQ(elsewhere.location->classification, "/configs/labels/all.cla");
  EXPECT_EQ(configuration_with("/dataset/layout", "csv").location->classification, "/configs/data/models.csv");
}

TEST(ExperimentConfiguration, ComputesInputsBeforeDerivedSignatures) {
  const Configuration configuration = configuration_from_json(experiment_document(), "x.json", ".");
  EXPECT_EQ(computation_order(configuration.signatures), (std::vector<std::size_t>{0, 1, 3, 2}));
}

TEST(ExperimentConfiguration, ErrorsNameTheLocationInTheDocument) {
  unsetenv("SHAPEGAUGE_TEST_UNSET");
  const auto json = [](const char* text) { return Json::parse(text); };
  const std::vector<std::tuple<const char*, Json, const char*>> mistakes = {
      {"/evaluation", {{"measures", {"FT", "P@x"}}}, "evaluation.measures: the measure \"P@x\""},
      {"/evaluation", {{"ties", "expect"}}, "expected"},
      {"/perturbations", json(R"([{"type": "motion"}, {"type": "vertex_nois"}])"),
       "perturbations.1.type: unknown word"},
      {"/perturbations", json(R"([{"type": "holes", "radios": 0.1}])"), "perturbations.0: unknown key \"radios\""},
      {"/perturbations", json(R"([{"type": "one_of", "choices": [[], [{"type": "decimate"}]]}])"),
       "perturbations.0.choices.1.0: the key \"faces\""},
      {"/perturbations", json(R"([{"type": "one_of", "assign": "inturn", "choices": [[]]}])"),
       "perturbations.0.assign: "},
      {"/perturbations", json(R"([{"type": "remove_faces", "fraction": 2}])"), "perturbations.0.fraction: "},
      {"/dataset/root", "${SHAPEGAUGE_TEST_UNSET}", "dataset.root: the environment variable SHAPEGAUGE_TEST_UNSET"},
      {"/signatures/2/concatenate",
       {"b", "A"},
       "signatures.2.concatenate.1: there is no signature \"A\"; did you mean"},
      {"/signatures/3/concatenate", {"c"}, "refers to itself"},
      {"/signatures/3/concatenate", {"d"}, "signatures.3.concatenate: the signature \"d\" refers to itself"},
      {"/signatures/1/name", "a", "signatures.1.name: the name \"a\""},
      {"/signatures/1/field/postprocess", true, "signatures.1.field: \"postprocess\" needs"},
      {"/signatures/1/field", json(R"({"type": "cone_sdf", "engine": "cgal", "at": "vertices"})"), "faces only"},
      {"/signatures/1/histogram/range/fixed", {0.6, 0.6}, "signatures.1.histogram.range.fixed: the first value"},
      {"/signatures/1/histogram/range/fixed", {-1e308, 1e308}, "signatures.1.histogram.range.fixed: the values"},
      {"/signatures/1/histogram/smoothing_bins", 41, "signatures.1.histogram.smoothing_bins: "},
      {"/signatures/2/field", json(R"({"type": "cone_sdf"})"), "signatures.2.field: cannot be combined"},
      {"/dataset/generate", Json::object(), "cannot be combined with \"generate\""},
      {"/dataset/split", "train", "dataset.split: the layout \"shrec11\""},
      {"/dataset", json(R"({"layout": "folders", "root": "x", "classification": "y"})"), "dataset.classification: "},
      {"/dataset", json(R"({"generate": {"classes": 1000}})"), "dataset.generate.classes: must be from 1 to 28"},
      {"/report/pictures/of", "bb", "report.pictures.of: there is no signature \"bb\""},
      {"/report/pictures/of", "c", "report.pictures.of: the signature \"c\" has no field"},
      {"/report/pictures/range", {0.2, 0.2}, "report.pictures.range: the first value"},
      {"/report/picture", true, "pictures"},
      {"/report", "yes", "report: "}};
  for (const auto& [pointer, value, word] : mistakes) {
    EXPECT_THAT(experiment_error_with(pointer, value), HasSubstr(word)) << pointer << " = " << value;
  }
}

TEST(ExperimentConfiguration, ShowsTheFirstFieldInReportsByDefault) {
  const ReportConfiguration report = configuration_from_json(experiment_document(), "x.json", "/configs").report;
  EXPECT_TRUE(report.enabled && report.pictures);
  EXPECT_EQ(report.pictured_signature, 0U);
  EXPECT_EQ(report.picture_options.range.low, 0);
  EXPECT_NEAR(report.picture_options.range.high, 0.5641896, 1e-7) << "the diameter of a sphere of unit area";
  EXPECT_FALSE(configuration_with("/report", false).report.enabled);
  EXPECT_FALSE(configuration_with("/report", false).report.pictures);
  const ReportConfiguration plain = configuration_with("/report/pictures", false).report;
  EXPECT_TRUE(plain.enabled && !plain.pictures);
  const Json chosen = {{"of", "b"}, {"range", {0.1, 0.2}}};
  const ReportConfiguration other = configuration_with("/report/pictures", chosen).report;
  EXPECT_EQ(other.pictured_signature, 1U);
  EXPECT_EQ(other.picture_options.range.high, 0.2);
}

TEST(ReadConfiguration, AppliesOverridesBeforeChecking) {
  const test::TemporaryFolder folder;
  const auto path = folder.file("x.json", experiment_document().dump());
  const std::vector<std::string> overrides{"signatures.0.histogram.bins=7", "name=other"};
  const Configuration configuration = read_configuration(path, overrides);
  EXPECT_EQ(configuration.signatures[0].histogram.options.bins, 7);
  EXPECT_EQ(configuration.name, "other");
  EXPECT_EQ(configuration.location->root, folder.path() / "data");
  const std::vector<std::string> wrong{"signatures.0.histogram.bin=7"};
  EXPECT_THAT(test::input_error_of([&] { read_configuration(path, wrong); }),
              Eq(path.string() + ": signatures.0.histogram: unknown key \"bin\"; did you mean \"bins\"?"));
}

TEST(ReadConfiguration, ResolvesPathsOfOverridesAgainstTheWorkingDirectory) {
  namespace fs = std::filesystem;
  const test::TemporaryFolder folder;
  const auto path = folder.file("x.json", experiment_document().dump());
  const auto location = [&](const std::vector<std::string>& overrides) {
    return read_configuration(path, overrides).location.value();
  };
  const fs::path here = fs::current_path();
  EXPECT_EQ(location({}).root, folder.path() / "data");
  EXPECT_EQ(location({"name=x"}).root, folder.path() / "data");
  EXPECT_EQ(location({"dataset.root=data"}).root, here / "data");
  EXPECT_EQ(location({"dataset.root=../models"}).root, here.parent_path() / "models");
  EXPECT_EQ(location({"dataset.root=/models"}).root, "/models");
  EXPECT_EQ(location({R"(dataset={"layout":"folders","root":"m"})"}).root, here / "m");
  EXPECT_EQ(location({"dataset.root=m", "dataset.classification=c.cla"}).classification, here / "m/c.cla");
  EXPECT_EQ(location({"dataset.classification=c.cla"}).classification, folder.path() / "data/c.cla");
  setenv("SHAPEGAUGE_TEST_ROOT", "/elsewhere", 1);
  EXPECT_EQ(location({"dataset.root=${SHAPEGAUGE_TEST_ROOT}/m"}).root, "/elsewhere/m");
}

TEST(ApplyOverrides, ResolvesPathsAgainstTheWorkingDirectory) {
  const std::string here = std::filesystem::current_path().string();
  auto document = nlohmann::json::parse(
      R"({"datasets": [{"name": "a", "layout": "csv", "root": "x"}, {"name": "b", "layout": "csv", "root": "x"}],
          "shapes": [{"name": "s", "file": "x.off", "root": "x"}]})");
  const std::vector<std::string> overrides{"datasets[b].root=y", "shapes.0.file=s.off", "shapes.0.root=y",
                                           "shapes.0.name=t"};
  const auto paths = [](const Json&) {
    return DocumentPaths{.files = {"/shapes/*/file"}, .datasets = {"/datasets/*"}};
  };
  apply_overrides(document, "x.json", "/folder", overrides, paths);
  EXPECT_EQ(document["datasets"][0]["root"], "x");
  EXPECT_EQ(document["datasets"][1]["root"], here + "/y");
  EXPECT_EQ(document["shapes"][0]["file"], here + "/s.off");
  EXPECT_EQ(document["shapes"][0]["root"], "y");
  EXPECT_EQ(document["shapes"][0]["name"], "t");
}

}  // namespace

}  // namespace shapegauge
