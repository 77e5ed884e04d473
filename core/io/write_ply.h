#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "shapegauge/core/render/colour_map.h"
#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Writes a shape, a mesh or a point cloud with its normals, as binary little-endian PLY, whole or not at all.
/// Coordinates are doubles, written exactly. Throws InputError where the file cannot be written, a coordinate is not
/// finite or a triangle's vertex does not exist.
void write_ply(const std::filesystem::path& path, const Shape& shape);

/// Writes a shape with a value and a colour at each of its triangles or vertices, as binary little-endian PLY, whole or
/// not at all. Coordinates and values are doubles, written exactly; the element `face` or `vertex`, as the site says,
/// has the properties `red`, `green`, `blue` and `sdf` (NaN where a value is).
///
/// Throws InputError where the file cannot be written, the numbers of values or colours are not the site's number of
/// samples, a coordinate is not finite or a triangle's vertex does not exist.
void write_ply(const std::filesystem::path& path, const Shape& shape, SampleSite site, const Eigen::VectorXd& values,
               const std::vector<Colour>& colours);

}  // namespace shapegauge
