#pragma once

#include <filesystem>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Throws InputError where a file of this shape at `path` could not be read again: a coordinate that is not finite, a
/// triangle with a vertex that does not exist.
void require_writable(const std::filesystem::path& path, const Shape& shape);

}  // namespace shapegauge
