// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace shapegauge {

/// 8-bit sRGB colour: red, green, blue.
using Colour = std::array<std::uint8_t, 3>;

/// Returns the colour at t in [0, 1] (clamped) of the perceptually uniform colour map viridis; neutral grey for NaN.
Colour colour_of(double t);

/// Maps values to the colour map (colour_of()), linearly: `lowest` to 0 and `highest` to 1. If the two are equal,
/// values below, at and above them have the colours of 0, 1/2 and 1.
std::vector<Colour> colours_of(const Eigen::VectorXd& values, double lowest, double highest);

/// Scale by which colours_of() maps values to the colour map.
struct ColourScale {
  double low = 0;                        ///< value at the lower end of the colour map
  double high = 1;                       ///< value at the upper end of the colour map
  bool logarithmic = false;              ///< logarithmic scale; both ends are then above 0
  std::optional<double> threshold = {};  ///< values below it have the colour `below_threshold`; absent: no threshold
};

/// Colour of values below a threshold: a red that is not in the colour map.
inline constexpr Colour below_threshold = {214, 39, 40};

/// Maps each value to its colour on a scale.
std::vector<Colour> colours_of(const Eigen::VectorXd& values, const ColourScale& scale);

/// 8-bit sRGB image with opacity (not premultiplied).
struct Image {
  int width = 0;                     ///< width of the image in pixels
  int height = 0;                    ///< height of the image in pixels
  std::vector<std::uint8_t> pixels;  ///< red, green, blue and opacity of each pixel, row by row from the top
};

/// Returns the bytes of an image encoded as PNG. Throws ArgumentError if the number of pixels is zero or not width x
/// height.
std::string encode_png(const Image& image);

/// Writes an image as a PNG file, atomically. Throws InputError if the file cannot be written.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace shapegauge
