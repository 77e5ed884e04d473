#pragma once

#include <string_view>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge::fuzz {

/// A shape and what to measure on it.
struct Measurement {
  Shape shape;
  SampleSite site = SampleSite::faces;
  double offset = 0;
};

/// A measurement that any bytes stand for; bytes that are missing count as zeros. The first byte: its lowest bit makes
/// a point cloud, its second one samples at the vertices. The second byte chooses the offset, an unusable one among
/// others. The third and the fourth are the numbers of vertices and triangles (at most 60 of each), which follow: three
/// coordinates (see coordinate() in the source: on a small grid, repeated, huge, tiny, not finite) and three indices,
/// of which some are out of range.
Measurement measurement_from_bytes(std::string_view bytes);

}  // namespace shapegauge::fuzz
