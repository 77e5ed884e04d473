// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <limits>

#include "shapegauge/core/render/image.h"
#include "shapegauge/experiments/signatures/model_picture.h"
#include "tests/support/decoded_png.h"
#include "tests/support/test_shapes.h"

namespace shapegauge {

namespace {

using test::decoded;

/// Mean of a channel over the pixels fully covered by the shape.
double mean_channel(const Image& image, std::size_t channel) {
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    if (image.pixels[i + 3] < 255) continue;
    sum += image.pixels[i + channel];
    ++count;
  }
  return sum / count;
}

std::string picture_of(const Shape& shape, SampleSite site, double value) {
  const Samples samples = site == SampleSite::surface ? sample_surface(shape, 800) : sample_shape(shape, site);
  return model_picture(shape, samples, Eigen::VectorXd::Constant(samples.points.rows(), value), {}, {0, 0, 1});
}

TEST(ModelPicture, HasTheRequestedSizeAndATransparentBackground) {
  const Image image = decoded(picture_of(test::sphere(1, 3), SampleSite::faces, 0.3));
  const PictureOptions options;
  EXPECT_EQ(image.width, options.width);
  EXPECT_EQ(image.height, options.height);
  EXPECT_EQ(image.pixels[3], 0) << "a corner";
  EXPECT_EQ(image.pixels[static_cast<std::size_t>(4 * (image.height / 2 * image.width + image.width / 2)) + 3], 255);
}

TEST(ModelPicture, ShowsEqualValuesInEqualColoursForEverySampling) {
  const Shape sphere = test::sphere(1, 4);
  const Image faces = decoded(picture_of(sphere, SampleSite::faces, 0.1));
  for (const SampleSite site : {SampleSite::vertices, SampleSite::surface}) {
    const Image other = decoded(picture_of(sphere, site, 0.1));
    // Splats are a little larger than the surface, and their shading is flat.
    for (const std::size_t channel : {0, 1, 2})
      EXPECT_NEAR(mean_channel(other, channel), mean_channel(faces, channel), 12);
  }
}

TEST(ModelPicture, ShowsLargeValuesYellowSmallValuesPurpleAndMissingValuesGrey) {
  const Shape sphere = test::sphere(1, 3);
  const auto colour = [&](double value) {
    const Image image = decoded(picture_of(sphere, SampleSite::faces, value));
    return Eigen::Vector3d(mean_channel(image, 0), mean_channel(image, 1), mean_channel(image, 2));
  };
  const Eigen::Vector3d large = colour(7);
  EXPECT_GT(large[0], 3 * large[2]);
  const Eigen::Vector3d small = colour(-1);
  EXPECT_GT(small[2], 5 * small[1]);
  EXPECT_EQ(small, colour(0));
  const Eigen::Vector3d none = colour(std::numeric_limits<double>::quiet_NaN());
  EXPECT_NEAR(none[0], none[1], 1e-9);
  EXPECT_NEAR(none[0], none[2], 1e-9);
}

TEST(ModelPicture, ShowsPointClouds) {
  const Shape cloud = test::random_points(test::sphere(1, 4), 800, 1);
  EXPECT_GT(mean_channel(decoded(picture_of(cloud, SampleSite::faces, 0.56)), 0), 100);
}

TEST(ModelPicture, ShowsACloudWithASubsetOfPointsSampled) {
  const Shape cloud = test::random_points(test::sphere(1, 4), 3000, 1);
  EXPECT_NEAR(mean_channel(decoded(picture_of(cloud, SampleSite::surface, 0.3)), 0),
              mean_channel(decoded(picture_of(cloud, SampleSite::faces, 0.3)), 0), 12);
}

TEST(ModelPicture, ShowsTheRequestedAxisUpright) {
  const Shape pillar = test::box({1, 1, 4}, 1);
  const Samples samples = sample_shape(pillar, SampleSite::faces);
  /// Covered rows of the middle column.
  const auto height = [&](const Eigen::Vector3d& up) {
    const Image image = decoded(model_picture(pillar, samples, samples.weights, {}, up));
    int rows = 0;
    for (int row = 0; row < image.height; ++row)
      rows += image.pixels[static_cast<std::size_t>(4 * (row * image.width + image.width / 2)) + 3] == 255 ? 1 : 0;
    return rows;
  };
  EXPECT_GT(height({0, 0, 1}), 2 * height({0, 1, 0}));
}

}  // namespace

}  // namespace shapegauge
