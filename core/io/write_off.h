#pragma once

#include <filesystem>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Writes a shape as ASCII OFF (a point cloud that has normals as NOFF), whole or not at all. Coordinates are written
/// with the fewest digits that give exactly the same doubles when they are read; the same shape gives the same bytes.
/// Throws InputError where the file cannot be written, a coordinate is not finite or a triangle's vertex does not
/// exist.
void write_off(const std::filesystem::path& path, const Shape& shape);

}  // namespace shapegauge
