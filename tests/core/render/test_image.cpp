// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/render/image.h"
#include "tests/support/decoded_png.h"

namespace shapegauge {

namespace {

using test::decoded;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(ColourMap, MatchesPublishedColoursOfViridis) {
  // Entries 0, 85, 127, 170 and 255 of the published table of 256, rounded to 8 bits; between stored entries
  // linear interpolation is at most one step off.
  const std::vector<std::pair<int, Colour>> published = {{0, {68, 1, 84}},      {28, {72, 40, 120}},
                                                         {85, {49, 104, 142}},  {127, {33, 144, 141}},
                                                         {170, {53, 183, 121}}, {255, {253, 231, 37}}};
  for (const auto& [index, colour] : published) {
    const Colour ours = colour_of(index / 255.0);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(ours[k], colour[k], 1) << index << " " << k;
  }
}

TEST(ColourMap, LightnessIncreasesMonotonically) {
  double previous = -1;
  for (int i = 0; i <= 100; ++i) {
    const Colour colour = colour_of(i / 100.0);
    const double luminance = 0.2126 * std::pow(colour[0] / 255.0, 2.2) + 0.7152 * std::pow(colour[1] / 255.0, 2.2) +
                             0.0722 * std::pow(colour[2] / 255.0, 2.2);
    EXPECT_GT(luminance, previous) << i;
    previous = luminance;
  }
}

TEST(ColourMap, ClampsValuesAndShowsNanInGrey) {
  EXPECT_EQ(colour_of(-infinity), colour_of(0));
  EXPECT_EQ(colour_of(7), colour_of(1));
  const Colour grey = colour_of(nan);
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[1], grey[2]);
}

TEST(ColourMap, MapsARangeOfValuesLinearly) {
  const std::vector<Colour> colours = colours_of(Eigen::Vector4d(2, 4, 3, nan), 2, 4);
  EXPECT_EQ(colours, (std::vector<Colour>{colour_of(0), colour_of(1), colour_of(0.5), colour_of(nan)}));
}

TEST(ColourMap, ShowsTheValueOfAZeroWidthRangeInTheMiddleColour) {
  const std::vector<Colour> colours = colours_of(Eigen::Vector4d(1, 2, 3, nan), 2, 2);
  EXPECT_EQ(colours, (std::vector<Colour>{colour_of(0), colour_of(0.5), colour_of(1), colour_of(nan)}));
}

Image gradient(int width, int height, int seed) {
  Image image{.width = width, .height = height, .pixels = {}};
  for (int i = 0; i < 4 * width * height; ++i) image.pixels.push_back(static_cast<std::uint8_t>(seed + 37 * i));
  return image;
}

TEST(Image, PngContainsThePixels) {
  const Image image = gradient(7, 5, 1);
  const Image back = decoded(encode_png(image));
  EXPECT_EQ(back.width, 7);
  EXPECT_EQ(back.height, 5);
  EXPECT_EQ(back.pixels, image.pixels);
}

TEST(Image, WritesTheEncodedPngToAFile) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "shapegauge_image.png";
  const Image image = gradient(9, 4, 2);
  write_png(path, image);
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  EXPECT_EQ(bytes.str(), encode_png(image));
  std::filesystem::remove(path);
}

TEST(Image, RejectsEmptyImagesAndMissingPixels) {
  EXPECT_THROW(encode_png(Image{}), ArgumentError);
  Image short_of_a_pixel = gradient(3, 3, 0);
  short_of_a_pixel.pixels.resize(32);
  EXPECT_THROW(encode_png(short_of_a_pixel), ArgumentError);
}

}  // namespace

}  // namespace shapegauge
