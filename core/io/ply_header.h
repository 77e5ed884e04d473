#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shapegauge/core/io/text_scanner.h"

namespace shapegauge {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  bool list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::int64_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
};

/// Reads a PLY file's header (Greg Turk, "The PLY Polygon File Format") and leaves the scanner at the first byte of the
/// body. Throws InputError, with the line, where it is not one.
PlyHeader read_ply_header(TextScanner& scanner);

}  // namespace shapegauge
