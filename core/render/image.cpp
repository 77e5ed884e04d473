#include "shapegauge/core/render/image.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <png.h>
#include <stdexcept>

#include "shapegauge/core/io/atomic_file.h"

namespace shapegauge {

namespace {

constexpr int channels = 4;

std::size_t byte_count(int width, int height) {
  return static_cast<std::size_t>(channels) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// Copies the image into a larger one, its top left corner at the given pixel.
void paste(const Image& image, int left, int top, Image& target) {
  for (int row = 0; row < image.height; ++row) {
    const auto source = image.pixels.begin() + static_cast<std::ptrdiff_t>(byte_count(image.width, row));
    const std::size_t begin = byte_count(target.width, top + row) + byte_count(left, 1);
    std::copy_n(source, byte_count(image.width, 1), target.pixels.begin() + static_cast<std::ptrdiff_t>(begin));
  }
}

}  // namespace

std::string encode_png(const Image& image) {
  if (image.width <= 0 || image.height <= 0 || image.pixels.size() != byte_count(image.width, image.height)) {
    throw std::invalid_argument(
        fmt::format("an image of {} x {} with {} bytes", image.width, image.height, image.pixels.size()));
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

Image contact_sheet(const std::vector<Image>& images, int columns) {
  if (columns < 1) throw std::invalid_argument("a contact sheet needs at least one column");
  int cell_width = 0;
  int cell_height = 0;
  for (const Image& image : images) {
    cell_width = std::max(cell_width, image.width);
    cell_height = std::max(cell_height, image.height);
  }
  const int count = static_cast<int>(images.size());
  Image sheet;
  sheet.width = std::min(columns, count) * cell_width;
  sheet.height = (count + columns - 1) / columns * cell_height;
  sheet.pixels.assign(byte_count(sheet.width, sheet.height), 255);
  for (int i = 0; i < count; ++i) {
    paste(images[i], i % columns * cell_width + (cell_width - images[i].width) / 2,
          i / columns * cell_height + (cell_height - images[i].height) / 2, sheet);
  }
  return sheet;
}

}  // namespace shapegauge
