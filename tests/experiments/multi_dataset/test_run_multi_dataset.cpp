// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/engine/replay.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/multi_dataset/run_multi_dataset.h"
#include "shapegauge/experiments/retrieval/write_results.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

/// Two data sets on disk, the second with two classes only.
class RunMultiDataset : public test::FolderTest {
 protected:
  void SetUp() override {
    test::write_small_dataset(at("first"));
    test::write_small_dataset(at("second"));
    test::write_text(at("second/test.cla"), "PSB 1\n2 6\n\nsphere 0 3\n0\n3\n6\n\nbox 0 3\n1\n4\n7\n");
  }

  [[nodiscard]] Json document() const {
    Json json = test::small_configuration("first");
    json.erase("dataset");
    json["report"] = false;
    json["datasets"] = {{{"name", "First set"}, {"layout", "shrec11"}, {"root", "first"}},
                        {{"name", "second"}, {"layout", "shrec11"}, {"root", "second"}}};
    return json;
  }

  Experiment read(const Json& json) const { return multi_dataset_kind().read(json, "test.json", folder_.path()); }

  RunOutcome run(const Json& json, const std::string& output) {
    Cache none;
    return run_into_folder(read(json), at(output), false, {.threads = 1}, none);
  }

  [[nodiscard]] Json json_in(const std::string& file) const { return Json::parse(test::text_of(at(file))); }
};

TEST_F(RunMultiDataset, GivesEachDataSetTheResultsOfASingleExperiment) {
  const RunOutcome outcome = run(document(), "together");
  EXPECT_TRUE(outcome.left_out.empty());
  Json alone = document();
  alone.erase("datasets");
  alone["dataset"] = {{"layout", "shrec11"}, {"root", "second"}};
  Cache none;
  const Experiment second = retrieval_kind().read(alone, "test.json", at(""));
  (void)run_into_folder(second, at("alone"), false, {.threads = 1}, none);
  for (const char* name : {"per_query.csv", "summary.csv", "pr_curves.csv", "distances/fixed.npy"}) {
    EXPECT_EQ(test::text_of(at("together/second") / name), test::text_of(at("alone") / name)) << name;
    EXPECT_THAT(outcome.files, Contains(std::string("second/") + name));
  }
  EXPECT_TRUE(fs::exists(at("together/First_set/manifest.json")));
}

TEST_F(RunMultiDataset, RejectsDataSetsNamedLikeItsResultFiles) {
  for (const char* name : {"summary.csv", "Report.html", "pairs.csv", " manifest.json"}) {
    Json json = document();
    json["datasets"][1]["name"] = name;
    EXPECT_THAT(test::input_error_of([&] { (void)read(json); }),
                AllOf(HasSubstr("test.json: datasets.1.name"), HasSubstr(name), HasSubstr("another name")));
  }
  Json json = document();
  json["datasets"][1]["name"] = "summary";
  EXPECT_NO_THROW((void)read(json));
}

TEST_F(RunMultiDataset, TabulatesTheAverageScoresOfEachDataSet) {
  (void)run(document(), "together");
  const Json summary = json_in("together/summary.json");
  EXPECT_EQ(summary["methods"], (Json{"fixed", "per shape", "data set", "both"}));
  EXPECT_EQ(summary["tables"].size(), 2U * 2 * 6) << "protocols, averages, measures";
  for (const std::string set : {"First set", "second"}) {
    const std::string folder = file_safe_name(set);
    const Json of_set = json_in("together/" + folder + "/summary.json");
    for (const Json& row : of_set["rows"]) {
      for (const Json& table : summary["tables"]) {
        if (table["protocol"] != row["protocol"] || table["average"] != row["average"]) continue;
        const auto method =
            std::ranges::find_if(table["methods"], [&](const Json& one) { return one["method"] == row["method"]; });
        ASSERT_NE(method, table["methods"].end());
        EXPECT_NEAR((*method)["values"][set].get<double>(), row[table["measure"]].get<double>() / 100, 1e-12);
      }
    }
  }
}

TEST_F(RunMultiDataset, ExcludesUnusableDataSetsWithTheReason) {
  Json json = document();
  json["datasets"].push_back({{"name", "gone"}, {"layout", "folders"}, {"root", "nowhere"}});
  json["datasets"].push_back({{"name", "unset"}, {"layout", "folders"}, {"root", "${SHAPEGAUGE_NO_SUCH_ROOT}"}});
  const RunOutcome outcome = run(json, "some");
  ASSERT_EQ(outcome.left_out.size(), 2U);
  EXPECT_EQ(outcome.left_out[0].id, "gone");
  EXPECT_THAT(outcome.left_out[0].message, HasSubstr("nowhere"));
  EXPECT_THAT(outcome.left_out[1].message, HasSubstr("SHAPEGAUGE_NO_SUCH_ROOT"));
  const Json summary = json_in("some/summary.json");
  EXPECT_EQ(summary["failed_datasets"].size(), 2U);
  const Json failed = json_in("some/manifest.json")["failed_models"];
  ASSERT_EQ(failed.size(), 2U);
  EXPECT_EQ(failed[0], (Json{{"model", "gone"}, {"error", outcome.left_out[0].message}}));
  (void)run(document(), "good");
  EXPECT_EQ(summary["tables"], json_in("good/summary.json")["tables"]) << "the others are as without them";
}

TEST_F(RunMultiDataset, DoesNotWriteResultsIntoAnInputDataSet) {
  Json json = document();
  json["datasets"][0]["name"] = "second";
  json["datasets"][1]["name"] = "first";
  for (const char* output : {"", "first"}) {
    EXPECT_THAT(test::input_error_of([&] { run(json, output); }), HasSubstr("the results would overwrite the input"));
  }
  EXPECT_FALSE(fs::exists(at("first/manifest.json")));
  EXPECT_FALSE(fs::exists(at("second/manifest.json")));
  json["datasets"][0]["name"] = "a";
  json["datasets"][1]["name"] = "b";
  EXPECT_TRUE(run(json, "").left_out.empty()) << "a folder next to the data sets";
}

TEST_F(RunMultiDataset, FailsWithoutUsableDataSets) {
  Json json = document();
  for (Json& dataset : json["datasets"]) dataset["root"] = "nowhere";
  EXPECT_THAT(test::input_error_of([&] { run(json, "none"); }),
              testing::AllOf(HasSubstr("First set"), HasSubstr("second")));
  EXPECT_FALSE(fs::exists(at("none") / manifest_name));
  for (Json& dataset : json["datasets"]) dataset["root"] = "${SHAPEGAUGE_NO_SUCH_ROOT}";
  EXPECT_THAT(test::input_error_of([&] { read(json); }), HasSubstr("SHAPEGAUGE_NO_SUCH_ROOT"));
}

TEST_F(RunMultiDataset, NamesExcludedModelsWithTheirDataSet) {
  test::write_text(at("second/T4.off"), "OFF\nno mesh\n");
  Json json = document();
  json["on_error"] = "skip";
  const RunOutcome outcome = run(json, "skipped");
  ASSERT_EQ(outcome.left_out.size(), 1U);
  EXPECT_THAT(outcome.left_out[0].id, testing::AllOf(HasSubstr("second"), HasSubstr("4")));
  EXPECT_EQ(json_in("skipped/manifest.json")["failed_models"][0]["model"], outcome.left_out[0].id);
  json["on_error"] = "stop";
  EXPECT_EQ(run(json, "stopped").left_out[0].id, "second") << "the whole data set";
}

TEST_F(RunMultiDataset, CanBeRepeatedFromItsManifest) {
  (void)run(document(), "first-run");
  const Json recorded = read_manifest(at("first-run") / manifest_name);
  const auto paths = [](const Json&) { return multi_dataset_kind().paths; };
  const Json again = recorded_configuration(recorded, {}, paths);
  (void)run(again, "second-run");
  const Json now = read_manifest(at("second-run") / manifest_name);
  const ComparedOutputs compared = compare_outputs(recorded, now);
  EXPECT_TRUE(compared.different.empty()) << testing::PrintToString(compared.different);
  EXPECT_GT(compared.same.size(), 20U);
  EXPECT_TRUE(changed_inputs(recorded, now.at("inputs")).empty());
  EXPECT_EQ(read(document()).inputs(1), now.at("inputs"));
  test::write_small_dataset(at("second"));
  test::write_text(at("second/test.cla"), "PSB 1\n2 6\n\nsphere 0 3\n0\n3\n6\n\ncube 0 3\n1\n4\n7\n");
  EXPECT_EQ(changed_inputs(recorded, read(document()).inputs(1)).size(), 1U);
  EXPECT_THAT(test::input_error_of([&] { recorded_configuration(recorded, at("first"), paths); }),
              HasSubstr("datasets.0.root"));
}

TEST_F(RunMultiDataset, ReplacesTheFilesOfAnEarlierRun) {
  (void)run(document(), "results");
  Json json = document();
  json["datasets"].erase(0);
  Cache none;
  (void)run_into_folder(read(json), at("results"), true, {.threads = 1}, none);
  EXPECT_FALSE(fs::exists(at("results/First_set/summary.csv")));
  EXPECT_FALSE(fs::exists(at("results/First_set/manifest.json")));
  EXPECT_TRUE(fs::exists(at("results/second/summary.csv")));
}

TEST_F(RunMultiDataset, RejectsMissingOrRepeatedDataSetNamesAndUnknownKeys) {
  Json both = document();
  both["dataset"] = both["datasets"][0];
  EXPECT_THAT(test::input_error_of([&] { read(both); }), HasSubstr("dataset"));
  Json nameless = document();
  nameless["datasets"][1].erase("name");
  EXPECT_THAT(test::input_error_of([&] { read(nameless); }), HasSubstr("name"));
  Json twice = document();
  twice["datasets"][1]["name"] = "First set";
  EXPECT_THAT(test::input_error_of([&] { read(twice); }), HasSubstr("First set"));
  Json misspelt = document();
  misspelt["datasets"][0]["rot"] = "x";
  EXPECT_THAT(test::input_error_of([&] { read(misspelt); }), HasSubstr("root"));
}

}  // namespace

}  // namespace shapegauge
