#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace shapegauge {

/// 8-bit sRGB.
using Colour = std::array<std::uint8_t, 3>;

/// Colour for a value t in [0, 1] (clamped) on a perceptually uniform map (viridis); a neutral grey where t is NaN.
Colour colour_of(double t);

/// Colours of values on the map whose ends are `lowest` and `highest`. Where these are equal, values below, at and
/// above them have the colours of 0, 1/2 and 1.
std::vector<Colour> colours_of(const Eigen::VectorXd& values, double lowest, double highest);

/// How values become colours.
struct ColourScale {
  double low = 0;                        ///< the value at the lower end of the map
  double high = 1;                       ///< the value at its upper end
  bool logarithmic = false;              ///< even steps of the logarithm; both ends are then above 0
  std::optional<double> threshold = {};  ///< what is less has the colour `below_threshold`
};

/// Colour of values below a threshold: a red that is not on the map.
inline constexpr Colour below_threshold = {214, 39, 40};

/// Colours of values on the scale.
std::vector<Colour> colours_of(const Eigen::VectorXd& values, const ColourScale& scale);

/// 8-bit sRGB with opacity (not premultiplied): four bytes a pixel, row by row from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

/// The image as the bytes of a PNG file. Throws ArgumentError where the number of pixels is not width x height,
/// or zero.
std::string encode_png(const Image& image);

/// Writes the image as a PNG file, whole or not at all. Throws InputError where the file cannot be written.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace shapegauge
