#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdint>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Double precision, and the marks of deleted and locked parts that decimation needs.
struct DecimationTraits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using DecimationMesh = OpenMesh::TriMesh_ArrayKernelT<DecimationTraits>;

/// A triangle soup as a half-edge mesh that can be decimated.
struct DecimationInput {
  DecimationMesh mesh;                   ///< in the shape's unit frame
  std::vector<std::int32_t> vertices;    ///< of the shape, by vertex of the mesh; the first at the same place
  std::vector<bool> turned;              ///< by face of the mesh, whether it has the other orientation in the shape
  std::vector<std::int32_t> left_aside;  ///< the shape's triangles that the mesh cannot hold
};

/// Takes vertices at the same place as one, leaves out faces whose corners are not at three places, turns faces so that
/// neighbours agree, and cuts the surface open along edges where not just two faces meet in agreement. Vertices on such
/// edges, and those of triangles left aside, are locked.
DecimationInput decimation_input(const Shape& shape);

}  // namespace shapegauge
