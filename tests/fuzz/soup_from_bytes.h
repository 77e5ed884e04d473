// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "shapegauge/core/shape/samples.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge::fuzz {

/// A shape and settings of a measurement.
struct Measurement {
  Shape shape;
  SampleSite site = SampleSite::faces;
  double offset = 0;
};

/// Decodes a measurement from arbitrary bytes; missing bytes are zeros. The first byte: its lowest bit selects
/// a point cloud, the next one samples at vertices. The second byte selects the offset, possibly an invalid
/// one. The third and fourth are the numbers of vertices and triangles (at most 60 each), which follow: three
/// coordinates (see coordinate() in the source: on a small grid, repeated, huge, tiny, not finite) and three indices,
/// some of them out of range.
Measurement measurement_from_bytes(std::string_view bytes);

}  // namespace shapegauge::fuzz
