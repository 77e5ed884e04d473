// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <string>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/base/random_numbers.h"
#include "shapegauge/core/preparation/prepare_shape.h"
#include "shapegauge/core/sdf/cone_sdf.h"
#include "shapegauge/core/sdf/offset_sdf.h"
#include "shapegauge/core/shape/connectivity.h"
#include "tests/support/test_shapes.h"

/// Shapes that nobody wants, and what becomes of them: a defined value or an InputError, in bounded time.
namespace shapegauge {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Shape tetrahedron_at(const Eigen::RowVector3d& position, double size) {
  const Points corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return {.vertices = (size * corners).rowwise() + position,
          .triangles = Triangles{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

Eigen::RowVector3d random_position(RandomNumbers& random) {
  const double x = random.uniform(0, 1);
  const double y = random.uniform(0, 1);
  return {x, y, random.uniform(0, 1)};
}

/// Small closed parts, far from each other as a rule, spread through the unit cube.
Shape many_tetrahedra(int count, double size) {
  RandomNumbers random(1, 0);
  std::vector<Shape> parts;
  for (int i = 0; i < count; ++i) parts.push_back(tetrahedron_at(random_position(random), size));
  return test::joined(parts);
}

/// Both SDFs at both sites: values from 0 up, finite except where the conventional SDF has none. Returns the offset SDF
/// at the faces.
Eigen::VectorXd values_of(const Shape& shape, double offset) {
  Eigen::VectorXd at_faces;
  for (const SampleSite site : {SampleSite::vertices, SampleSite::faces}) {
    const Samples samples = sample_shape(shape, site);
    EXPECT_TRUE((samples.weights.array() >= 0).all());
    const OffsetSdfResult result = offset_sdf(shape, samples, {.offset = offset});
    EXPECT_TRUE(result.values.allFinite() && result.normals.allFinite());
    EXPECT_TRUE((result.values.array() >= 0).all());
    EXPECT_EQ(result.outcomes.total, static_cast<std::size_t>(samples.points.rows()));
    const ConeSdfResult cone = cone_sdf(shape, samples, {.rays = 7});
    for (const double value : cone.values) EXPECT_TRUE(std::isnan(value) || (std::isfinite(value) && value >= 0));
    at_faces = result.values;
  }
  return at_faces;
}

TEST(ExtremeShapes, SheetHasThicknessZero) {
  const Shape triangle = test::soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const Shape plane = test::box({1, 1, 0}, 3);  // top and bottom coincide, sides have no area
  for (const double offset : {0.01, 0.1, 1.0}) {
    const double r = offset * std::sqrt(2.0);
    EXPECT_LE(values_of(triangle, offset).maxCoeff(), 2e-3 * r) << offset;
    const Samples samples = sample_shape(plane, SampleSite::faces);
    const Eigen::VectorXd values = values_of(plane, offset);
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      if (samples.weights[i] > 0) {
        EXPECT_LE(values[i], 2e-3 * r) << offset;
      }
    }
  }
}

TEST(ExtremeShapes, NeedleIsNotThickerThanItsLength) {
  // Of no area: p + r n is not to be had, and any direction across the needle is as good as another.
  const Shape needle = test::soup_of({{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}});
  for (const double offset : {0.01, 0.3, 1.0}) {
    EXPECT_LE(values_of(needle, offset).maxCoeff(), 1 + 1e-2 * offset) << offset;
  }
  const Shape thin = test::soup_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1e-12, 0}});
  for (const double offset : {0.01, 0.3, 1.0}) EXPECT_LE(values_of(thin, offset).maxCoeff(), 2e-3 * offset) << offset;
}

TEST(ExtremeShapes, WithoutExtentAreInputErrors) {
  Shape point = test::box({0, 0, 0}, 2);
  point.vertices.array() += 3;
  EXPECT_FALSE(is_closed(point));
  EXPECT_TRUE((sample_shape(point, SampleSite::vertices).weights.array() == 0).all());
  EXPECT_THAT([&] { offset_sdf(point, sample_shape(point, SampleSite::faces), {}); },
              ThrowsMessage<InputError>(HasSubstr("no usable extent")));
  EXPECT_THAT([&] { prepare_shape(point, {}); }, ThrowsMessage<InputError>(HasSubstr("area")));
  const ConeSdfResult cone = cone_sdf(point, sample_shape(point, SampleSite::faces), {});
  EXPECT_EQ(cone.missing, static_cast<std::size_t>(point.triangles.rows()));
}

TEST(ExtremeShapes, DistantPartsAreMeasuredSeparatelyUntilTheirOffsetsMeet) {
  const double distance = 1e6;
  const Shape parts = test::joined({tetrahedron_at({0, 0, 0}, 1), tetrahedron_at({distance, 0, 0}, 1)});
  for (const double offset : {0.01, 0.4}) {  // r is 10,000 and 400,000: neither joins the two balls
    EXPECT_LE(values_of(parts, offset).maxCoeff(), 2 + 1e-2 * offset * distance) << offset;
  }
  // r is 1,000,000: the two balls are one, and only what lies across it is as thin as before.
  EXPECT_LE(values_of(parts, OffsetSdfOptions::offset_bounds.high).maxCoeff(), 1.1 * distance);
}

TEST(ExtremeShapes, WithHugeAndTinyCoordinatesHaveCorrectThickness) {
  for (const double scale : {1e-300, 1e-30, 1e30, 1e300}) {
    const Shape sphere =
        test::transformed(test::sphere(1, 2), scale, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Constant(3 * scale));
    const Eigen::VectorXd values = values_of(sphere, 0.05) / scale;
    EXPECT_GE(values.minCoeff(), 1.8) << scale;
    EXPECT_LE(values.maxCoeff(), 2.01) << scale;
  }
  // Parts of size 1 and 1e-30 at a corner of a triangle of size 1e30: no value exceeds the extent, and rounding.
  const Shape mixed = test::joined({test::sphere(1, 1), test::soup_of({{0, 0, 0}, {1e30, 0, 0}, {0, 1e30, 0}}),
                                    test::soup_of({{0, 0, 1e-30}, {1e-30, 0, 1e-30}, {0, 1e-30, 1e-30}})});
  for (const double offset : {0.02, 1.0}) {
    const double diagonal = bounding_box_diagonal(mixed);
    EXPECT_LE(values_of(mixed, offset).maxCoeff(), (1 + 2e-3 * offset) * diagonal) << offset;
  }
  const double largest = std::numeric_limits<double>::max();
  const Shape too_large = test::soup_of({{-largest, 0, 0}, {largest, 0, 0}, {0, largest, 0}});
  EXPECT_THAT([&] { offset_sdf(too_large, sample_shape(too_large, SampleSite::vertices), {}); },
              ThrowsMessage<InputError>(HasSubstr("no usable extent")));
}

void expect_unusable(const Shape& shape, const std::string& message) {
  EXPECT_THAT([&] { is_closed(shape); }, ThrowsMessage<InputError>(HasSubstr(message)));
  EXPECT_THAT([&] { prepare_shape(shape, {}); }, ThrowsMessage<InputError>(HasSubstr(message)));
  const Samples samples = sample_shape(tetrahedron_at({0, 0, 0}, 1), SampleSite::faces);
  EXPECT_THAT([&] { cone_sdf(shape, samples, {}); }, ThrowsMessage<InputError>(HasSubstr(message)));
  for (const SampleSite site : {SampleSite::faces, SampleSite::vertices}) {
    EXPECT_THAT([&] { sample_shape(shape, site); }, ThrowsMessage<InputError>(HasSubstr(message)));
  }
}

TEST(ExtremeShapes, WithNonFiniteCoordinatesAreInputErrors) {
  for (const double value : {nan, infinity, -infinity}) {
    Shape shape = tetrahedron_at({0, 0, 0}, 1);
    shape.vertices(2, 1) = value;
    expect_unusable(shape, "vertex 2");
  }
}

TEST(ExtremeShapes, WithIndicesOutOfRangeAreInputErrors) {
  for (const std::int32_t index : {-1, 4, std::numeric_limits<std::int32_t>::max()}) {
    Shape shape = tetrahedron_at({0, 0, 0}, 1);
    shape.triangles(3, 1) = index;
    expect_unusable(shape, "triangle 3");
  }
}

// What takes minutes ends at the time that CTest leaves a test.
TEST(ExtremeShapes, OfAThousandPartsHaveAnOffsetSdf) { values_of(many_tetrahedra(1000, 0.01), 0.03); }

TEST(ExtremeShapes, OfManyOverlappingPartsHaveAnOffsetSdf) {
  // From deep inside, all of the surface is far away and about as near.
  RandomNumbers random(2, 0);
  std::vector<Shape> parts;
  for (int i = 0; i < 26; ++i) {
    const Eigen::Vector3d position = 0.3 * random_position(random).transpose();
    parts.push_back(test::transformed(test::sphere(0.3, 2), 1, test::rotation(static_cast<unsigned>(i)), position));
  }
  const Shape joined = test::joined(parts);
  const Samples samples = sample_shape(joined, SampleSite::faces);
  for (const double offset : {0.003, 0.01, 0.1}) {
    const OffsetSdfResult result = offset_sdf(joined, samples, {.offset = offset});
    EXPECT_TRUE(result.values.allFinite());
    EXPECT_EQ(result.outcomes.missing, 0U);
  }
}

TEST(ExtremeShapes, UseALargerOffsetIfTheGridWouldExceedTheMemoryLimit) {
  // A vertex that no triangle uses has no value, at a larger offset as at any other.
  Shape sphere = test::sphere(1, 3);
  sphere.vertices.conservativeResize(sphere.vertices.rows() + 1, Eigen::NoChange);
  sphere.vertices.bottomRows<1>().setZero();
  const Samples samples = sample_shape(sphere, SampleSite::vertices);
  const OffsetSdfResult small = offset_sdf(sphere, samples, {.offset = 2e-6});
  EXPECT_GT(small.offset, 2e-6);
  EXPECT_LT(small.offset, 2e-3);
  const auto values = small.values.head(small.values.size() - 1);
  EXPECT_NEAR(values.minCoeff(), 2, 0.06);
  EXPECT_NEAR(values.maxCoeff(), 2, 0.06);
  EXPECT_EQ(small.outcomes.missing, 1U);
  EXPECT_EQ(small.outcomes.enlarged, small.outcomes.total - 1);
  const OffsetSdfResult standard = offset_sdf(sphere, samples, {.offset = 0.05});
  EXPECT_EQ(standard.offset, 0.05);
  EXPECT_EQ(standard.outcomes.enlarged, 0U);
}

TEST(ExtremeShapes, TinyPartsAreNotThickerThanTheirEdges) {
  const double size = 1e-4;
  const double offset = 0.005;  // joins few of the parts
  const Shape parts = many_tetrahedra(500, size);
  const OffsetSdfResult result = offset_sdf(parts, sample_shape(parts, SampleSite::faces), {.offset = offset});
  std::vector<double> values(result.values.begin(), result.values.end());
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  // No part is thicker than its longest edge; each end of the ray is exact to 1e-3 r.
  EXPECT_LE(*middle, std::sqrt(2.0) * size + 2e-3 * offset * bounding_box_diagonal(parts));
}

TEST(ExtremeShapes, HaveAnOffsetSdfForAnOffsetAsLargeAsTheShape) {
  const Shape sphere = test::sphere(1, 3);
  const Eigen::VectorXd values = values_of(sphere, OffsetSdfOptions::offset_bounds.high);
  const double r = bounding_box_diagonal(sphere);
  EXPECT_GE(values.minCoeff(), 1.95 - 2e-3 * r);
  EXPECT_LE(values.maxCoeff(), 2 + 2e-3 * r);
}

/// A ball, and next to it triangles of length 0.9 and decreasing width, in all directions.
Shape ball_with_slivers(int count) {
  std::vector<Shape> parts{test::sphere(0.3, 2)};
  for (int i = 0; i < count; ++i) {
    const double width = std::pow(10, -1 - 12.0 * i / count);
    const Shape sliver{Points{{-0.45, 0, 0}, {0.45, 0, 0}, {0.1, width, 0}}, Triangles{{0, 1, 2}}};
    parts.push_back(test::transformed(sliver, 1, test::rotation(static_cast<unsigned>(i)), {0.3, 0.2, 0.1}));
  }
  return test::joined(parts);
}

TEST(ExtremeShapes, SliversHaveFiniteThickness) {
  const Shape shape = ball_with_slivers(300);
  const Samples faces = sample_shape(shape, SampleSite::faces);
  // The centroids, and points on the slivers themselves: a third from one end, just inside of the longest side.
  const Eigen::Index count = shape.triangles.rows();
  Samples samples{.site = SampleSite::surface,
                  .points = faces.points.replicate<2, 1>(),
                  .normals = faces.normals.replicate<2, 1>(),
                  .weights = faces.weights.replicate<2, 1>(),
                  .triangles = {}};
  for (Eigen::Index i = 0; i < 2 * count; ++i) samples.triangles.push_back(static_cast<std::int32_t>(i % count));
  for (Eigen::Index f = 0; f < count; ++f) {
    const auto corner = [&](int k) { return shape.vertices.row(shape.triangles(f, k)); };
    samples.points.row(count + f) = 0.62 * corner(0) + 0.37 * corner(1) + 0.01 * corner(2);
  }
  for (const double offset : {0.002, 0.003, 0.01, 0.05}) {
    EXPECT_EQ(offset_sdf(shape, samples, {.offset = offset}).outcomes.missing, 0U) << offset;
  }
  EXPECT_EQ(offset_sdf(shape, faces, {.offset = 0.01}).outcomes.missing, 0U);
}

}  // namespace
}  // namespace shapegauge
