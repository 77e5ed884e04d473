// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>

#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/sdf/automatic_offset.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/datasets/files/sha256.h"
#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/engine/replay.h"
#include "shapegauge/experiments/engine/result_folder.h"
#include "shapegauge/experiments/segmentation/part_consistency.h"
#include "shapegauge/experiments/segmentation/run_segmentation.h"
#include "shapegauge/experiments/segmentation/write_segmentation.h"
#include "shapegauge/segmentation/part_segmentation.h"
#include "shapegauge/segmentation/seg_file.h"
#include "shapegauge/segmentation/segment_shape.h"
#include "tests/experiments/segmentation/published_segmentation.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using test::bytes_of;
using test::TemporaryFolder;
using testing::HasSubstr;

/// Two disjoint balls: every method finds the same two parts.
Shape two_balls(int subdivisions = 2) {
  const Shape ball = test::sphere(1, subdivisions);
  return test::joined({ball, test::transformed(ball, 1, Eigen::Matrix3d::Identity(), {5, 0, 0})});
}

class SegmentationRun : public test::FolderTest {
 protected:
  void SetUp() override {
    std::vector<std::int32_t> two(640, 0);
    std::fill(two.begin() + 320, two.end(), 7);
    for (const std::string id : {"1", "21", "22"}) {
      std::filesystem::create_directories(root() / "seg" / id);
      std::filesystem::create_directories(root() / "off");
      write_off(root() / "off" / (id + ".off"), two_balls());
      write_seg(root() / "seg" / id / "a.seg", two);
      write_seg(root() / "seg" / id / "b.seg", id == "22" ? std::vector<std::int32_t>(640, 0) : two);
    }
  }

  [[nodiscard]] std::filesystem::path root() const { return at("psb"); }

  [[nodiscard]] SegmentationExperiment experiment(
      const nlohmann::json& methods =
          nlohmann::json::parse(R"([{"name": "best"}, {"name": "the paper", "method": "paper"}])")) const {
    return segmentation_from_json(
        {{"name", "balls"}, {"dataset", {{"layout", "psb_segmentation"}, {"root", "psb"}}}, {"segmentation", methods}},
        "x.json", folder_.path());
  }

  [[nodiscard]] SegmentationResults cut(const SegmentationExperiment& run, Cache& cache,
                                        const RunControl& control = {}) const {
    return run_segmentation(run, {.control = control, .cache = cache, .generated = at("none")});
  }
  [[nodiscard]] SegmentationResults cut(const SegmentationExperiment& run) const {
    Cache none;
    return cut(run, none);
  }
};

TEST_F(SegmentationRun, ScoresMethodsAndHumanSegmentations) {
  const SegmentationResults results = cut(experiment());
  EXPECT_THAT(results.scores.methods, testing::ElementsAre("best", "the paper", "people"));
  EXPECT_THAT(results.scores.classes, testing::ElementsAre("human", "cup"));
  // Of 640 triangles in two halves, pairs across are 320 * 320.
  const double separated = 320.0 * 320 / (640.0 * 639 / 2);
  EXPECT_DOUBLE_EQ(results.scores.mean(0, &SegmentationErrors::rand_index, 0), 0);
  EXPECT_DOUBLE_EQ(results.scores.errors[0][2].rand_index, separated / 2);
  EXPECT_DOUBLE_EQ(results.scores.errors[2][2].rand_index, separated);
  EXPECT_DOUBLE_EQ(results.scores.mean(2, &SegmentationErrors::rand_index, 1), separated / 2);
  EXPECT_THAT(test::publish(at("results"), results).summary, HasSubstr("the paper"));
}

TEST_F(SegmentationRun, ReadsUnchangedSegmentationsFromTheCache) {
  SegmentationExperiment same = experiment();
  same.methods.resize(1);
  const std::filesystem::path folder = at("cache");
  const auto use_of = [&](const SegmentationExperiment& run) {
    Cache cache(folder);
    const auto results = cut(run, cache, {.threads = 1});
    return results.cache.uses.at(static_cast<std::size_t>(EntryKind::segmentation));
  };
  EXPECT_EQ(use_of(same).computed, 1U);  // the three files have equal contents, described once
  EXPECT_EQ(use_of(same).hits, 3U);
  same.methods[0].name = "another name";
  EXPECT_EQ(use_of(same).hits, 3U);
  same.methods[0].options.best.parts = 2;
  EXPECT_EQ(use_of(same).computed, 1U);
}

TEST(SegmentationVersions, IncludeTheVersionsOfSdfsSamplesAndThePartModel) {
  for (const SegmentationAlgorithm algorithm : {SegmentationAlgorithm::best, SegmentationAlgorithm::paper}) {
    const bool paper = algorithm == SegmentationAlgorithm::paper;
    const nlohmann::json versions =
        versions_of({.name = "parts", .options = {.method = algorithm}, .perturbations = {}});
    EXPECT_EQ(versions.at("cone_sdf"), cone_sdf_version);
    EXPECT_EQ(versions.at("offset_sdf"), offset_sdf_version);
    EXPECT_EQ(versions.at("automatic_offset"), automatic_offset_version);
    EXPECT_EQ(versions.at("samples"), samples_version);
    EXPECT_EQ(versions.contains("paper_segmentation"), paper);
    EXPECT_EQ(versions.contains("part_segmentation"), !paper);
    EXPECT_EQ(versions.contains("part_model"), !paper);
  }
}

TEST_F(SegmentationRun, WritesTheSameFilesOnAnyNumberOfThreads) {
  std::map<std::string, std::string> first;
  for (const int threads : {1, 2}) {
    Cache cache;
    const std::filesystem::path folder = folder_.path() / "results" / std::to_string(threads);
    test::publish(folder, cut(experiment(), cache, {.threads = threads}));
    const nlohmann::json manifest = read_json(folder / manifest_name);
    EXPECT_EQ(manifest.at("inputs").at("models").size(), 9U);
    std::map<std::string, std::string> files;
    for (const std::string name : manifest.at("files")) files[name] = bytes_of(folder / name);
    EXPECT_TRUE(files.contains("parts/the_paper/22.seg"));
    EXPECT_TRUE(files.contains("errors.csv"));
    EXPECT_THAT(files.at("report.html"), HasSubstr("\"png\":\"iVBOR"));
    if (first.empty()) first = files;
    EXPECT_EQ(files, first);
    EXPECT_EQ(read_seg(folder / "parts/best/1.seg", two_balls()).back(), 1);
  }
}

TEST_F(SegmentationRun, ComparesPerturbedShapesWithTheOriginalShapes) {
  const nlohmann::json removed{{"type", "remove_faces"}, {"fraction", 0.8}};
  const nlohmann::json turned{{"type", "motion"}, {"scale", 3}};
  SegmentationExperiment run =
      experiment({{{"name", "as it is"}},
                  {{"name", "removed"}, {"perturbations", {removed}}},
                  {{"name", "turned"}, {"perturbations", {turned}}},
                  {{"name", "points"}, {"perturbations", {{{"type", "sample_points"}, {"points", 500}}}}}});
  const SegmentationResults results = cut(run);
  const SegmentedShape& shape = results.shapes[0];
  for (const auto& labels : shape.labels) ASSERT_EQ(labels.size(), 640U);
  EXPECT_TRUE(std::isnan(shape.perturbation_errors[0]));
  EXPECT_GT(shape.perturbation_errors[1], 0);  // pieces become disconnected, hence parts
  EXPECT_EQ(shape.perturbation_errors[2], 0);
  EXPECT_EQ(shape.perturbation_errors[3], 0);  // two clouds, transferred back to the triangles
  EXPECT_EQ(results.scores.errors[1][0].rand_index,
            shape.perturbation_errors[1]);  // human segmentations equal the best cut: two balls
  const TextTable table = perturbation_effect_table(results);
  ASSERT_EQ(table.rows.size(), 3U);
  EXPECT_EQ(table.rows[1][0], "turned");

  run.seed = 2;
  EXPECT_NE(cut(run).shapes[0].labels[1], shape.labels[1]);
}

TEST_F(SegmentationRun, ReadsUnchangedPerturbedShapesFromTheCache) {
  SegmentationExperiment run =
      experiment({{{"name", "noise"}, {"perturbations", {{{"type", "vertex_noise"}, {"amplitude", 0.01}}}}}});
  const auto computed = [&] {
    Cache cache(at("cache"));
    const auto results = cut(run, cache, {.threads = 1});
    return results.cache.uses.at(static_cast<std::size_t>(EntryKind::segmentation)).computed;
  };
  EXPECT_EQ(computed(),
            4U);  // three files with equal contents: noise differs per file, undamaged they are described once
  EXPECT_EQ(computed(), 0U);
  run.seed = 2;
  EXPECT_EQ(computed(), 3U);
}

TEST_F(SegmentationRun, ReportsConsistencyWithoutReferenceSegmentations) {
  std::filesystem::create_directories(at("shapes/ball"));
  std::filesystem::create_directories(at("shapes/balls"));
  write_off(at("shapes/ball/a.off"), test::sphere(1, 2));
  write_off(at("shapes/ball/b.off"), test::sphere(2, 3));
  write_off(at("shapes/balls/c.off"), two_balls());
  const SegmentationExperiment run = segmentation_from_json({{"name", "poses"},
                                                             {"dataset", {{"layout", "folders"}, {"root", "shapes"}}},
                                                             {"segmentation", {{{"name", "best"}}}}},
                                                            "x.json", folder_.path());
  const SegmentationResults results = cut(run);
  using Row = std::vector<std::string>;
  EXPECT_THAT(consistency_table(results).rows,
              testing::ElementsAre(Row{"best", "ball", "1.000", "1.000", "0.000", "0.500"},
                                   Row{"best", "balls", "2.000", "-", "-", "0.500"},
                                   Row{"best", "mean", "1.500", "1.000", "0.000", "0.500"}));
  test::publish(at("results"), results);
  EXPECT_TRUE(std::filesystem::exists(at("results/consistency.csv")));
  EXPECT_FALSE(std::filesystem::exists(at("results/errors.csv")));
  const std::string page = bytes_of(at("results/report.html"));
  EXPECT_THAT(page, HasSubstr("\"errors\":null")) << "there is nothing to compare with";
}

/// Closed box of six quadrilaterals, triangulated as twelve triangles.
constexpr const char* box_of_quads =
    "OFF\n8 6 0\n0 0 0\n1 0 0\n1 2 0\n0 2 0\n0 0 9\n1 0 9\n1 2 9\n0 2 9\n"
    "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

TEST_F(SegmentationRun, AssignsOnePartToEachPolygonOfTheFile) {
  test::write_text(root() / "off/22.off", box_of_quads);
  for (const char* const person : {"a", "b"}) {
    test::write_text(root() / "seg/22" / (std::string(person) + ".seg"), "0\n0\n0\n0\n0\n1\n");
  }
  const SegmentationResults results = cut(experiment());
  EXPECT_EQ(results.shapes[0].labels[0].size(), 640U);
  EXPECT_FALSE(results.shapes[0].has_polygons);
  EXPECT_EQ(results.shapes[2].labels[0].size(), 6U);
  EXPECT_TRUE(results.shapes[2].has_polygons);
}

TEST_F(SegmentationRun, StopsAtAnInvalidShapeOrSkipsAndNamesItOnRequest) {
  write_seg(root() / "seg/21/a.seg", std::vector<std::int32_t>(7, 0));
  SegmentationExperiment run = experiment();
  EXPECT_THAT(test::input_error_of([&] { (void)cut(run); }), HasSubstr("shape 21: "));
  run.on_error = OnError::skip;
  const SegmentationResults results = cut(run);
  ASSERT_EQ(results.failures.size(), 1U);
  EXPECT_EQ(results.failures[0].id, "21");
  EXPECT_THAT(results.scores.ids, testing::ElementsAre("1", "22"));
}

TEST_F(SegmentationRun, SegmentsDenoisedShapesIfPreparationIsRequested) {
  RandomNumbers random(1);
  const Shape noisy = vertex_noise(two_balls(3), {.amplitude = 0.008}, random);
  std::filesystem::create_directories(at("shapes/ball"));
  write_off(at("shapes/ball/a.off"), noisy);
  const nlohmann::json motion{{"type", "motion"}, {"scale", 3}};
  nlohmann::json document{{"name", "noisy"},
                          {"dataset", {{"layout", "folders"}, {"root", "shapes"}}},
                          {"segmentation",
                           {{{"name", "paper"}, {"method", "paper"}},
                            {{"name", "moved"}, {"method", "paper"}, {"perturbations", {motion}}}}}};
  const auto labels_with = [&](const nlohmann::json& preparation, Cache& cache) {
    if (!preparation.is_null()) document["preparation"] = preparation;
    const SegmentationExperiment experiment = segmentation_from_json(document, "x.json", folder_.path());
    return cut(experiment, cache).shapes.at(0).labels;
  };
  Cache cache(at("cache"));
  const Shape mesh = read_shape(at("shapes/ball/a.off"));
  const SegmentationOptions paper{.method = SegmentationAlgorithm::paper};
  const auto as_it_is = labels_with(nullptr, cache);
  EXPECT_EQ(as_it_is[0], segment_shape(mesh, paper));
  const PreparedShape prepared = prepare_shape(mesh, {.denoise = true});
  ASSERT_GT(prepared.pass_band, 0) << "the noise is smoothed";
  const auto denoised = labels_with({{"denoise", true}}, cache);
  EXPECT_EQ(denoised[0], segment_shape(prepared.shape, paper)) << "and not taken from the cache of the run before";
  EXPECT_NE(denoised[0], as_it_is[0]);
  EXPECT_EQ(denoised[1], denoised[0]) << "parts do not depend on the scale before the preparation";
}

TEST_F(SegmentationRun, NotesShapesNotPerturbedAsRequestedAlsoFromTheCache) {
  const SegmentationExperiment run =
      experiment({{{"name", "coarse"}, {"perturbations", {{{"type", "decimate"}, {"faces", 1}}}}}});
  for (const char* const again : {"computed", "cached"}) {
    Cache cache(at("cache"));
    const SegmentationResults results = cut(run, cache, {.threads = 1});
    EXPECT_THAT(test::publish(at("results"), results).notes,
                testing::ElementsAre(testing::StartsWith(
                    "3 of 3 shapes were not perturbed as requested; the first, 1: coarse: decimated to ")))
        << again;
  }
}

TEST_F(SegmentationRun, NotesShapesWithUnclosedGapsReadFromTheCache) {
  const SegmentationExperiment run =
      experiment({{{"name", "paper"}, {"method", "paper"}, {"field", "offset_sdf"}, {"offset", 0.02}}});
  Shape open = two_balls();
  open.triangles.conservativeResize(320 + 160, Eigen::NoChange);  // half of the second ball
  write_off(root() / "off/21.off", open);
  for (const std::string file : {"a.seg", "b.seg"}) {
    write_seg(root() / "seg/21" / file, std::vector<std::int32_t>(480, 0));
  }
  for (const char* const again : {"computed", "cached"}) {
    Cache cache(at("cache"));
    const SegmentationResults results = cut(run, cache, {.threads = 1});
    EXPECT_THAT(
        test::publish(at("results"), results).notes,
        testing::ElementsAre(testing::AllOf(
            testing::StartsWith("1 of 3 shapes have samples without a reliable offset SDF; the first, 21: paper: "),
            HasSubstr("outside on both sides"))))
        << again;
  }
}

TEST_F(SegmentationRun, DetectsInputsThatChangedSinceARecordedRun) {
  const nlohmann::json document{{"name", "balls"},
                                {"dataset", {{"layout", "psb_segmentation"}, {"root", "psb"}}},
                                {"on_error", "skip"},
                                {"segmentation", {{{"name", "best"}}}}};
  write_seg(root() / "seg/21/a.seg", std::vector<std::int32_t>(7, 0));  // which fails
  const Experiment experiment = segmentation_kind().read(document, "x.json", folder_.path());
  Cache none;
  (void)run_into_folder(experiment, at("results"), false, {.threads = 1}, none);
  nlohmann::json recorded = read_json(folder_.path() / "results" / manifest_name);
  EXPECT_EQ(recorded.at("inputs").at("models").size(), 9U);
  EXPECT_THAT(changed_inputs(recorded, experiment.inputs(1)), testing::IsEmpty());
  write_off(root() / "off/1.off", test::sphere(1, 2));
  write_seg(root() / "seg/21/a.seg", std::vector<std::int32_t>(640, 0));
  std::filesystem::remove(root() / "seg/22/b.seg");
  EXPECT_THAT(changed_inputs(recorded, experiment.inputs(1)),
              testing::ElementsAre("model 1 differs from the recorded one",
                                   "model 21/a.seg differs from the recorded one", "model 22/b.seg is absent"));

  // Earlier versions recorded no files of failed shapes.
  for (const char* const file : {"21", "21/a.seg", "21/b.seg"}) recorded.at("inputs").at("models").erase(file);
  EXPECT_THAT(changed_inputs(recorded, experiment.inputs(1)),
              testing::ElementsAre("model 1 differs from the recorded one", "model 22/b.seg is absent",
                                   "the files of 1 model that failed in the recorded run were not recorded"));
}

TEST_F(SegmentationRun, ManifestContainsTheHashOfTheClassificationFile) {
  test::write_text(at("shapes/test.cla"), "PSB 1\n1 1\n\nballs 0 1\n0\n");
  write_off(at("shapes/T0.off"), two_balls());
  const auto experiment_on = [&](const nlohmann::json& dataset) {
    return segmentation_kind().read({{"name", "x"}, {"dataset", dataset}, {"segmentation", {{{"name", "best"}}}}},
                                    "x.json", folder_.path());
  };
  const auto inputs = experiment_on({{"layout", "shrec11"}, {"root", "shapes"}}).inputs(1);
  EXPECT_EQ(inputs.at("classification"), sha256_of_file(at("shapes/test.cla")));
  EXPECT_EQ(inputs.at("models").size(), 1U);
  EXPECT_FALSE(experiment_on({{"generate", nlohmann::json::object()}}).inputs) << "known after the run only";

  RunControl control{.threads = 1};
  control.progress = [&](std::string_view, std::size_t, std::size_t) {
    std::filesystem::remove(at("shapes/test.cla"));
  };
  Cache none;
  (void)run_into_folder(experiment_on({{"layout", "shrec11"}, {"root", "shapes"}}), at("results"), false, control,
                        none);
  EXPECT_FALSE(std::filesystem::exists(at("shapes/test.cla")));
  EXPECT_EQ(read_json(folder_.path() / "results" / manifest_name).at("inputs"), inputs) << "as read by the run";
}

TEST(SegmentationOfGeneratedShapes, IsScoredAgainstThePartsOfTheGenerator) {
  const TemporaryFolder folder;
  nlohmann::json document = read_json(SHAPEGAUGE_SOURCE_FOLDER "/configs/studies/generated_segmentation.json");
  document["dataset"]["generate"] = {{"classes", 2}, {"models_per_class", 1}, {"faces", 1000}};
  const SegmentationExperiment experiment = segmentation_from_json(document, "x.json", folder.path());
  Cache cache;
  const SegmentationResults results =
      run_segmentation(experiment, {.control = {}, .cache = cache, .generated = folder.path() / "dataset"});
  EXPECT_EQ(results.scores.methods.size(), 3U);  // one ground truth, hence no human scores
  EXPECT_LT(results.scores.mean(0, &SegmentationErrors::rand_index), 0.1);
  EXPECT_LT(results.scores.mean(0, &SegmentationErrors::rand_index),
            results.scores.mean(1, &SegmentationErrors::rand_index));
}

TEST(SegmentationConfiguration, FillsInDefaultsAndIsReadBackAsWritten) {
  for (const char* name : {"paper/psb_segmentation", "paper/table3_segmentation", "studies/generated_segmentation"}) {
    const nlohmann::json document =
        read_json(std::filesystem::path(SHAPEGAUGE_SOURCE_FOLDER "/configs") / (std::string(name) + ".json"));
    nlohmann::json here = document;
    if (here["dataset"].contains("root")) here["dataset"]["root"] = "/data";
    const nlohmann::json filled = to_json(segmentation_from_json(here, name, "/"));
    EXPECT_EQ(to_json(segmentation_from_json(filled, name, "/")), filled);
  }
}

TEST(SegmentationConfiguration, RejectsDuplicateNamesAndSettingsOfAnotherMethod) {
  const auto error_of = [](const nlohmann::json& methods) {
    const nlohmann::json document{
        {"name", "x"}, {"dataset", {{"generate", {{"classes", 1}}}}}, {"segmentation", methods}};
    return test::input_error_of([&] { segmentation_from_json(document, "x.json", "/"); });
  };
  EXPECT_THAT(error_of({{{"name", "a"}}, {{"name", "a"}}}), HasSubstr("segmentation.1.name"));
  EXPECT_THAT(error_of({{{"name", "a"}, {"offset", 0.1}}}), HasSubstr("segmentation.0.offset"));
  EXPECT_THAT(error_of({{{"name", "a"}, {"method", "paper"}, {"field", "cone_sdf"}, {"offset", 0.1}}}),
              HasSubstr("segmentation.0.offset"));
  EXPECT_THAT(error_of({{{"name", "a"}, {"method", "bset"}}}), HasSubstr("segmentation.0.method"));
}

}  // namespace

}  // namespace shapegauge
