// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/engine/manifest.h"
#include "shapegauge/experiments/engine/replay.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

DocumentPaths paths(const Json& /*document*/) {
  return {.files = {"/shapes/*/file"}, .datasets = {"/dataset", "/datasets/*"}};
}

TEST(ManifestReplay, RejectsIncompleteManifests) {
  const test::TemporaryFolder folder;
  const auto error_for = [&](const std::string& text) {
    test::write_text(folder.path() / "m.json", text);
    return test::input_error_of([&] { read_manifest(folder.path() / "m.json"); });
  };
  EXPECT_EQ(error_for(R"({"configuration": {}, "inputs": {}, "outputs": {"files": {}}})"), "no error");
  EXPECT_THAT(error_for("[]"), HasSubstr("m.json: missing \"configuration\""));
  EXPECT_THAT(error_for(R"({"configuration": {}, "inputs": {}})"), HasSubstr("m.json: missing \"outputs\""));
  EXPECT_THAT(error_for(R"({"configuration": 1, "inputs": {}, "outputs": {}})"), HasSubstr("manifest.json"));
  EXPECT_THAT(error_for("{"), HasSubstr("m.json"));
  EXPECT_THAT(test::input_error_of([] { read_manifest("/nowhere/manifest.json"); }), HasSubstr("no such file"));
}

TEST(ManifestReplay, RejectsManifestEntriesOfTheWrongTypeNamingTheirLocation) {
  const test::TemporaryFolder folder;
  const auto error_for = [&](const Json& inputs, const Json& outputs, const Json& failed = Json::array()) {
    const Json manifest{
        {"configuration", Json::object()}, {"inputs", inputs}, {"outputs", outputs}, {"failed_models", failed}};
    test::write_text(folder.path() / "m.json", manifest.dump());
    return test::input_error_of([&] { read_manifest(folder.path() / "m.json"); });
  };
  const Json files{{"files", {{"a.csv", "aa"}}}};
  EXPECT_EQ(error_for({{"models", {{"1", "aa"}}}, {"classification", "bb"}}, files), "no error");
  EXPECT_THAT(error_for({{"models", 5}}, files), HasSubstr("m.json: inputs.models: expected the hash of each model"));
  EXPECT_THAT(error_for({{"shapes", {{"cat", 5}}}}, files), HasSubstr("m.json: inputs.shapes: expected"));
  EXPECT_THAT(error_for({{"classification", {"aa"}}}, files), HasSubstr("m.json: inputs.classification: expected"));
  EXPECT_THAT(error_for(Json::object(), Json::object()), HasSubstr("m.json: outputs.files: expected"));
  EXPECT_THAT(error_for(Json::object(), {{"files", {{"a.csv", 1}}}}), HasSubstr("m.json: outputs.files: expected"));
  EXPECT_EQ(error_for(Json::object(), files, Json::array({{{"model", "1"}, {"error", "x"}}})), "no error");
  EXPECT_THAT(error_for(Json::object(), files, Json::array({5})), HasSubstr("m.json: failed_models: expected"));
}

TEST(ManifestReplay, AcceptsAnotherFolderOfTheDataSet) {
  Json manifest{
      {"configuration",
       {{"dataset", {{"layout", "shrec11"}, {"root", "/old/data"}, {"classification", "/old/data/a/test.cla"}}}}}};
  EXPECT_EQ(recorded_configuration(manifest, "", paths), manifest["configuration"]);
  Json moved = recorded_configuration(manifest, "/new/place", paths)["dataset"];
  EXPECT_EQ(moved["root"], "/new/place");
  EXPECT_EQ(moved["classification"], "/new/place/a/test.cla");
  manifest["configuration"]["dataset"]["classification"] = "/old/database/test.cla";
  moved = recorded_configuration(manifest, "/new/place", paths)["dataset"];
  EXPECT_EQ(moved["classification"], "/old/database/test.cla") << "it did not lie in the data set's folder";
}

TEST(ManifestReplay, AcceptsAnotherFolderOfComparedShapes) {
  const Json manifest{{"configuration",
                       {{"shapes",
                         {{{"name", "a"}, {"file", "/old/models/animals/cat.off"}},
                          {{"name", "b"}, {"file", "/old/models/fertility.off"}},
                          {{"name", "c"}, {"generate", {{"class", "horse"}}}}}}}}};
  const Json shapes = recorded_configuration(manifest, "/new", paths)["shapes"];
  EXPECT_EQ(shapes[0]["file"], "/new/animals/cat.off");
  EXPECT_EQ(shapes[1]["file"], "/new/fertility.off");
  EXPECT_FALSE(shapes[2].contains("file"));
}

TEST(ManifestReplay, RejectsPathsThatAreNotStringsWithTheirLocation) {
  const auto error_of = [](const Json& configuration) {
    return test::input_error_of([&] { recorded_configuration({{"configuration", configuration}}, "/new", paths); });
  };
  EXPECT_THAT(error_of({{"dataset", {{"root", 5}}}}), HasSubstr("configuration.dataset.root"));
  EXPECT_THAT(error_of({{"dataset", {{"root", "/old"}, {"classification", Json::array()}}}}),
              HasSubstr("configuration.dataset.classification"));
  EXPECT_THAT(error_of({{"shapes", {{{"name", "a"}, {"file", false}}}}}), HasSubstr("configuration.shapes.0.file"));
}

TEST(ManifestReplay, RejectsADataSetFolderForGeneratedData) {
  const Json dataset{{"configuration", {{"dataset", {{"generate", Json::object()}}}}}};
  EXPECT_THAT(test::input_error_of([&] { recorded_configuration(dataset, "/new", paths); }),
              HasSubstr("`dataset_root`"));
  const Json shapes{{"configuration", {{"shapes", {{{"name", "a"}, {"generate", Json::object()}}}}}}};
  EXPECT_THAT(test::input_error_of([&] { recorded_configuration(shapes, "/new", paths); }),
              HasSubstr("`dataset_root`"));
}

TEST(ManifestReplay, AcceptsAnotherFolderOnlyIfOneDataSetIsOnDisk) {
  Json manifest{{"configuration",
                 {{"datasets", {{{"name", "a"}, {"generate", Json::object()}}, {{"name", "b"}, {"root", "/old/b"}}}}}}};
  EXPECT_EQ(recorded_configuration(manifest, "/new", paths)["datasets"][1]["root"], "/new");
  manifest["configuration"]["datasets"].push_back({{"name", "c"}, {"root", "/old/c"}});
  EXPECT_THAT(test::input_error_of([&] { recorded_configuration(manifest, "/new", paths); }),
              HasSubstr("datasets.1.root=FOLDER"));
}

TEST(ManifestReplay, NamesChangedInputs) {
  const Json recorded{
      {"inputs",
       {{"algorithm", "SHA-256"}, {"models", {{"1", "aa"}, {"2", "bb"}, {"3", "cc"}}}, {"classification", "dd"}}}};
  EXPECT_THAT(changed_inputs(recorded, recorded.at("inputs")), IsEmpty());
  const Json now{{"models", {{"1", "aa"}, {"2", "xx"}, {"4", "ee"}}}, {"classification", "yy"}};
  EXPECT_THAT(changed_inputs(recorded, now),
              ElementsAre("model 2 differs from the recorded one", "model 3 is absent",
                          "the classification differs from the recorded one", "model 4 was not recorded"));
  EXPECT_THAT(changed_inputs({{"inputs", {{"shapes", {{"cat", "aa"}}}}}}, {{"shapes", Json::object()}}),
              ElementsAre("shape cat is absent"));
}

TEST(ManifestReplay, IgnoresKindsOfInputsThatTheManifestDoesNotRecord) {
  const Json inputs{{"models", {{"1", "aa"}}}};
  const Json recorded{{"inputs", inputs}};
  EXPECT_THAT(changed_inputs(recorded, {{"models", {{"1", "aa"}}}, {"classification", "dd"}}), IsEmpty());
  EXPECT_THAT(changed_inputs(recorded, {{"models", {{"1", "aa"}, {"2", "bb"}}}, {"classification", "dd"}}),
              ElementsAre("model 2 was not recorded"));
  EXPECT_THAT(changed_inputs({{"inputs", {{"models", {{"1", "aa"}}}, {"classification", "dd"}}}}, inputs),
              ElementsAre("the classification is absent"));
}

TEST(ManifestReplay, SummarisesUnrecordedFilesOfFailedModels) {
  const Json recorded{{"inputs", {{"models", {{"1", "aa"}}}}},
                      {"failed_models", {{{"model", "2"}, {"error", "x"}}, {{"model", "3"}, {"error", "x"}}}}};
  const Json now{{"models", {{"1", "aa"}, {"2", "bb"}, {"2/a.seg", "cc"}, {"20", "dd"}, {"3", "ee"}}}};
  EXPECT_THAT(changed_inputs(recorded, now),
              ElementsAre("model 20 was not recorded",
                          "the files of 2 models that failed in the recorded run were not recorded"));
}

TEST(ManifestReplay, ReportsADifferentProgramVersionOrProcessor) {
  Json manifest = program_json();
  EXPECT_THAT(changed_program(manifest), IsEmpty());
  manifest["shapegauge"] = "0.0.0";
  manifest.erase("processor");
  EXPECT_THAT(changed_program(manifest),
              testing::UnorderedElementsAre(testing::MatchesRegex("shapegauge: .*, recorded was \"0\\.0\\.0\""),
                                            testing::MatchesRegex("processor: .*, recorded was \"unknown\"")));
}

TEST(ManifestReplay, ComparesOutputsByHash) {
  const Json recorded{{"outputs", {{"files", {{"a.csv", "1"}, {"b.csv", "2"}, {"c.csv", "3"}}}}}};
  const Json now{{"outputs", {{"files", {{"a.csv", "1"}, {"b.csv", "x"}}}}},
                 {"files", {"a.csv", "b.csv", "shape_seconds.csv"}}};
  const ComparedOutputs outputs = compare_outputs(recorded, now);
  EXPECT_THAT(outputs.same, ElementsAre("a.csv"));
  EXPECT_THAT(outputs.different, ElementsAre("b.csv", "c.csv"));
  EXPECT_THAT(outputs.timings, ElementsAre("shape_seconds.csv"));
}

}  // namespace

}  // namespace shapegauge
