// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/render/image.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <png.h>
#include <stdexcept>

#include "shapegauge/core/base/error.h"
#include "shapegauge/core/io/file_bytes.h"

namespace shapegauge {

namespace {

constexpr Colour no_value = {160, 160, 160};

/// Every 15th of the 256 colours of viridis (Stéfan van der Walt and Nathaniel Smith, public domain, CC0).
constexpr std::array<std::array<double, 3>, 18> viridis = {{{0.267004, 0.004874, 0.329415},
                                                            {0.281924, 0.089666, 0.412415},
                                                            {0.280255, 0.165693, 0.476498},
                                                            {0.263663, 0.237631, 0.518762},
                                                            {0.237441, 0.305202, 0.541921},
                                                            {0.208623, 0.367752, 0.552675},
                                                            {0.182256, 0.426184, 0.557120},
                                                            {0.159194, 0.482237, 0.558073},
                                                            {0.137770, 0.537492, 0.554906},
                                                            {0.121148, 0.592739, 0.544641},
                                                            {0.128087, 0.647749, 0.523491},
                                                            {0.180653, 0.701402, 0.488189},
                                                            {0.274149, 0.751988, 0.436601},
                                                            {0.395174, 0.797475, 0.367757},
                                                            {0.535621, 0.835785, 0.281908},
                                                            {0.688944, 0.865448, 0.182725},
                                                            {0.845561, 0.887322, 0.099702},
                                                            {0.993248, 0.906157, 0.143936}}};

constexpr int bytes_per_pixel = 4;

std::size_t byte_count(int width, int height) {
  return static_cast<std::size_t>(bytes_per_pixel) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

}  // namespace

Colour colour_of(double t) {
  if (std::isnan(t)) return no_value;
  const double position = std::clamp(t, 0.0, 1.0) * (viridis.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(position), viridis.size() - 2);
  const double part = position - static_cast<double>(below);
  Colour colour = {};
  for (std::size_t k = 0; k < colour.size(); ++k) {
    colour[k] = static_cast<std::uint8_t>(std::lround(255 * std::lerp(viridis[below][k], viridis[below + 1][k], part)));
  }
  return colour;
}

std::vector<Colour> colours_of(const Eigen::VectorXd& values, double lowest, double highest) {
  std::vector<Colour> colours;
  colours.reserve(static_cast<std::size_t>(values.size()));
  for (const double value : values) {
    double t = (value - lowest) / (highest - lowest);
    if (lowest == highest && !std::isnan(value)) t = value < lowest ? 0 : (value > highest ? 1 : 0.5);
    colours.push_back(colour_of(t));
  }
  return colours;
}

std::vector<Colour> colours_of(const Eigen::VectorXd& values, const ColourScale& scale) {
  const auto on_map = [&](const Eigen::ArrayXd& mapped, double low, double high) {
    return colours_of(Eigen::VectorXd(mapped), low, high);
  };
  std::vector<Colour> colours =
      scale.logarithmic ? on_map(values.array().max(scale.low * 1e-9).log(), std::log(scale.low), std::log(scale.high))
                        : on_map(values.array(), scale.low, scale.high);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const double value = values[static_cast<Eigen::Index>(i)];
    if (std::isnan(value)) colours[i] = no_value;  // the largest of it and a number may be the number
    if (scale.threshold && value < *scale.threshold) colours[i] = below_threshold;
  }
  return colours;
}

std::string encode_png(const Image& image) {
  if (image.width <= 0 || image.height <= 0 || image.pixels.size() != byte_count(image.width, image.height)) {
    throw ArgumentError(fmt::format("an image of {} x {} pixels with {} bytes; expected 3 bytes per pixel", image.width,
                                    image.height, image.pixels.size()));
  }
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGBA;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(header), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr) == 0) {
    throw std::runtime_error(fmt::format("the image could not be encoded as PNG: {}", header.message));
  }
  bytes.resize(size);
  bytes.shrink_to_fit();
  return bytes;
}

void write_png(const std::filesystem::path& path, const Image& image) {
  write_file_atomically(path, encode_png(image));
}

}  // namespace shapegauge
