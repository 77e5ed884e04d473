// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/experiments/configuration/read_configuration.h"
#include "shapegauge/experiments/configuration/schema.h"
#include "shapegauge/experiments/engine/replay.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/kinds/experiment_kinds.h"
#include "tests/support/small_dataset.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

/// One small experiment of each kind.
class ExperimentKinds : public test::FolderTest {
 protected:
  void SetUp() override {
    test::write_small_dataset(at("data"));
    for (const char* name : {"a.off", "b.off"}) write_off(at(name), test::sphere(1, 2));
  }

  [[nodiscard]] Json retrieval() const { return test::small_configuration(at("data")); }

  [[nodiscard]] static Json comparison() {
    return Json::parse(R"({
      "name": "spheres",
      "shapes": [{"name": "a", "file": "a.off"},
                 {"name": "b", "file": "b.off", "perturbations": [{"type": "vertex_noise", "amplitude": 0.01}]},
                 {"name": "c", "file": "b.off", "perturbations": [{"type": "remove_faces", "fraction": 0.1}]},
                 {"name": "d", "file": "b.off"}],
      "reference": "a",
      "signatures": [{"name": "cone", "field": {"type": "cone_sdf"}, "histogram": {"bins": 10, "range": "dataset"}}]})");
  }

  [[nodiscard]] static Json segmentation() {
    return Json::parse(R"({
      "name": "parts",
      "dataset": {"generate": {"classes": 2, "models_per_class": 2, "faces": 1000}},
      "segmentation": [{"name": "best"}, {"name": "paper", "method": "paper"}]})");
  }

  /// Retrieval on three data sets, one of them missing.
  [[nodiscard]] Json multi_dataset() const {
    Json document = retrieval();
    Json dataset = document["dataset"];
    document.erase("dataset");
    dataset["name"] = "on disk";
    document["datasets"] = {
        dataset,
        {{"name", "made"}, {"generate", {{"classes", 2}, {"models_per_class", 2}, {"faces", 1000}}}},
        {{"name", "gone"}, {"layout", "folders"}, {"root", at("nowhere").string()}}};
    return document;
  }

  [[nodiscard]] RunOutcome run(const Json& document, const std::string& output, Cache& cache,
                               const RunControl& control = {.threads = 1}) const {
    return run_into_folder(read_experiment(document, "test.json", folder_.path()), at(output), false, control, cache);
  }
};

TEST_F(ExperimentKinds, AreRecognisedByTheKeysOfADocument) {
  EXPECT_THAT(experiment_kinds().names(), ElementsAre("retrieval", "comparison", "segmentation", "multi_dataset"));
  EXPECT_TRUE(read_experiment(retrieval(), "test.json", at("")).inputs);
  EXPECT_EQ(read_experiment(comparison(), "test.json", at("")).configuration()["shapes"].size(), 4U);
  EXPECT_EQ(read_experiment(segmentation(), "test.json", at("")).name, "parts");
  EXPECT_EQ(read_experiment(multi_dataset(), "test.json", at("")).configuration()["datasets"].size(), 3U);
  EXPECT_THAT(test::input_error_of([&] {
                read_experiment(Json{{"nmae", "x"}}, "test.json", at(""));
              }),
              HasSubstr("test.json: unknown key \"nmae\""));
}

TEST_F(ExperimentKinds, RejectADocumentWithTheKeysOfSeveralKinds) {
  const auto error_with = [&](Json document, const std::string& key, const Json& value) {
    document[key] = value;
    return test::input_error_of([&] { read_experiment(document, "test.json", at("")); });
  };
  const Json methods = segmentation()["segmentation"];
  EXPECT_THAT(error_with(retrieval(), "segmentation", methods),
              HasSubstr("retrieval (\"dataset\", \"signatures\"), segmentation (\"segmentation\")"));
  EXPECT_THAT(error_with(multi_dataset(), "shapes", Json::array()),
              HasSubstr("comparison (\"shapes\"), multi_dataset (\"datasets\")"));
  EXPECT_THAT(error_with(comparison(), "dataset", Json::object()),
              HasSubstr("retrieval (\"dataset\", \"signatures\")"));
}

TEST_F(ExperimentKinds, RejectDocumentsOfAnotherKindOfExperiment) {
  const std::map<std::string, Json> documents{{"retrieval", retrieval()},
                                              {"comparison", comparison()},
                                              {"segmentation", segmentation()},
                                              {"multi_dataset", multi_dataset()}};
  for (const auto& [actual, document] : documents) {
    for (const auto& [other, unused] : documents) {
      SCOPED_TRACE(actual + " as " + other);
      const std::string error = test::input_error_of(
          [&, &name = other, &read = document] { experiment_kinds().at(name).read(read, "test.json", at("")); });
      EXPECT_THAT(error, testing::StartsWith(actual == other ? "no error" : "test.json: unknown key \""));
    }
  }
}

TEST_F(ExperimentKinds, ReplaceDatasetFilesByTheirContents) {
  test::write_text(at("set.json"), R"({"layout": "shrec11", "root": "data"})");
  Json document = retrieval();
  document["dataset"] = "set.json";
  EXPECT_EQ(read_experiment(document, "test.json", at("")).configuration()["dataset"]["root"], at("data").string());
  document.erase("dataset");
  document["datasets"] = {"set.json"};
  const Json datasets = read_experiment(document, "test.json", at("")).configuration()["datasets"];
  EXPECT_EQ(datasets[0]["root"], at("data").string());
  EXPECT_EQ(datasets[0]["name"], "set");
}

TEST_F(ExperimentKinds, AreDefinedInTheSchema) {
  const Json schema = Json::parse(experiment_schema());
  const Json* part = &schema;
  for (const auto& [key, definition] : {std::pair{"shapes", "/definitions/comparison_experiment"},
                                        {"segmentation", "/definitions/segmentation_experiment"}}) {
    EXPECT_EQ((*part)["if"]["required"], Json({key}));
    EXPECT_EQ((*part)["then"]["$ref"], std::string("#") + definition);
    part = &(*part)["else"];
  }
  const Json& multi_dataset = (*part)["then"];
  EXPECT_TRUE(multi_dataset["properties"].contains("datasets"));
  EXPECT_FALSE(multi_dataset["properties"].contains("dataset"));
  EXPECT_EQ(multi_dataset["properties"]["signatures"],
            schema["definitions"]["retrieval_experiment"]["properties"]["signatures"]);
}

TEST_F(ExperimentKinds, DoNotWriteResultsIntoTheFolderOfTheirDataSet) {
  Cache none;
  EXPECT_THAT(test::input_error_of([&] { (void)run(retrieval(), "data", none); }),
              HasSubstr("the results would overwrite the input " + at("data").string()));
  EXPECT_FALSE(fs::exists(at("data") / "manifest.json"));
  Json document = comparison();
  document["shapes"][0]["file"] = "spheres/summary.json";
  test::write_text(at("spheres/summary.json"), "a shape");
  EXPECT_THAT(test::input_error_of([&] { (void)run(document, "spheres", none); }),
              HasSubstr("the results would overwrite the input " + at("spheres/summary.json").string()));
}

TEST_F(ExperimentKinds, DoNotOverwriteInputsNamedLikeAResultFile) {
  const auto error_of = [&](const Json& document, const std::string& output) {
    Cache none;
    return test::input_error_of([&] {
      (void)run_into_folder(read_experiment(document, "test.json", at("")), at(output), true, {.threads = 1}, none);
    });
  };
  Json document = retrieval();
  test::write_text(at("classes/shapes.csv"), test::text_of(at("data/test.cla")));
  document["dataset"]["classification"] = at("classes/shapes.csv").string();
  EXPECT_THAT(error_of(document, "classes"),
              HasSubstr("the results would overwrite the input " + at("classes/shapes.csv").string()));
  EXPECT_EQ(test::text_of(at("classes/shapes.csv")), test::text_of(at("data/test.cla")));
  EXPECT_FALSE(fs::exists(at("classes") / manifest_name));
  EXPECT_EQ(error_of(document, "elsewhere"), "no error");

  test::write_small_dataset(at("cut/parts"));
  document = segmentation();
  document["dataset"] = {{"layout", "shrec11"}, {"root", at("cut/parts").string()}};
  EXPECT_THAT(error_of(document, "cut"),
              HasSubstr("the results would overwrite the input " + at("cut/parts").string()));
  EXPECT_FALSE(fs::exists(at("cut/parts/best")));
}

TEST_F(ExperimentKinds, GiveTheSameResultsInPartsAsInOneRun) {
  for (const auto& [name, document] : {std::pair{"retrieval", retrieval()},
                                       {"comparison", comparison()},
                                       {"segmentation", segmentation()},
                                       {"multi_dataset", multi_dataset()}}) {
    const std::string alone = std::string(name) + "/alone";
    Cache none;
    const RunOutcome outcome = run(document, alone, none);
    EXPECT_FALSE(outcome.summary.empty());
    for (const std::size_t count : {1U, 5U}) {
      SCOPED_TRACE(fmt::format("{} in {} parts", name, count));
      const std::string together = fmt::format("{}/{}", name, count);
      const Experiment experiment = read_experiment(document, "test.json", at(""));
      const fs::path folder = at(together + "_cache");
      std::size_t all = 0;
      for (std::size_t number = count; number > 0; --number) {
        Cache cache(folder);
        (void)run_part(experiment, {.number = number, .count = count}, at(together), {.threads = 1}, cache);
        EXPECT_FALSE(fs::exists(at(together) / manifest_name));
      }
      Cache cache(folder);
      const RunOutcome combined = run(document, together, cache);
      for (const EntryKind kind : {EntryKind::field, EntryKind::segmentation, EntryKind::comparison}) {
        const CacheUse& use = combined.cache.uses.at(static_cast<std::size_t>(kind));
        EXPECT_EQ(use.computed, 0U) << name_of(kind);
        all += use.hits;
      }
      EXPECT_GT(all, 0U);
      EXPECT_EQ(test::results_in(at(together)), test::results_in(at(alone)));
    }
  }
}

TEST_F(ExperimentKinds, RejectRunsInPartsWithoutACacheOrIfIndivisible) {
  Cache none;
  const Experiment experiment = read_experiment(retrieval(), "test.json", at(""));
  EXPECT_THAT(test::input_error_of([&] { (void)run_part(experiment, {}, at("out"), {}, none); }), HasSubstr("cache"));
  Cache cache(at("cache"));
  const Experiment whole{.name = "whole", .configuration = {}, .run = experiment.run};
  EXPECT_THAT(test::input_error_of([&] { (void)run_part(whole, {}, at("out"), {}, cache); }),
              HasSubstr("cannot be divided into parts"));
}

TEST_F(ExperimentKinds, ContinueFromTheCacheAfterAnInterruption) {
  for (const auto& [name, document] : {std::pair{"retrieval", retrieval()},
                                       {"comparison", comparison()},
                                       {"segmentation", segmentation()},
                                       {"multi_dataset", multi_dataset()}}) {
    SCOPED_TRACE(name);
    const std::string folder = name;
    Cache none;
    (void)run(document, folder + "/alone", none);
    std::size_t done = 0;
    RunControl control{.threads = 1, .interrupted = [&] { return done >= 2; }};
    control.progress = [&](std::string_view stage, std::size_t now, std::size_t) {
      if (stage == "signatures" || stage == "shapes") done = now;
    };
    Cache first(at("cache"));
    EXPECT_THROW((void)run(document, folder + "/resumed", first, control), Interrupted);
    EXPECT_FALSE(fs::exists(at(folder + "/resumed") / manifest_name));
    Cache second(at("cache"));
    const RunOutcome outcome = run(document, folder + "/resumed", second);
    std::size_t hits = 0;
    for (const CacheUse& use : outcome.cache.uses) hits += use.hits;
    EXPECT_GT(hits, 0U);
    EXPECT_EQ(test::results_in(at(folder + "/resumed")), test::results_in(at(folder + "/alone")));
  }
}

TEST_F(ExperimentKinds, ReuseGeneratedShapesWhenASegmentationIsRunAgain) {
  Cache none;
  (void)run(segmentation(), "parts", none);
  int generated = 0;
  RunControl control{.threads = 1};
  control.progress = [&](std::string_view stage, std::size_t, std::size_t) {
    generated += stage == "generating models" ? 1 : 0;
  };
  (void)run(segmentation(), "parts", none, control);
  EXPECT_EQ(generated, 0);
}

/// A kind defined outside the library: counts the characters of a file.
Experiment read_count(const Json& document, const std::string& /*source*/, const fs::path& folder) {
  const std::string text = read_file_bytes(folder / document.at("count").at("file").get<std::string>());
  return {.name = "count",
          .configuration = [document] { return document; },
          .run =
              [text](const RunContext&, const RunResults& to) {
                write_file_atomically(to.folder / "count.txt", std::to_string(text.size()) + "\n");
                to.manifest["inputs"] = Json::object();
                return RunOutcome{
                    .files = {"count.txt"}, .summary = std::to_string(text.size()), .used = 1, .noun = "text"};
              }};
}

nlohmann::ordered_json count_schema() {
  return nlohmann::ordered_json::parse(R"({
    "title": "count",
    "type": "object",
    "additionalProperties": false,
    "properties": {
      "name": {"$ref": "#/definitions/experiment_name"},
      "count": {"type": "object", "required": ["file"], "properties": {"file": {"type": "string"}}}
    }})");
}

TEST_F(ExperimentKinds, CanBeAddedByUsers) {
  const ExperimentKind kind{.name = "count",
                            .description = "Counts characters.",
                            .keys = {"count"},
                            .paths = {.files = {"/count/file"}},
                            .schema = count_schema,
                            .read = read_count};
  experiment_kinds().add(kind);
  test::write_text(at("text.txt"), "shapes");
  const Json document{{"count", {{"file", "text.txt"}}}};
  Cache none;
  EXPECT_EQ(run(document, "count", none).summary, "6");
  EXPECT_EQ(test::text_of(at("count/count.txt")), "6\n");
  const Json manifest = Json::parse(test::text_of(at("count/manifest.json")));
  EXPECT_EQ(manifest.at("configuration"), document);
  EXPECT_THROW(experiment_kinds().add(kind), InputError);

  Json changed = document;
  const std::vector<std::string> overrides{"count.file=other/text.txt", "name=x.txt"};
  apply_overrides(changed, "test.json", at(""), overrides, experiment_paths);
  EXPECT_EQ(changed["count"]["file"], (fs::current_path() / "other/text.txt").string());
  EXPECT_EQ(changed["name"], "x.txt");
  EXPECT_EQ(recorded_configuration({{"configuration", changed}}, at("new"), experiment_paths)["count"]["file"],
            at("new/text.txt").string());

  const auto error_of = [&](const Json& wrong) {
    return test::input_error_of([&] { read_experiment(wrong, "test.json", at("")); });
  };
  EXPECT_EQ(error_of({{"count", {{"file", 3}}}}), "test.json: count.file: must be of type string, not number (3)");
  EXPECT_THAT(error_of({{"count", {{"file", "text.txt"}}}, {"shapes", Json::array()}}),
              HasSubstr("comparison (\"shapes\"), count (\"count\")"));
  EXPECT_EQ(Json::parse(experiment_schema())["else"]["else"]["else"]["then"], Json(count_schema()));
}

TEST_F(ExperimentKinds, RejectRegistrationsWithoutKeysOrFunctions) {
  ExperimentKind kind{.name = "other", .description = "", .schema = count_schema, .read = read_count};
  EXPECT_THAT(test::input_error_of([&] { experiment_kinds().add(kind); }), HasSubstr("\"other\" needs keys"));
  kind.keys = {"other"};
  kind.schema = [] { return nlohmann::ordered_json{{"definitions", {{"own", {{"type", "string"}}}}}}; };
  EXPECT_THAT(test::input_error_of([&] { experiment_kinds().add(kind); }),
              HasSubstr("\"other\": a schema cannot have definitions of its own"));
  kind.schema = count_schema;
  kind.paths.files = {"other"};
  EXPECT_THAT(test::input_error_of([&] { experiment_kinds().add(kind); }), HasSubstr("must begin with a slash"));
  kind.schema = nullptr;
  EXPECT_THAT(test::input_error_of([&] { experiment_kinds().add(kind); }), HasSubstr("lacks a mandatory function"));
}

}  // namespace

}  // namespace shapegauge
