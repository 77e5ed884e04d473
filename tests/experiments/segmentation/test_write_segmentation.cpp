// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <set>

#include "shapegauge/experiments/engine/result_folder.h"
#include "tests/experiments/segmentation/published_segmentation.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

using test::bytes_of;

/// Results of two methods on two shapes without ground truth.
SegmentationResults found() {
  SegmentationResults results;
  results.experiment.name = "two shapes";
  results.experiment.methods.resize(2);
  results.experiment.methods[0].name = "best";
  results.experiment.methods[1].name = "of/the paper";
  results.experiment.generator = GeneratorOptions{};
  results.experiment.pictures = false;
  results.has_people = false;
  results.scores.classes = {"a"};
  results.scores.labels = {0, 0};
  for (const char* const id : {"1", "two"}) {
    results.benchmark.models.push_back({.id = id, .mesh = {}, .people = {}});
    results.shapes.emplace_back();
    results.shapes.back().labels = {{0, 1, 1}, {2, 0, 1}};
    results.shapes.back().part_sizes = {{0.75, 0.25}, {0.5, 0.3, 0.2}};
    results.shapes.back().mesh_sha256 = std::string("hash of ") + id;
  }
  results.failures.push_back({.id = "three", .message = "it is broken"});
  return results;
}

using WriteSegmentation = test::FolderTest;

TEST_F(WriteSegmentation, WritesAFolderOfPartsPerMethod) {
  test::publish(at("out"), found());
  for (const char* const id : {"1", "two"}) {
    EXPECT_EQ(bytes_of(folder_.path() / "out/parts/best" / (std::string(id) + ".seg")), "0\n1\n1\n");
  }
  std::set<std::string> methods;
  for (const auto& entry : std::filesystem::directory_iterator(at("out/parts"))) {
    methods.insert(entry.path().filename().string());
    EXPECT_TRUE(std::filesystem::exists(entry.path() / "two.seg"));
  }
  EXPECT_EQ(methods.size(), 2U);
}

TEST_F(WriteSegmentation, ManifestListsOutputsAndInputs) {
  test::publish(at("out"), found());
  const nlohmann::json manifest = nlohmann::json::parse(bytes_of(folder_.path() / "out" / manifest_name));
  EXPECT_EQ(manifest.at("inputs").at("models").at("two"), "hash of two");
  EXPECT_EQ(manifest.at("failed_models").at(0).at("model"), "three");
  EXPECT_EQ(manifest.at("shapes"), 2);
  for (const auto& [file, hash] : manifest.at("outputs").at("files").items()) {
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / file)) << file;
  }
  EXPECT_TRUE(manifest.at("outputs").at("files").contains("consistency.csv"));
  EXPECT_FALSE(manifest.at("outputs").at("files").contains("errors.csv")) << "nobody cut the shapes";
}

TEST_F(WriteSegmentation, SummaryHasOneRowPerMethodAndClass) {
  const std::string summary = test::publish(folder_.path(), found()).summary;
  for (const char* const word : {"best", "of/the paper", "2.000", "3.000"}) {
    EXPECT_THAT(summary, testing::HasSubstr(word));
  }
}

}  // namespace

}  // namespace shapegauge
