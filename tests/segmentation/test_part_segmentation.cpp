// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <set>
#include <tbb/global_control.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/perturbation/perturbations.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/segmentation/part_segmentation.h"
#include "shapegauge/segmentation/patches.h"
#include "shapegauge/segmentation/segment_labels.h"
#include "tests/segmentation/dumbbell.h"
#include "tests/support/doubled_shapes.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {
namespace {

using Labels = std::vector<std::int32_t>;

std::size_t count_of(const Labels& labels) { return std::set(labels.begin(), labels.end()).size(); }

/// Rand disagreement of two segmentations over every seventh triangle.
double disagreement(const Labels& a, const Labels& b) {
  double disagreements = 0;
  double pairs = 0;
  for (std::size_t i = 0; i < a.size(); i += 7) {
    for (std::size_t j = 0; j < i; j += 7) {
      ++pairs;
      disagreements += (a[i] == a[j]) != (b[i] == b[j]);
    }
  }
  return disagreements / pairs;
}

/// Other patches cut the bar elsewhere. Unrelated segmentations into three parts disagree by 0.4 or more.
constexpr double unlike = 0.05;

TEST(PartSegmentation, SeparatesTheBallsOfADumbbell) {
  const Shape shape = test::dumbbell(5);
  const Labels parts = part_segmentation(shape, {});
  const Samples samples = sample_shape(shape, SampleSite::faces);
  std::set<std::int32_t> low;
  std::set<std::int32_t> high;
  for (Eigen::Index i = 0; i < samples.points.rows(); ++i) {
    if (samples.points(i, 2) < -2.2) low.insert(parts[static_cast<std::size_t>(i)]);
    if (samples.points(i, 2) > 2.2) high.insert(parts[static_cast<std::size_t>(i)]);
  }
  EXPECT_EQ(low.size(), 1U);
  EXPECT_EQ(high.size(), 1U);
  EXPECT_NE(low, high);
}

TEST(PartSegmentation, GivesDoubledTrianglesThePartOfTheFirstCopy) {
  const Shape shape = test::dumbbell(4);
  const PartSegmentationOptions options{.parts = 3, .samples = 200};
  const Labels expected = part_segmentation(shape, options);
  std::size_t tried = 0;
  for (const test::ShapeWithDuplicates& doubled : test::variants_with_duplicates(shape)) {
    if (++tried > 6) break;  // each takes as long as a segmentation
    Labels of_all;
    for (const std::int32_t triangle : doubled.triangles)
      of_all.push_back(expected[static_cast<std::size_t>(triangle)]);
    EXPECT_EQ(part_segmentation(doubled.shape, options), of_all) << doubled.name;
  }
}

/// Adds triangles with two coincident corners behind each of some triangles: a repeated index, a coincident vertex,
/// and all corners at one vertex.
Shape with_degenerate(const Shape& shape) {
  Shape result = shape;
  const auto vertices = static_cast<std::int32_t>(shape.vertices.rows());
  result.vertices.conservativeResize(vertices + 1, 3);
  result.vertices.row(vertices) = shape.vertices.row(shape.triangles(0, 0));
  result.triangles.conservativeResize(shape.triangles.rows() + 3, 3);
  const auto& first = shape.triangles.row(0);
  result.triangles.bottomRows<3>() << first[0], first[1], first[1], vertices, first[0], first[2], first[2], first[2],
      first[2];
  return result;
}

TEST(PartSegmentation, DoesNotMakePartsOfDegenerateTriangles) {
  const Shape shape = test::dumbbell(4);
  const PartSegmentationOptions options{.parts = 3, .samples = 200};
  const Labels expected = part_segmentation(shape, options);
  ASSERT_EQ(count_of(expected), 3U);
  Labels all = expected;
  all.insert(all.end(), 3, expected[0]);
  EXPECT_EQ(part_segmentation(with_degenerate(shape), options), all);
}

TEST(PartSegmentation, DoesNotMakePartsOfSlivers) {
  // Two triangles stand upright on edges, almost without area.
  Shape shape = test::dumbbell(4);
  const auto vertices = static_cast<std::int32_t>(shape.vertices.rows());
  shape.vertices.conservativeResize(vertices + 2, 3);
  shape.triangles.conservativeResize(shape.triangles.rows() + 2, 3);
  for (std::int32_t i = 0; i < 2; ++i) {
    const Eigen::RowVector3i corners = shape.triangles.row(100 * i);
    shape.vertices.row(vertices + i) =
        (shape.vertices.row(corners[0]) + shape.vertices.row(corners[1])) * (0.5 + 1e-4 * (i + 1));
    shape.triangles.row(shape.triangles.rows() - 2 + i) << corners[0], corners[1], vertices + i;
  }
  const PartSegmentationOptions options{.samples = 200};
  const Labels parts = part_segmentation(shape, options);
  const Eigen::VectorXd areas = triangle_areas(shape);
  Eigen::VectorXd of_part = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count_of(parts)));
  for (std::size_t i = 0; i < parts.size(); ++i) of_part[parts[i]] += areas[static_cast<Eigen::Index>(i)];
  EXPECT_GT(of_part.minCoeff(), min_patch_fraction / options.patches * areas.sum());
}

TEST(PartSegmentation, OfANeedleIsOnePart) {
  const Shape shape{.vertices = Points{{0, 0, 0}, {0.3, 0.5, 0.7}, {0.3, 0.5, 0.7 + 1e-10}},
                    .triangles = Triangles{{0, 1, 2}}};
  EXPECT_EQ(part_segmentation(shape, {}), (Labels{0}));
}

TEST(PartSegmentation, OfASphereIsOnePart) { EXPECT_EQ(count_of(part_segmentation(test::sphere(1, 4), {})), 1U); }

TEST(PartSegmentation, HasTheRequestedNumberOfParts) {
  const Shape shape = test::dumbbell(4);
  for (const int parts : {1, 2, 3, 7, 80}) {
    const Labels labels = part_segmentation(shape, {.parts = parts, .samples = 200});
    EXPECT_EQ(count_of(labels), static_cast<std::size_t>(parts));
  }
}

TEST(PartSegmentation, UsesAtLeastThreePatchesPerPart) {
  const Shape shape = test::dumbbell(4);
  const auto parts = [&](int patches) {
    return part_segmentation(shape, {.parts = 5, .patches = patches, .samples = 200});
  };
  const Labels fewest = parts(1);
  EXPECT_EQ(fewest, parts(15));
  EXPECT_NE(fewest, parts(14 + 2));
  EXPECT_EQ(count_of(fewest), 5U);
}

TEST(PartSegmentation, NumbersPartsInTheOrderOfTheirTriangles) {
  const Labels parts = part_segmentation(test::dumbbell(4), {.parts = 5});
  EXPECT_EQ(parts, renumber_labels(parts));
}

TEST(PartSegmentation, OfOneTriangleIsOnePart) {
  const Shape shape{.vertices = Points::Identity(3, 3), .triangles = Triangles{{0, 1, 2}}};
  EXPECT_EQ(part_segmentation(shape, {}), (Labels{0}));
}

TEST(PartSegmentation, SeparatesConnectedComponents) {
  const Shape far = test::transformed(test::sphere(1, 3), 1, Eigen::Matrix3d::Identity(), {9, 0, 0});
  const Shape balls = test::joined({test::sphere(1, 3), far});
  EXPECT_EQ(count_of(part_segmentation(balls, {.samples = 300})), 2U);
  EXPECT_EQ(count_of(part_segmentation(balls, {.parts = 1, .samples = 300})), 2U);
}

TEST(PartSegmentation, SegmentsThousandsOfComponents) {
  // Every triangle is shrunk and closed by an apex inside, so that no two touch.
  Shape scales = test::soup(test::sphere(1, 4));
  const Eigen::Index fronts = scales.triangles.rows();
  Points apexes(fronts, 3);
  Triangles sides(3 * fronts, 3);
  for (Eigen::Index f = 0; f < fronts; ++f) {
    const Eigen::RowVector3d middle = scales.vertices.middleRows<3>(3 * f).colwise().mean();
    apexes.row(f) = 0.97 * middle;
    for (int k = 0; k < 3; ++k) {
      const Eigen::RowVector3d corner = scales.vertices.row(3 * f + k);
      scales.vertices.row(3 * f + k) = 0.1 * middle + 0.9 * corner;
      sides.row(3 * f + k) << scales.triangles(f, (k + 1) % 3), scales.triangles(f, k),
          static_cast<std::int32_t>(3 * fronts + f);
    }
  }
  scales.vertices.conservativeResize(4 * fronts, 3);
  scales.vertices.bottomRows(fronts) = apexes;
  scales.triangles.conservativeResize(4 * fronts, 3);
  scales.triangles.bottomRows(3 * fronts) = sides;
  EXPECT_EQ(count_of(part_segmentation(scales, {.samples = 200})), 5120U);
}

TEST(PartSegmentation, OfASphereWithMissingTrianglesIsOnePart) {
  RandomNumbers random(3);
  const Shape cracked = remove_faces(test::sphere(1, 4), 0.15, random);
  EXPECT_EQ(count_of(part_segmentation(cracked, {})), 1U);
}

/// The part of the triangle whose centroid is nearest to this height.
std::int32_t part_at(double height, const Labels& parts, const Points& centroids) {
  Eigen::Index nearest = 0;
  (centroids.col(2).array() - height).abs().minCoeff(&nearest);
  return parts[static_cast<std::size_t>(nearest)];
}

TEST(PartSegmentation, CutsACoarseDumbbellAtTheEndsOfItsBar) {
  // Borders follow patches, so they are exact to the width of a patch.
  const double bar = 2.5 - std::sqrt(1 - 0.25 * 0.25);
  for (const int subdivisions : {3, 4}) {  // 1,280 and 5,120 triangles: both are segmented by a proxy
    const Shape shape = test::dumbbell(subdivisions);
    const double patch = std::sqrt(surface_area(shape) / PartSegmentationOptions{}.patches);
    const Points centroids = sample_shape(shape, SampleSite::faces).points;
    const Labels parts = part_segmentation(shape, {.parts = 3});
    const std::int32_t low = part_at(-2.5, parts, centroids);
    const std::int32_t middle = part_at(0, parts, centroids);
    const std::int32_t high = part_at(2.5, parts, centroids);
    EXPECT_EQ((std::set{low, middle, high}.size()), 3U);
    for (Eigen::Index i = 0; i < centroids.rows(); ++i) {
      const double height = centroids(i, 2);
      if (std::abs(std::abs(height) - bar) < patch) continue;
      const std::int32_t expected = std::abs(height) < bar ? middle : height < 0 ? low : high;
      EXPECT_EQ(parts[static_cast<std::size_t>(i)], expected) << height << " of " << parts.size() << " triangles";
    }
  }
}

TEST(PartSegmentation, LabelsDegenerateTriangles) {
  Shape shape = test::dumbbell(3);
  const Eigen::Index count = shape.triangles.rows();
  shape.triangles.conservativeResize(count + 2, 3);
  shape.triangles.row(count) << 0, 0, 1;
  shape.triangles.row(count + 1) << 0, 1, 1;
  EXPECT_EQ(part_segmentation(shape, {}).size(), static_cast<std::size_t>(count) + 2);
}

TEST(PartSegmentation, HardlyDependsOnPositionSizeAndRotation) {
  const Shape shape = test::dumbbell(4);
  const Shape moved = test::transformed(shape, 40, test::rotation(3), {100, -7, 3});
  EXPECT_LT(disagreement(part_segmentation(shape, {.parts = 3}), part_segmentation(moved, {.parts = 3})), unlike);
}

TEST(PartSegmentation, IsTheSameForAMeshTurnedInsideOut) {
  const Shape shape = test::dumbbell(4);
  EXPECT_EQ(disagreement(part_segmentation(shape, {.parts = 3}), part_segmentation(test::flipped(shape), {.parts = 3})),
            0);
}

TEST(PartSegmentation, LabelsThePointsOfACloud) {
  const Shape mesh = test::dumbbell(4);
  const Shape cloud{.vertices = mesh.vertices, .triangles = {}};
  const Labels parts = part_segmentation(cloud, {.parts = 3});
  EXPECT_EQ(parts.size(), static_cast<std::size_t>(mesh.vertices.rows()));
  Labels balls;
  for (Eigen::Index v = 0; v < mesh.vertices.rows(); ++v) {
    if (std::abs(mesh.vertices(v, 2)) > 2)
      balls.push_back(parts[static_cast<std::size_t>(v)] * (mesh.vertices(v, 2) > 0 ? 1 : -1));
  }
  EXPECT_EQ(count_of(parts), 3U);
  EXPECT_GE(count_of(balls), 2U);
}

TEST(PartSegmentation, IsTheSameOnAnyNumberOfThreads) {
  const Shape shape = test::dumbbell(4);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Labels alone = part_segmentation(shape, {});
  const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
  EXPECT_EQ(part_segmentation(shape, {}), alone);
}

TEST(PartSegmentation, RejectsOptionsOutOfRangeTooManyPartsAndShapesWithoutArea) {
  const Shape box = test::box({1, 1, 1}, 1);
  EXPECT_THROW(part_segmentation(box, {.parts = 1000}), InputError);
  EXPECT_THROW(part_segmentation(box, {.parts = -1}), InputError);
  EXPECT_THROW(part_segmentation(box, {.patches = 0}), InputError);
  EXPECT_THROW(part_segmentation(box, {.samples = 0}), InputError);
  EXPECT_THROW(part_segmentation(box, {.min_probability = 2}), InputError);
  EXPECT_THROW(part_segmentation(Shape{}, {}), InputError);
  Shape flat = box;
  flat.vertices.setZero();
  EXPECT_THROW(part_segmentation(flat, {}), InputError);
}

}  // namespace
}  // namespace shapegauge
