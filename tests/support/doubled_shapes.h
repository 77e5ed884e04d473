// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <gtest/gtest.h>
#include <iosfwd>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// Mesh with duplicate triangles, made from a mesh without duplicates (variants_with_duplicates()), and the origin of
/// its elements.
struct ShapeWithDuplicates {
  std::string name;                     ///< kind of duplication, in test messages
  Shape shape;                          ///< mesh with duplicates
  std::vector<std::int32_t> triangles;  ///< per triangle: index of the original triangle that it equals
  std::vector<std::int32_t> vertices;   ///< per vertex: index of the original vertex at the same position
};

/// Returns variants of a mesh with duplicate triangles: one or two copies each, flipped, with separate vertices, of
/// every third triangle only, directly after the original or at the end. The original always precedes its copies.
std::vector<ShapeWithDuplicates> variants_with_duplicates(const Shape& mesh);

/// Mesh with a name for test messages.
struct NamedShape {
  std::string name;  ///< name, such as "torus"
  Shape shape;       ///< the mesh
};

/// Prints the mesh's name in test messages.
void PrintTo(const NamedShape& named, std::ostream* stream);

/// Returns meshes without duplicate triangles: closed, open, with an inner wall, and with triangles that share no
/// vertices.
std::vector<NamedShape> shapes_without_duplicates();

/// Calls check(expected, doubled) for each ShapeWithDuplicates of each of shapes_without_duplicates(); `expected` is
/// the result of compute(shape) for the original mesh.
template <typename Compute, typename Check>
void for_each_variant_with_duplicates(Compute compute, Check check) {
  for (const auto& [name, shape] : shapes_without_duplicates()) {
    const auto expected = compute(shape);
    for (const ShapeWithDuplicates& doubled : variants_with_duplicates(shape)) {
      SCOPED_TRACE(name + ", " + doubled.name);
      check(expected, doubled);
    }
  }
}

}  // namespace shapegauge::test
