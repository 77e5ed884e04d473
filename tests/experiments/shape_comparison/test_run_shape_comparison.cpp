// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "shapegauge/experiments/configuration/json_document.h"
#include "shapegauge/experiments/configuration/shape_comparison.h"
#include "shapegauge/experiments/shape_comparison/run_shape_comparison.h"
#include "tests/experiments/shape_comparison/published_comparison.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

namespace fs = std::filesystem;
using test::text_of;
using test::write_text;
using testing::HasSubstr;
using Json = nlohmann::json;

/// A sphere, a copy of its file under another name, and a noisy sphere.
class RunComparison : public test::FolderTest {
 protected:
  void SetUp() override { test::write_sphere(at("sphere.off")); }
  [[nodiscard]] static Json document() { return test::three_spheres(); }
  [[nodiscard]] ShapeComparisonResults run(const Json& changed = document(), const RunControl& control = {}) const {
    Cache none;
    return run(changed, control, none);
  }
  [[nodiscard]] ShapeComparisonResults run(const Json& changed, const RunControl& control, Cache& cache) const {
    return run_shape_comparison(comparison_from_json(changed, "test.json", folder_.path()),
                                {.control = control, .cache = cache});
  }
};

TEST_F(RunComparison, NotesShapesThatAreNotPerturbedAsRequested) {
  Json changed = document();
  changed["shapes"][2]["perturbations"] = {{{"type", "decimate"}, {"faces", 1}}};
  EXPECT_THAT(test::publish(at("notes"), run(changed)).notes,
              testing::ElementsAre(testing::StartsWith(
                  "1 of 3 shapes were not perturbed as requested; the first, again: decimated to ")));
  EXPECT_THAT(test::publish(at("notes"), run()).notes, testing::IsEmpty());
}

TEST_F(RunComparison, IdenticalShapesHaveDistanceZero) {
  const ShapeComparisonResults results = run();
  ASSERT_EQ(results.shapes.size(), 3U);
  EXPECT_EQ(results.shapes[2].name, "again");
  for (const SignatureResults& signature : results.signatures) {
    EXPECT_GT(signature.distances[0], 0);
    EXPECT_EQ(signature.distances[1], 0);
    EXPECT_EQ(signature.distances[2], 0);
  }
  for (const std::size_t shape : {1U, 2U}) {
    for (const FieldMeasurement& field : results.shapes[shape].fields) {
      EXPECT_EQ(field.errors->percentile_90, 0);
      EXPECT_EQ(field.errors->relative_percentile_90, 0);
    }
    // At the centroids of a convex mesh the offset normal is that of the triangle, up to rounding.
    EXPECT_LT(results.shapes[shape].fields[0].offset_normals->percentile_90, 1e-4);
    EXPECT_FALSE(results.shapes[shape].fields[1].offset_normals) << "the cone estimates no normals";
  }
}

TEST_F(RunComparison, NoisyShapeHasErrorsInUnitsOfTheReference) {
  const ShapeComparisonResults results = run();
  for (const FieldMeasurement& field : results.shapes[0].fields) {
    // The noise is 1 % of the diagonal on either side of a diameter of 58 % of it.
    EXPECT_GT(field.errors->median, 1e-4);
    EXPECT_LT(field.errors->percentile_90, 0.04);
    EXPECT_NEAR(field.errors->relative_median * 20 / 34.6, field.errors->median, 0.1 * field.errors->median);
  }
}

TEST_F(RunComparison, DimensionlessFieldIsUnaffectedByTheAreaThatNoiseAdds) {
  // A heat kernel that is 1 everywhere. Noise makes the area larger, which is scaled to 1 again.
  Json changed = document();
  changed["shapes"][0]["perturbations"][0]["amplitude"] = 0.03;
  changed["signatures"] = Json::parse(R"([
    {"name": "heat", "field": {"type": "heat_kernel", "time": 100, "eigenvalues": 10, "at": "vertices"},
     "histogram": {"range": "dataset"}}])");
  const ShapeComparisonResults results = run(changed);
  EXPECT_GT(results.shapes[0].description.area, 1.1 * results.shapes[1].description.area);
  EXPECT_NEAR(results.shapes[0].fields[0].errors->relative_percentile_90, 0, 1e-6);
  EXPECT_NEAR(results.shapes[0].fields[0].errors->percentile_90, 0, 1e-6);
}

TEST_F(RunComparison, NormalErrorsAreAnglesToTheNormalsOfTheReference) {
  const ShapeComparisonResults results = run();
  const FieldMeasurement& noisy = results.shapes[0].fields[0];
  const FieldMeasurement& clean = results.shapes[1].fields[0];
  EXPECT_LT(clean.shape_normals->mean, 1e-5);
  EXPECT_LT(clean.offset_normals->mean, 1e-5);
  EXPECT_GT(noisy.shape_normals->mean, 1);
  EXPECT_GT(noisy.offset_normals->mean, 1);
  EXPECT_GT(noisy.shape_normals->percentile_90, noisy.shape_normals->median);
}

TEST_F(RunComparison, WritesTheSameBytesOnAnyNumberOfThreads) {
  for (const int threads : {1, 3}) {
    RunControl control;
    control.threads = threads;
    test::publish(at(std::to_string(threads)), run(document(), control));
  }
  for (const char* file :
       {"summary.md", "histograms.csv", "distances.csv", "errors.csv", "normals.csv", "shapes.csv"}) {
    EXPECT_NE(text_of(at("1") / file), "") << file;
    EXPECT_TRUE(text_of(at("1") / file) == text_of(at("3") / file)) << file;
  }
  Json one = Json::parse(text_of(at("1") / "manifest.json"));
  Json three = Json::parse(text_of(at("3") / "manifest.json"));
  one.erase("execution");
  three.erase("execution");
  EXPECT_EQ(one, three);
  EXPECT_EQ(one["inputs"]["shapes"]["clean"].get<std::string>().size(), 64U);
}

TEST_F(RunComparison, UnregisteredShapesHaveNoErrors) {
  Json poses = document();
  poses["registered"] = false;
  EXPECT_FALSE(run(poses).shapes[0].fields[0].errors);
  EXPECT_EQ(run(poses).signatures[0].distances.size(), 3U);
  Json alone = document();
  alone.erase("reference");
  test::publish(at("out"), run());
  test::publish(at("out"), run(alone));
  EXPECT_FALSE(fs::exists(at("out") / "errors.csv")) << "of the earlier run";
  EXPECT_FALSE(fs::exists(at("out") / "distances.csv"));
  EXPECT_TRUE(fs::exists(at("out") / "timings.csv"));
}

TEST_F(RunComparison, StopsAtAnInvalidShapeOrSkipsItOnRequest) {
  write_text(at("flat.off"), "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n");
  Json changed = document();
  changed["shapes"][2]["file"] = "flat.off";
  changed["shapes"].push_back({{"name", "absent"}, {"file", "absent.off"}});
  EXPECT_THAT(test::input_error_of([&] { static_cast<void>(run(changed)); }), HasSubstr("shape \"absent\": "));
  changed["on_error"] = "skip";
  const ShapeComparisonResults results = run(changed);
  ASSERT_EQ(results.failures.size(), 2U);
  EXPECT_EQ(results.failures[0].id, "again");
  EXPECT_THAT(results.failures[0].message, HasSubstr("area"));
  EXPECT_EQ(results.shapes.size(), 2U);
  EXPECT_EQ(results.signatures[0].distances[1], 0);
  changed["reference"] = "again";
  EXPECT_THAT(test::input_error_of([&] { static_cast<void>(run(changed)); }), HasSubstr("it is the reference"));
}

TEST_F(RunComparison, SecondRunReadsAllResultsFromTheCache) {
  Cache first(at("cache"));
  test::publish(at("first"), run(document(), {.threads = 2}, first));
  Cache second(at("cache"));
  const ShapeComparisonResults results = run(document(), {.threads = 2}, second);
  test::publish(at("second"), results);
  const CacheUse use = results.cache.uses.at(static_cast<std::size_t>(EntryKind::comparison));
  EXPECT_EQ(use.hits, 3U);
  EXPECT_EQ(use.computed, 0U);
  Json one = Json::parse(text_of(at("first") / "manifest.json"));
  Json two = Json::parse(text_of(at("second") / "manifest.json"));
  EXPECT_EQ(two["execution"]["cache"], (Json{{"comparison", {{"from_cache", 3}, {"computed", 0}}}}));
  EXPECT_EQ(two["execution"]["field_seconds"], one["execution"]["field_seconds"]);
  one.erase("execution");
  two.erase("execution");
  EXPECT_EQ(one, two);
  for (const std::string file : one.at("files")) {  // timings.csv, too
    EXPECT_NE(text_of(at("first") / file), "") << file;
    EXPECT_TRUE(text_of(at("first") / file) == text_of(at("second") / file)) << file;
  }
}

TEST_F(RunComparison, ContinuesFromTheCacheAfterAnInterruption) {
  Json longer = document();
  longer["shapes"].push_back(
      {{"name", "fewer"}, {"file", "sphere.off"}, {"perturbations", {{{"type", "remove_faces"}, {"fraction", 0.1}}}}});
  bool interrupted = false;
  RunControl control{.interrupted = [&] { return interrupted; }};
  control.progress = [&](std::string_view stage, std::size_t done, std::size_t) {
    interrupted = stage == "shapes" && done == 1;
  };
  Cache first(at("cache"));
  EXPECT_THROW(static_cast<void>(run(longer, control, first)), Interrupted);
  Cache second(at("cache"));
  const ShapeComparisonResults results = run(longer, {}, second);
  const CacheUse use = results.cache.uses.at(static_cast<std::size_t>(EntryKind::comparison));
  EXPECT_EQ(use.hits, 2U) << "the reference and the first of the others";
  EXPECT_EQ(use.computed, 2U);
  test::publish(at("continued"), results);
  test::publish(at("alone"), run(longer));
  EXPECT_EQ(test::results_in(at("continued")), test::results_in(at("alone")));
}

TEST_F(RunComparison, StopsIfInterrupted) {
  std::atomic<int> asked = 0;
  RunControl control;
  control.interrupted = [&] { return ++asked > 2; };
  EXPECT_THROW(static_cast<void>(run(document(), control)), Interrupted);
}

TEST_F(RunComparison, ComparesACloudWithAMesh) {
  Json changed = document();
  changed["shapes"][0]["perturbations"] = Json::parse(R"([{"type": "vertex_cloud"}])");
  changed["signatures"].erase(1);
  changed["signatures"][0]["field"]["offset"] = 0.1;  // well above the points' spacing
  const ShapeComparisonResults results = run(changed);
  const FieldMeasurement& cloud = results.shapes[0].fields[0];
  EXPECT_EQ(cloud.samples, 642U);
  EXPECT_LT(cloud.errors->percentile_90, 0.02);
  EXPECT_LT(cloud.offset_normals->percentile_90, 8);
}

/// The orientation of normals of an unoriented cloud is arbitrary: compares lines only.
TEST_F(RunComparison, NormalErrorsOfAnUnorientedCloudIgnoreOrientation) {
  Json changed = document();
  changed["shapes"][0]["perturbations"] = Json::parse(R"([{"type": "vertex_cloud"}])");
  changed["signatures"].erase(1);
  changed["signatures"][0]["field"]["offset"] = 0.1;
  const ShapeComparisonResults results = run(changed);
  EXPECT_LT(results.shapes[0].fields[0].shape_normals->percentile_90, 8);
}

TEST(ShapeComparisonOfGeneratedShapes, NeedsNoShapeFiles) {
  const fs::path file = SHAPEGAUGE_SOURCE_FOLDER "/configs/studies/generated_comparison.json";
  Json document = read_json(file);
  document["shapes"].erase(document["shapes"].begin() + 2, document["shapes"].end());
  for (Json& shape : document["shapes"]) shape["generate"] = {{"class", "snake"}, {"faces", 1000}};
  Cache none;
  const ShapeComparisonResults results =
      run_shape_comparison(comparison_from_json(document, file.string(), ""), {.control = {}, .cache = none});
  EXPECT_EQ(results.shapes.size(), 2U);
  EXPECT_TRUE(results.failures.empty());
  EXPECT_EQ(results.signatures[0].distances[0], 0);
}

}  // namespace

}  // namespace shapegauge
