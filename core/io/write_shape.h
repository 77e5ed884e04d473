#pragma once

#include <filesystem>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Writes a shape to a file, whole or not at all.
using ShapeWriter = void (*)(const std::filesystem::path&, const Shape&);

/// The writer for the format that the name's extension tells: .off (write_off) or .ply (write_ply). Throws InputError
/// for another extension.
ShapeWriter shape_writer(const std::filesystem::path& path);

}  // namespace shapegauge
