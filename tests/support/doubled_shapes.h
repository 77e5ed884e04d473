#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// A mesh whose triangles are doubled, and of what.
struct DoubledShape {
  std::string name;
  Shape shape;
  std::vector<std::int32_t> triangles;  ///< by triangle: the one of the mesh given that it is, or is a double of
  std::vector<std::int32_t> vertices;   ///< by vertex: the one of the mesh given whose place it has
};

/// The mesh with doubled triangles in several ways: twice, three times, turned over, each with vertices of its own,
/// some only, after the others or between them. The first of each set of doubles is always the mesh's own triangle.
std::vector<DoubledShape> doublings(const Shape& mesh);

/// A name and a mesh.
struct NamedShape {
  std::string name;
  Shape shape;
};

/// Names the mesh in the messages of tests.
void PrintTo(const NamedShape& named, std::ostream* stream);

/// Meshes without doubles: a closed one, an open one, one with an inner wall, and triangles that share no vertices.
std::vector<NamedShape> shapes_without_doubles();

}  // namespace shapegauge::test
