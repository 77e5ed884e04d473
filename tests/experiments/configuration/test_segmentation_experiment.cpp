// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "shapegauge/experiments/configuration/segmentation_experiment.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

SegmentationExperiment read(const Json& dataset, const Json& method) {
  return segmentation_from_json({{"name", "x"}, {"dataset", dataset}, {"segmentation", {method}}}, "x.json", "/data");
}

const Json benchmark{{"layout", "psb_segmentation"}, {"root", "psb"}};

TEST(SegmentationExperiment, IsReadBackAsWritten) {
  const std::vector<std::pair<Json, Json>> cases{
      {benchmark, {{"name", "a"}, {"patches", 70}, {"min_probability", 0.75}, {"border_width", 0}}},
      {benchmark, {{"name", "b"}, {"method", "paper"}, {"field", "cone_sdf"}, {"parts", 3}}},
      {{{"layout", "shrec11"}, {"root", "s"}, {"classification", "c.cla"}},
       {{"name", "c"}, {"perturbations", {{{"type", "remove_faces"}, {"fraction", 0.1}}}}}},
      {{{"layout", "folders"}, {"root", "s"}, {"split", "test"}}, {{"name", "d"}}},
      {{{"generate", {{"classes", 2}}}}, {{"name", "e"}}}};
  for (const auto& [dataset, method] : cases) {
    const Json written = to_json(read(dataset, method));
    EXPECT_EQ(to_json(segmentation_from_json(written, "x.json", "/elsewhere")), written) << written.dump(2);
    const Json& entry = written.at("segmentation").at(0);
    for (const auto& [key, value] : method.items()) {
      if (key == "perturbations") continue;
      EXPECT_EQ(entry.at(key), value) << key;
    }
  }
}

TEST(SegmentationExperiment, ReadsPathsAndSettingsFromTheConfiguration) {
  const SegmentationExperiment experiment =
      read({{"layout", "shrec11"}, {"root", "s"}, {"classification", "c.cla"}},
           {{"name", "c"}, {"patches", 70}, {"min_probability", 0.75}, {"border_width", 0.01}});
  EXPECT_EQ(experiment.location.root, "/data/s");
  EXPECT_EQ(experiment.location.classification, "/data/s/c.cla");
  const SegmentationOptions& options = experiment.methods[0].options;
  EXPECT_EQ(options.best.patches, 70);
  EXPECT_EQ(options.best.min_probability, 0.75);
  EXPECT_EQ(options.best.smoothing.width, 0.01);
  EXPECT_EQ(options.method, SegmentationAlgorithm::best);
}

TEST(SegmentationExperiment, ErrorForAnUnknownFieldListsTheKnownFields) {
  const Json method{{"name", "a"}, {"method", "paper"}, {"field", "ball"}};
  EXPECT_THAT(test::input_error_of([&] { read(benchmark, method); }),
              HasSubstr("field: unknown word \"ball\"; known here: \"offset_sdf\", \"cone_sdf\""));
}

TEST(SegmentationExperiment, AcceptsPreparationSettings) {
  Json document{{"name", "x"}, {"dataset", benchmark}, {"segmentation", {{{"name", "a"}}}}};
  const auto read_document = [&] { return segmentation_from_json(document, "x.json", "/data"); };
  EXPECT_EQ(read_document().preparation, PreparationOptions());
  document["preparation"] = {{"denoise", true}, {"remove_outliers", false}, {"scale", "tube_area"}};
  EXPECT_EQ(read_document().preparation, (PreparationOptions{.denoise = true, .scale = ScaleEstimate::tube_area}));
  EXPECT_EQ(to_json(read_document())["preparation"], document["preparation"]);
  document["preparation"] = {{"denoised", true}};
  EXPECT_THAT(test::input_error_of(read_document), HasSubstr("preparation: unknown key \"denoised\""));
}

TEST(SegmentationExperiment, RejectsSettingsOfAnotherMethodOrLayout) {
  const auto refusal = [](const Json& dataset, const Json& method) {
    return test::input_error_of([&] { read(dataset, method); });
  };
  EXPECT_THAT(refusal(benchmark, {{"name", "a"}, {"method", "paper"}, {"patches", 70}}), HasSubstr("patches"));
  EXPECT_THAT(refusal(benchmark, {{"name", "a"}, {"method", "paper"}, {"border_width", 0}}), HasSubstr("border_width"));
  EXPECT_THAT(refusal(benchmark, {{"name", "a"}, {"field", "cone_sdf"}}), HasSubstr("field"));
  EXPECT_THAT(refusal(benchmark, {{"name", "a"}, {"patches", 0}}), HasSubstr("patches"));
  EXPECT_THAT(refusal(benchmark, {{"name", "a"}, {"perturbations", {{{"type", "nois"}}}}}), HasSubstr("perturbations"));
  EXPECT_THAT(refusal({{"layout", "psb_segmentation"}, {"root", "r"}, {"split", "all"}}, {{"name", "a"}}),
              HasSubstr("split"));
  EXPECT_THAT(refusal({{"layout", "folders"}, {"root", "r"}, {"classification", "c"}}, {{"name", "a"}}),
              HasSubstr("classification"));
  EXPECT_THAT(refusal({{"layout", "psb_segments"}, {"root", "r"}}, {{"name", "a"}}), HasSubstr("layout"));
}

}  // namespace

}  // namespace shapegauge
