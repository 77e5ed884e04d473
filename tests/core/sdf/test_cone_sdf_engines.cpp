// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/shape_file.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/cone_sdf_engines.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

/// The definition, word by word; sums from the smallest to the largest.
double defined_mean(std::vector<double> values) {
  std::ranges::sort(values);
  const double centre = median(values);
  std::vector<double> deviations;
  for (const double value : values) deviations.push_back(std::abs(value - centre));
  const double limit = 1.5 * median(deviations);
  double sum = 0;
  int count = 0;
  for (const double value : values) {
    if (std::abs(value - centre) > limit) continue;
    sum += value;
    ++count;
  }
  return sum / count;
}

double mean_of(std::vector<double> values) { return mean_without_outliers(values); }

TEST(MeanWithoutOutliers, ExcludesValuesFarFromTheMedian) {
  EXPECT_EQ(mean_of({4}), 4);
  EXPECT_EQ(mean_of({1, 3}), 2);
  EXPECT_EQ(mean_of({5, 2, 2, 2}), 2);
  EXPECT_EQ(mean_of({1, 9, 3, 2, 100}), 2);       // median 3, deviations 0 1 2 6 97, limit 3
  EXPECT_EQ(mean_of({10, 2, 3, 5, 90, 4}), 3.5);  // median 4.5, deviations .5 .5 1.5 2.5 5.5 85.5, limit 3
}

/// Values of a few kinds, so that many are equal, or any at all.
RC_GTEST_PROP(MeanWithoutOutliers, MatchesADirectImplementation, (bool many_equal)) {
  const int count = *rc::gen::inRange(1, 200);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    values.push_back(*rc::gen::inRange(0, many_equal ? 6 : 1'000'000) / 7.0);
  }
  const double expected = defined_mean(values);
  RC_ASSERT(mean_without_outliers(values) == expected);
  RC_ASSERT(std::ranges::is_sorted(values));
}

ConeSdfResult cone_sdf_by(ConeSdfEngine engine, const Shape& shape, bool postprocess = false) {
  ConeSdfOptions options;
  options.engine = engine;
  options.postprocess = postprocess;
  return cone_sdf(shape, sample_shape(shape, SampleSite::faces), options);
}

/// Without symmetry to the axes: no ray meets an edge, and no normal is on an axis, where the two engines, which round
/// normals differently, might begin their spirals at different angles.
Shape turned(const Shape& shape) { return test::transformed(shape, 1, test::rotation(2), {3, -1, 2}); }

void expect_agreement(const Shape& shape) {
  const ConeSdfResult ours = cone_sdf_by(ConeSdfEngine::embree, shape);
  const ConeSdfResult reference = cone_sdf_by(ConeSdfEngine::cgal, shape);
  EXPECT_EQ(ours.missing, reference.missing);
  const double diagonal = bounding_box_diagonal(shape);
  for (Eigen::Index f = 0; f < ours.values.size(); ++f) {
    ASSERT_EQ(std::isnan(ours.values[f]), std::isnan(reference.values[f])) << f;
    if (std::isnan(ours.values[f])) continue;
    EXPECT_NEAR(ours.values[f] / diagonal, reference.values[f] / diagonal, 1e-6) << f;
  }
}

TEST(ConeSdfCgal, ValuesMatchEmbree) {
  expect_agreement(turned(test::torus(3, 1, 20, 40)));
  expect_agreement(turned(test::capsule(0.5, 3, 20, 5)));
  expect_agreement(turned(test::joined({test::sphere(1, 2), test::sphere(0.3, 1)})));
}

TEST(ConeSdfCgal, ValuesMatchEmbreeOnBenchmarkMeshes) {
  const char* const data = std::getenv("SHAPEGAUGE_DATA");
  if (data == nullptr) GTEST_SKIP() << "SHAPEGAUGE_DATA names no folder with real meshes";
  for (const char* const name : {"T0.off", "T350.off", "T550.off"}) {
    expect_agreement(read_shape(std::filesystem::path(data) / "shrec11_nonrigid" / name));
  }
}

TEST(ConeSdfCgal, ValuesMatchEmbreeOnAShapeTurnedInsideOut) {
  const Shape torus = turned(test::flipped(test::torus(3, 1, 20, 40)));
  const ConeSdfResult result = cone_sdf_by(ConeSdfEngine::cgal, torus);
  EXPECT_GT(result.missing, 0U);
  EXPECT_LT(result.missing, static_cast<std::size_t>(result.values.size()));
  expect_agreement(torus);
}

TEST(ConeSdfCgal, PostprocessingScalesToTheUnitIntervalAndFillsMissingValues) {
  for (const Shape& shape : {test::capsule(0.5, 3, 20, 5), test::flipped(test::torus(3, 1, 20, 40))}) {
    const ConeSdfResult result = cone_sdf_by(ConeSdfEngine::cgal, turned(shape), true);
    EXPECT_EQ(result.missing, 0U);
    EXPECT_EQ(result.values.minCoeff(), 0);
    EXPECT_EQ(result.values.maxCoeff(), 1);
  }
}

TEST(ConeSdfCgal, PostprocessingFillsNoValuesIfAllAreMissing) {
  const Shape box = test::flipped(test::box({1, 2, 3}, 2));
  const ConeSdfResult result = cone_sdf_by(ConeSdfEngine::cgal, box, true);
  EXPECT_EQ(result.missing, static_cast<std::size_t>(box.triangles.rows()));
}

TEST(ConeSdfCgal, RefusesMeshesWithoutArea) {
  Shape line = test::box({1, 1, 1}, 1);
  line.vertices.conservativeResize(3, 3);
  line.vertices << 0, 0, 0, 1, 0, 0, 2, 0, 0;
  line.triangles.conservativeResize(1, 3);
  line.triangles << 0, 1, 2;
  EXPECT_THAT([&] { cone_sdf_by(ConeSdfEngine::cgal, line); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("no area")));
}

TEST(ConeSdfCgal, RejectsMeshesThatAreNotOrientedManifolds) {
  const Shape box = test::box({1, 2, 3}, 2);
  EXPECT_NO_THROW(cone_sdf_by(ConeSdfEngine::cgal, box));
  Shape one_turned = box;
  one_turned.triangles.row(5).reverseInPlace();
  Shape tripled = box;
  tripled.triangles.conservativeResize(box.triangles.rows() + 1, 3);
  tripled.triangles.bottomRows<1>() << 0, 1, 7;
  Shape degenerate = box;
  degenerate.triangles.conservativeResize(box.triangles.rows() + 1, 3);
  degenerate.triangles.bottomRows<1>() << 0, 0, 1;
  for (const Shape& shape : {one_turned, tripled, degenerate}) {
    EXPECT_THAT([&] { cone_sdf_by(ConeSdfEngine::cgal, shape); },
                testing::ThrowsMessage<InputError>(testing::HasSubstr("embree engine")));
    EXPECT_NO_THROW(cone_sdf_by(ConeSdfEngine::embree, shape));
  }
}

TEST(ConeSdfCgal, RejectsSamplesAtVertices) {
  const Shape sphere = test::sphere(1, 1);
  ConeSdfOptions options;
  options.engine = ConeSdfEngine::cgal;
  EXPECT_THROW(cone_sdf(sphere, sample_shape(sphere, SampleSite::vertices), options), InputError);
}

}  // namespace

}  // namespace shapegauge
