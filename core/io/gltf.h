// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "shapegauge/core/io/shape_source.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

struct ShapeFormat;

/// Reads the meshes of a glTF 2.0 file (JSON or binary, GLB), placed by the nodes of its scene: triangles, strips and
/// fans, or points if there is nothing else. By the standard, coordinates are in metres and y is up. Vertices and faces
/// keep the order of nodes and primitives; a mesh used by several nodes occurs several times. Materials, images, skins,
/// morph targets and animations are ignored. Buffers may be in the file, in data URIs or in files next to it.
///
/// Throws InputError for files that are not glTF, compressed meshes (Draco, meshopt), missing or truncated buffers,
/// indices out of range, coordinates that are not finite, cyclic nodes, and scenes of more than 100 million vertices.
Shape read_gltf(const ShapeSource& source);

/// Returns the names of the neighbouring files that hold the buffers.
std::vector<std::string> gltf_neighbours(const ShapeSource& source);

/// Throws InputError if the bytes do not begin like a glTF file.
void check_gltf_header(const std::string& bytes, const std::string& name);

/// Returns the format for shape_formats().
ShapeFormat gltf_format();

}  // namespace shapegauge
