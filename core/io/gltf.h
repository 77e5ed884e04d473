#pragma once

#include <string>
#include <vector>

#include "shapegauge/core/io/shape_format.h"
#include "shapegauge/core/io/shape_source.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct ShapeFormat;

/// Reads the meshes of a glTF 2.0 file (JSON, or binary: GLB), placed by the nodes of its scene: triangles, strips and
/// fans, and points where there is nothing else. Coordinates are in metres by the standard, and y is up. Vertices and
/// faces keep the order of nodes and primitives; a mesh that several nodes have occurs as often. Materials, pictures,
/// skins, morph targets and animations are passed over. Buffers are in the file, in data URIs or in files beside it.
///
/// Throws InputError for what is no glTF, compressed meshes (Draco, meshopt), buffers that are absent or too short,
/// indices out of range, coordinates that are not finite, nodes that form a circle, and scenes of more than 100 million
/// vertices.
Shape read_gltf(const ShapeSource& source);

/// The names of the files beside it that hold its buffers.
std::vector<std::string> gltf_neighbours(const ShapeSource& source);

/// Throws InputError where the bytes do not begin like a glTF file.
void check_gltf_header(const std::string& bytes, const std::string& name);

/// The format for shape_formats().
ShapeFormat gltf_format();

}  // namespace shapegauge
