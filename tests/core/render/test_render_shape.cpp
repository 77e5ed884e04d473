// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <numbers>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/render/render_shape.h"
#include "shapegauge/core/shape/samples.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

constexpr Colour red = {200, 0, 0};
constexpr Colour green = {0, 200, 0};

RenderOptions small_transparent() {
  RenderOptions options;
  options.width = 120;
  options.height = 90;
  options.transparent = true;
  return options;
}

std::vector<Colour> all(Colour colour, Eigen::Index count) { return {static_cast<std::size_t>(count), colour}; }

Image render(const Shape& shape, const RenderOptions& options) {
  return render_shape(shape, all(red, shape.triangles.rows()), SampleSite::faces, options);
}

/// Covered part of the image, in pixels.
double covered(const Image& image) {
  double sum = 0;
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) sum += image.pixels[i] / 255.0;
  return sum;
}

const std::uint8_t* pixel(const Image& image, int column, int row) {
  return &image.pixels[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                            static_cast<std::size_t>(column))];
}

TEST(RenderShape, ShowsASphereAsADiscThatFillsTheHeight) {
  const RenderOptions options = small_transparent();
  const Image image = render(test::sphere(1, 5), options);
  const double radius = 0.5 * options.height * (1 - 2 * options.margin);
  // Rays sample the outline every 1/rays_per_side pixels; the error along it is at most half of that.
  const double bound = 2 * std::numbers::pi * radius * 0.5 / options.rays_per_side;
  EXPECT_NEAR(covered(image), std::numbers::pi * radius * radius, bound);
}

TEST(RenderShape, ShowsABoxAsARectangleFromTheFront) {
  RenderOptions options = small_transparent();
  options.towards_viewer = {0, 0, 2};
  const Image image = render(test::box({2, 1, 7}, 1), options);
  const double width = options.width * (1 - 2 * options.margin);
  EXPECT_NEAR(covered(image), width * width / 2, 1.5 * width / options.rays_per_side);
  EXPECT_EQ(pixel(image, 60, 45)[3], 255);
  EXPECT_EQ(pixel(image, 60, 10)[3], 0);
}

TEST(RenderShape, LeavesNoHolesBetweenTriangles) {
  RenderOptions options = small_transparent();
  options.towards_viewer = {0, 0, 1};
  options.margin = 0;
  options.width = options.height = 45;
  options.rays_per_side = 1;
  // Each ray passes through a corner of the 90 x 90 squares of a side.
  const Shape box = test::box({1, 1, 1}, 90);
  EXPECT_DOUBLE_EQ(covered(render(box, options)), 45 * 45);
  // Still convex after rotation.
  options.towards_viewer = {0.3, 0.2, 1};
  options.up = {0.1, 1, 0};
  const Image turned = render(box, options);
  for (int row = 0; row < options.height; ++row) {
    int changes = 0;
    for (int column = 1; column < options.width; ++column) {
      changes += pixel(turned, column, row)[3] != pixel(turned, column - 1, row)[3] ? 1 : 0;
    }
    EXPECT_LE(changes, 2) << row;
  }
}

TEST(RenderShape, IsInvariantToSizeAndPosition) {
  const RenderOptions options = small_transparent();
  const Shape torus = test::torus(3, 1, 20, 40);
  const double expected = covered(render(torus, options));
  for (const double scale : {1e-30, 1e30}) {
    const Shape moved = test::transformed(torus, scale, Eigen::Matrix3d::Identity(), {7 * scale, scale, scale});
    EXPECT_NEAR(covered(render(moved, options)), expected, 1) << scale;
  }
}

TEST(RenderShape, GivesTheSamePixelsOnAnyNumberOfThreads) {
  const Shape torus = test::torus(3, 1, 20, 40);
  const tbb::global_control more_threads_than_cores(tbb::global_control::max_allowed_parallelism, 8);
  const auto bytes = [&](int threads) {
    return tbb::task_arena(threads).execute([&] { return encode_png(render(torus, RenderOptions{})); });
  };
  EXPECT_EQ(bytes(1), bytes(7));
}

TEST(RenderShape, HasAnOpaqueBackgroundIfWhiteIsRequested) {
  RenderOptions options = small_transparent();
  options.transparent = false;
  const Image image = render(test::sphere(1, 3), options);
  EXPECT_NEAR(covered(image), options.width * options.height, 1e-9);
  for (int k = 0; k < 4; ++k) EXPECT_EQ(pixel(image, 0, 0)[k], 255);
}

TEST(RenderShape, ShowsTrianglesInTheirColours) {
  RenderOptions options = small_transparent();
  options.towards_viewer = {0, 0, 1};
  const Shape box = test::box({2, 2, 2}, 1);
  const Samples samples = sample_shape(box, SampleSite::faces);
  std::vector<Colour> colours;
  for (Eigen::Index f = 0; f < box.triangles.rows(); ++f) colours.push_back(samples.normals(f, 2) > 0.5 ? green : red);
  const Image front = render_shape(box, colours, SampleSite::faces, options);
  EXPECT_EQ(pixel(front, 60, 45)[0], 0);
  EXPECT_GT(pixel(front, 60, 45)[1], 100);
  options.towards_viewer = {0, 0, -1};
  const Image back = render_shape(box, colours, SampleSite::faces, options);
  EXPECT_GT(pixel(back, 60, 45)[0], 100);
  EXPECT_EQ(pixel(back, 60, 45)[1], 0);
}

TEST(RenderShape, ShowsTheNearerPartOfIntersectingSheets) {
  RenderOptions options = small_transparent();
  options.towards_viewer = {0, 0, 1};
  const Shape sheets{
      .vertices =
          Points{{-1, -1, -1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, 1}},
      .triangles = Triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
  const Image image = render_shape(sheets, {red, red, green, green}, SampleSite::faces, options);
  for (const int row : {20, 40, 70}) {
    EXPECT_GT(pixel(image, 80, row)[0], pixel(image, 80, row)[1]) << "red rises to the right; row " << row;
    EXPECT_GT(pixel(image, 40, row)[1], pixel(image, 40, row)[0]) << "green rises to the left; row " << row;
  }
}

TEST(RenderShape, InterpolatesTheColoursOfVertices) {
  RenderOptions options = small_transparent();
  options.towards_viewer = {0, 0, 1};
  const Shape box = test::box({2, 1, 1}, 1);
  std::vector<Colour> colours;
  for (Eigen::Index v = 0; v < box.vertices.rows(); ++v) colours.push_back(box.vertices(v, 0) < 0 ? red : green);
  const Image image = render_shape(box, colours, SampleSite::vertices, options);
  const auto green_part = [&](int column) {
    const double r = pixel(image, column, 45)[0];
    const double g = pixel(image, column, 45)[1];
    return g / (r + g);
  };
  const double left = options.margin * options.width;
  const double width = options.width - 2 * left;
  for (const int column : {20, 60, 100}) EXPECT_NEAR(green_part(column), (column + 0.5 - left) / width, 0.02);
}

TEST(RenderShape, ShowsReversedTrianglesLikeOutwardOnes) {
  const Shape torus = test::torus(3, 1, 20, 40);
  EXPECT_EQ(render(torus, small_transparent()).pixels, render(test::flipped(torus), small_transparent()).pixels);
}

TEST(RenderShape, LightsTheShapeFromAbove) {
  RenderOptions options = small_transparent();
  options.towards_viewer = {0, 0, 1};
  const Image image = render(test::sphere(1, 4), options);
  EXPECT_GT(pixel(image, 60, 15)[0], pixel(image, 60, 75)[0] + 20);
}

TEST(RenderShape, AcceptsALineSegmentSeenEndOn) {
  RenderOptions options = small_transparent();
  options.towards_viewer = {0, 0, 1};
  EXPECT_NO_THROW(render(test::box({0, 0, 1}, 1), options));
}

TEST(RenderShape, ShowsACloudLikeItsSurface) {
  const RenderOptions options = small_transparent();
  const Shape sphere = test::sphere(1, 5);
  const Shape cloud = test::random_points(sphere, 5000, 1);
  const Image image = render_shape(cloud, all(red, 5000), SampleSite::vertices, options);
  const Image of_mesh = render(sphere, options);
  // Hexagons with 3 % of the sphere's radius protrude beyond the rim and leave few holes.
  EXPECT_NEAR(covered(image) / covered(of_mesh), 1, 0.02);
  double difference = 0;
  double pixels = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    if (image.pixels[i + 3] < 255 || of_mesh.pixels[i + 3] < 255) continue;
    difference += std::abs(image.pixels[i] - of_mesh.pixels[i]);
    ++pixels;
  }
  EXPECT_LT(difference / pixels, 5);
}

TEST(RenderShape, ShowsPointsOfACloudInTheirColours) {
  RenderOptions options = small_transparent();
  options.towards_viewer = {0, 0, 1};
  const Shape cloud = test::random_points(test::sphere(1, 4), 5000, 1);
  std::vector<Colour> colours;
  for (Eigen::Index v = 0; v < 5000; ++v) colours.push_back(cloud.vertices(v, 0) < 0 ? red : green);
  const Image image = render_shape(cloud, colours, SampleSite::vertices, options);
  EXPECT_GT(pixel(image, 40, 45)[0], 100);
  EXPECT_EQ(pixel(image, 40, 45)[1], 0);
  EXPECT_EQ(pixel(image, 80, 45)[0], 0);
  EXPECT_GT(pixel(image, 80, 45)[1], 100);
}

TEST(RenderShape, RejectsMismatchedColoursOptionsOutOfRangeAndShapesWithoutExtent) {
  const Shape sphere = test::sphere(1, 1);
  EXPECT_THROW(render(Shape{}, {}), InputError);
  EXPECT_THROW(render(test::box({0, 0, 0}, 1), {}), InputError);
  EXPECT_THROW(render_shape(sphere, all(red, 3), SampleSite::faces), InputError);
  EXPECT_THROW(render_shape({Points::Ones(20, 3), {}, {}}, all(red, 20), SampleSite::vertices), InputError);
  const auto with = [&](auto change) {
    RenderOptions options;
    change(options);
    return render(sphere, options);
  };
  EXPECT_THROW(with([](RenderOptions& o) { o.width = 0; }), InputError);
  EXPECT_THROW(with([](RenderOptions& o) { o.height = 100000; }), InputError);
  EXPECT_THROW(with([](RenderOptions& o) { o.rays_per_side = 0; }), InputError);
  EXPECT_THROW(with([](RenderOptions& o) { o.margin = 0.5; }), InputError);
  EXPECT_THROW(with([](RenderOptions& o) { o.up = o.towards_viewer; }), InputError);
  EXPECT_THROW(with([](RenderOptions& o) { o.up.setZero(); }), InputError);
  EXPECT_THROW(with([](RenderOptions& o) { o.towards_viewer.setConstant(std::nan("")); }), InputError);
}

}  // namespace

}  // namespace shapegauge
