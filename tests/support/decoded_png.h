// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <png.h>
#include <string>

#include "shapegauge/core/render/image.h"

namespace shapegauge::test {

/// Decodes the bytes of a PNG file to RGBA pixels; fails the test if they are invalid.
inline Image decoded(const std::string& png) {
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  EXPECT_NE(png_image_begin_read_from_memory(&header, png.data(), png.size()), 0);
  header.format = PNG_FORMAT_RGBA;
  Image image{.width = static_cast<int>(header.width), .height = static_cast<int>(header.height), .pixels = {}};
  image.pixels.resize(PNG_IMAGE_SIZE(header));
  EXPECT_NE(png_image_finish_read(&header, nullptr, image.pixels.data(), 0, nullptr), 0);
  return image;
}

}  // namespace shapegauge::test
