// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <gtest/gtest.h>
#include <iosfwd>
#include <string>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// A mesh with duplicate triangles, and their origin.
struct DoubledShape {
  std::string name;
  Shape shape;
  std::vector<std::int32_t> triangles;  ///< per triangle: the one of the mesh given that it is, or is a double of
  std::vector<std::int32_t> vertices;   ///< per vertex: the one of the mesh given whose place it has
};

/// The mesh with triangles duplicated in several ways: twice, three times, flipped, with separate vertices,
/// some only, after the others or between them. The first of each set of duplicates is always the original triangle.
std::vector<DoubledShape> doublings(const Shape& mesh);

/// A named mesh.
struct NamedShape {
  std::string name;
  Shape shape;
};

/// Prints the mesh's name in test messages.
void PrintTo(const NamedShape& named, std::ostream* stream);

/// Meshes without duplicates: closed, open, with an inner wall, and with triangles that share no vertices.
std::vector<NamedShape> shapes_without_doubles();

/// Calls `check(expected, doubled)` for each doubling of each of these meshes; `expected` is what `compute` returns for
/// the mesh.
template <typename Compute, typename Check>
void for_each_doubling(Compute compute, Check check) {
  for (const auto& [name, shape] : shapes_without_doubles()) {
    const auto expected = compute(shape);
    for (const DoubledShape& doubled : doublings(shape)) {
      SCOPED_TRACE(name + ", " + doubled.name);
      check(expected, doubled);
    }
  }
}

}  // namespace shapegauge::test
