#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace shapegauge {

/// 8-bit sRGB with opacity (not premultiplied): four bytes a pixel, row by row from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

/// The image as the bytes of a PNG file. Throws std::invalid_argument where the number of pixels is not width x height,
/// or zero.
std::string encode_png(const Image& image);

/// Writes the image as a PNG file, whole or not at all. Throws InputError where the file cannot be written.
void write_png(const std::filesystem::path& path, const Image& image);

/// The images side by side, row by row, on white; each is centred in a cell of the size of the largest. Throws
/// std::invalid_argument for no columns.
Image contact_sheet(const std::vector<Image>& images, int columns);

}  // namespace shapegauge
