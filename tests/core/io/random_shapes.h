// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck.h>
#include <vector>

#include "shapegauge/core/shape/shape.h"

namespace shapegauge::test {

/// Any finite double, including denormals and -0.
rc::Gen<double> any_finite();

/// Random vertices and random faces of 3 to 6 corners, among them duplicate, degenerate and non-manifold faces and
/// unused vertices.
struct Polygons {
  Points vertices;
  std::vector<std::vector<std::int32_t>> faces;
};
rc::Gen<Polygons> any_polygons(bool triangles_only);

/// Expected shape, with polygons triangulated as by the readers.
Shape shape_of(const Polygons& polygons);

}  // namespace shapegauge::test
