// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/formats.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/experiments/evaluation/segmentation_benchmark.h"
#include "tests/support/test_files.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using Labels = std::vector<std::int32_t>;

class SegmentationBenchmarkFolder : public test::FolderTest {
 protected:
  void add(const std::string& id, int people) const {
    std::filesystem::create_directories(at("off"));
    std::filesystem::create_directories(folder_.path() / "seg" / id);
    write_off(folder_.path() / "off" / (id + ".off"), test::sphere(1, 0));
    for (int k = 0; k < people; ++k) {
      std::ofstream(folder_.path() / "seg" / id / (id + "_" + std::to_string(k) + ".seg")) << "0\n";
    }
  }
};

TEST_F(SegmentationBenchmarkFolder, ListsItsModelsInNaturalOrderWithClasses) {
  for (const char* id : {"101", "20", "21", "400", "401", "mine"}) add(id, 2);
  add("3", 0);
  const SegmentationBenchmark found = find_segmentation_benchmark(folder_.path());
  std::vector<std::string> ids;
  std::vector<std::string> classes;
  for (const SegmentedModel& model : found.models) {
    ids.push_back(model.id);
    classes.push_back(found.classes[static_cast<std::size_t>(model.label)]);
    EXPECT_EQ(model.people.size(), 2U);
  }
  EXPECT_EQ(ids, (std::vector<std::string>{"20", "21", "101", "400", "401", "mine"}));
  EXPECT_EQ(classes, (std::vector<std::string>{"human", "cup", "chair", "fourleg", "other", "other"}));
  EXPECT_EQ(found.without_people, (std::vector<std::string>{"3"}));
}

TEST_F(SegmentationBenchmarkFolder, IsRejectedWithoutHumanSegmentations) {
  EXPECT_THROW(find_segmentation_benchmark(folder_.path()), InputError);
  add("3", 0);
  EXPECT_THROW(find_segmentation_benchmark(folder_.path()), InputError);
}

/// Labels: 1 where x is above the limit, otherwise 0.
Labels halves(const Shape& shape, double limit) {
  const Samples samples = sample_shape(shape, SampleSite::faces);
  Labels labels;
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) labels.push_back(samples.points(i, 0) > limit ? 1 : 0);
  return labels;
}

TEST(SegmentationScorer, MeasuresCutDiscrepancyInUnitsOfTheMeanRadius) {
  // Cuts of a unit sphere at two heights: about as far apart as the arc between them, both ways.
  const Shape sphere = test::sphere(1, 5);
  const SegmentationScorer scorer(sphere, {});
  const double arc = std::asin(0.5);
  // Paths along edges are up to a seventh longer than geodesics; cuts zigzag by an edge of 0.05.
  const double found = scorer.errors(halves(sphere, 0), halves(sphere, 0.5)).cut_discrepancy;
  EXPECT_GT(found, 2 * (arc - 0.05));
  EXPECT_LT(found, 2 * (arc * 1.16 + 0.05));
  EXPECT_TRUE(std::isnan(
      SegmentationScorer(sphere, {.cuts = false}).errors(halves(sphere, 0), halves(sphere, 0.5)).cut_discrepancy));
}

TEST(SegmentationScorer, WeighsFacesByAreaOnRequest) {
  // A box with few large triangles at one end and many small ones at the other.
  const Shape shape = test::joined(
      {test::box({1, 1, 1}, 1), test::transformed(test::box({1, 1, 1}, 6), 1, Eigen::Matrix3d::Identity(), {3, 0, 0})});
  const Labels two = halves(shape, 1.5);
  const Labels one(two.size(), 0);
  const auto n = static_cast<double>(two.size());
  EXPECT_NEAR(SegmentationScorer(shape, {.cuts = false}).errors(one, two).rand_index, 2 * 12 * 432 / (n * (n - 1)),
              1e-12);
  // Half of the area each: half of the pairs of different triangles, less those of a triangle with itself.
  const double squares = 12 * 0.25 + 432 / (72.0 * 72.0);
  EXPECT_NEAR(SegmentationScorer(shape, {.by = TriangleWeights::area, .cuts = false}).errors(one, two).rand_index,
              72 / (144 - squares), 1e-9);
}

TEST(SegmentationScorer, ExcludesUndefinedErrorsFromMeansOverHumanSegmentations) {
  const Shape sphere = test::sphere(1, 2);
  const SegmentationScorer scorer(sphere, {});
  const Labels cut = halves(sphere, 0);
  const Labels none(cut.size(), 0);
  const SegmentationErrors errors = scorer.mean_errors_against(cut, {cut, none});
  EXPECT_EQ(errors.cut_discrepancy, 0);
  EXPECT_DOUBLE_EQ(errors.rand_index, scorer.errors(cut, none).rand_index / 2);
  EXPECT_DOUBLE_EQ(scorer.mean_errors_among({cut, none, cut}).rand_index, scorer.errors(cut, none).rand_index * 2 / 3);
  EXPECT_TRUE(std::isnan(scorer.mean_errors_among({cut}).rand_index));
}

}  // namespace
}  // namespace shapegauge
