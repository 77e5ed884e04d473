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

/// 8-bit sRGB colour.
using Colour = std::array<std::uint8_t, 3>;

/// Maps t in [0, 1] (clamped) to a perceptually uniform colour map (viridis); NaN to neutral grey.
Colour colour_of(double t);

/// Maps values to the colour map from `lowest` to `highest`. If these are equal, values below, at and above them have
/// the colours of 0, 1/2 and 1.
std::vector<Colour> colours_of(const Eigen::VectorXd& values, double lowest, double highest);

/// Scale by which colours_of() maps values to the colour map.
struct ColourScale {
  double low = 0;                        ///< value at the lower end of the map
  double high = 1;                       ///< value at the upper end of the map
  bool logarithmic = false;              ///< logarithmic scale; both ends are then above 0
  std::optional<double> threshold = {};  ///< smaller values have the colour `below_threshold`; none if absent
};

/// Colour of values below a threshold: a red that is not on the map.
inline constexpr Colour below_threshold = {214, 39, 40};

/// Maps each value to its colour on a scale.
std::vector<Colour> colours_of(const Eigen::VectorXd& values, const ColourScale& scale);

/// 8-bit sRGB image with opacity (not premultiplied): four bytes per pixel, row by row from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

/// Encodes an image as PNG. Throws ArgumentError if the number of pixels is zero or not width x height.
std::string encode_png(const Image& image);

/// Writes an image as a PNG file, atomically. Throws InputError if the file cannot be written.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace shapegauge
