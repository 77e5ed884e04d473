// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <string>

#include "shapegauge/experiments/cache/cache_folder.h"
#include "tests/experiments/shape_comparison/published_comparison.h"
#include "tests/support/test_files.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A cache with the shapes of a comparison: a reference in a file of its own, a copy of another file, and a noisy one.
class ComparisonsThroughCache : public test::FolderTest {
 protected:
  void SetUp() override {
    test::write_sphere(at("sphere.off"));
    write_off(at("reference.off"), test::sphere(9, 3));
    document["shapes"][1]["file"] = "reference.off";
    EXPECT_EQ(misses(), 3U);
    EXPECT_EQ(misses(), 0U);
  }

  /// Runs the comparison through the cache, and without one for the expected results; returns how many of the shapes
  /// were computed.
  std::size_t misses(int threads = 1) {
    const ShapeComparison comparison = comparison_from_json(document, "test.json", folder_.path());
    const RunControl control{.threads = threads};
    const auto run = [&](Cache& cache) {
      return run_shape_comparison(comparison, {.control = control, .cache = cache});
    };
    Cache none;
    test::publish(at("expected"), run(none));
    Cache cache(at("cache"));
    const ShapeComparisonResults results = run(cache);
    warnings = cache.warnings();
    test::publish(at("results"), results);
    EXPECT_EQ(test::results_in(at("results")), test::results_in(at("expected")));
    const CacheUse use = results.cache.uses.at(static_cast<std::size_t>(EntryKind::comparison));
    EXPECT_EQ(use.hits + use.computed, results.shapes.size());
    return use.computed;
  }

  Json document = test::three_spheres();
  std::vector<std::string> warnings;
};

TEST_F(ComparisonsThroughCache, RecomputePerturbedShapesForAnotherSeedNameOrIndex) {
  document["seed"] = 7;
  EXPECT_EQ(misses(), 1U);
  document["shapes"][0]["perturbations"][0]["amplitude"] = 0.02;
  EXPECT_EQ(misses(), 1U);
  document["shapes"][0]["name"] = "very noisy";
  EXPECT_EQ(misses(), 1U);
  std::swap(document["shapes"][0], document["shapes"][2]);
  EXPECT_EQ(misses(), 1U);
}

TEST_F(ComparisonsThroughCache, RecomputeAllShapesForAnotherReference) {
  write_off(at("reference.off"), test::sphere(11, 3));
  EXPECT_EQ(misses(), 3U);
  document["shapes"][1]["perturbations"] = {{{"type", "remove_faces"}, {"fraction", 0.1}}};
  EXPECT_EQ(misses(), 3U);
  document["seed"] = 7;
  EXPECT_EQ(misses(), 3U) << "which perturbs the reference";
  document["registered"] = false;
  EXPECT_EQ(misses(), 3U);
  document["registered"] = true;
  document["reference"] = "again";
  EXPECT_EQ(misses(), 3U);
}

TEST_F(ComparisonsThroughCache, RecomputeAShapeOnlyIfItsFileContentsChange) {
  test::write_sphere(at("moved.off"));
  document["shapes"][2]["file"] = "moved.off";
  EXPECT_EQ(misses(), 0U) << "the same bytes";
  write_off(at("moved.off"), test::sphere(11, 3));
  EXPECT_EQ(misses(), 1U);
}

TEST_F(ComparisonsThroughCache, RecomputeAllShapesIfPreparationFieldsOrHistogramsChange) {
  document["preparation"] = {{"denoise", true}};
  EXPECT_EQ(misses(), 3U);
  document["signatures"][0]["field"]["offset"] = 0.04;
  EXPECT_EQ(misses(), 3U);
  document["signatures"][1]["field"]["rays"] = 20;
  EXPECT_EQ(misses(), 3U);
  document["signatures"][2]["histogram"]["bins"] = 11;
  EXPECT_EQ(misses(), 3U);
  document["signatures"].erase(1);
  EXPECT_EQ(misses(), 3U);
}

TEST_F(ComparisonsThroughCache, RecomputeAllShapesForAnotherNumberOfThreads) {
  EXPECT_EQ(misses(2), 3U);
  EXPECT_EQ(misses(2), 0U);
}

TEST_F(ComparisonsThroughCache, RecomputeNoShapesIfOnlyNamesChange) {
  document["name"] = "other";
  document["signatures"][0]["name"] = "other";
  document["shapes"][2]["name"] = "other";
  document["on_error"] = "skip";
  EXPECT_EQ(misses(), 0U);
}

TEST_F(ComparisonsThroughCache, RecomputeGeneratedShapesOnlyIfTheirDescriptionChanges) {
  document["shapes"][2].erase("file");
  document["shapes"][2]["generate"] = {{"class", "bracket"}, {"faces", 1000}};
  EXPECT_EQ(misses(), 1U);
  EXPECT_EQ(misses(), 0U);
  document["shapes"][2]["generate"]["seed"] = 2;
  EXPECT_EQ(misses(), 1U);
}

TEST_F(ComparisonsThroughCache, RecomputeDamagedEntries) {
  const std::vector<CacheFile> entries = cache_files(at("cache"));
  ASSERT_EQ(entries.size(), 3U);
  test::write_text(entries[0].path, test::text_of(entries[0].path).substr(0, 1000));
  EXPECT_EQ(misses(), 1U);
  EXPECT_THAT(warnings, testing::ElementsAre(testing::HasSubstr("damaged cache entry, recomputed: ")));
  EXPECT_EQ(misses(), 0U);

  // Complete entries with contents that are no records.
  for (const CacheFile& entry : entries) {
    const std::string key = entry.path.parent_path().filename().string() + entry.path.stem().string();
    Cache(at("cache")).put(EntryKind::comparison, key, std::string("no measurement"));
  }
  EXPECT_EQ(misses(), 3U);
  EXPECT_EQ(misses(), 0U);
}

}  // namespace

}  // namespace shapegauge
