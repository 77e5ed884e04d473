#pragma once

#include <string>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// The shape in the bytes of a Wavefront OBJ file: its `v` and `f` statements (`v`, `v/vt`, `v//vn`, `v/vt/vn`; indices
/// from 1, or negative from the end), with continued lines; everything else is passed over. Polygons become fans; faces
/// of fewer than three vertices leave no triangle. Without faces it is a point cloud; its normals are the `vn`
/// statements, in order, where there are as many as vertices.
///
/// `name` stands in front of messages. Throws InputError, with the line: index 0 or out of range, coordinate missing or
/// not finite.
Shape read_obj(const std::string& bytes, const std::string& name);

/// Throws InputError where no vertex is found in the bytes.
void check_obj_header(const std::string& bytes, const std::string& name);

}  // namespace shapegauge
