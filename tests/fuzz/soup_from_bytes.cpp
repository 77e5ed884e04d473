// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/soup_from_bytes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace shapegauge::fuzz {

namespace {

constexpr int most = 60;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// At least 0.1: with sanitizers a finer octree takes many seconds.
constexpr std::array offsets = {0.2, 0.1, 0.15, 0.3, 1.0, 5.0, 100.0, 1e30, 0.0, -1.0, infinity, nan};

class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  /// Next byte, or 0 after the last.
  int next() {
    if (bytes_.empty()) return 0;
    const auto byte = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return byte;
  }

 private:
  std::string_view bytes_;
};

double coordinate(Bytes& bytes, double previous) {
  const int kind = bytes.next();
  if (kind < 176) return (kind % 16 - 8) / 8.0;
  if (kind < 192) return previous;
  if (kind < 224) return (bytes.next() - 128) / 128.0 + (bytes.next() - 128) / 32768.0;
  if (kind < 254) return std::ldexp(bytes.next() - 128, 8 * (bytes.next() - 128));
  return kind == 254 ? infinity : nan;
}

}  // namespace

Measurement measurement_from_bytes(std::string_view text) {
  Bytes bytes(text);
  Measurement measurement;
  Shape& shape = measurement.shape;
  const int kind = bytes.next();
  const bool cloud = (kind & 1) != 0;
  measurement.site = cloud || (kind & 2) != 0 ? SampleSite::vertices : SampleSite::faces;
  measurement.offset = offsets.at(static_cast<std::size_t>(bytes.next()) % offsets.size());
  const int vertices = bytes.next() % (most + 1);
  const int triangles = bytes.next() % (most + 1);
  shape.vertices.resize(vertices, 3);
  for (int i = 0; i < vertices; ++i) {
    for (int k = 0; k < 3; ++k) shape.vertices(i, k) = coordinate(bytes, i > 0 ? shape.vertices(i - 1, k) : 0);
  }
  shape.triangles.resize(cloud ? 0 : triangles, 3);
  for (Eigen::Index i = 0; i < shape.triangles.size(); ++i) {
    const int index = bytes.next();
    shape.triangles.data()[i] = index == 255 ? -1 : index % (vertices + (index >= 240 ? 1 : 0) + (vertices == 0));
  }
  return measurement;
}

}  // namespace shapegauge::fuzz
