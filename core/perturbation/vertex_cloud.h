#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// A point cloud without normals: the vertices of the mesh that a triangle uses, in their order; of a cloud, its
/// points. A hole of the mesh is one of the cloud.
Shape vertex_cloud(const Shape& shape);

}  // namespace shapegauge
