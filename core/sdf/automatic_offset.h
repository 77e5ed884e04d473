// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version of automatic_offset(); see docs/manual/cache.md.
inline constexpr int automatic_offset_version = 3;

/// Automatically chosen offset and its reasons, as fractions of the bounding-box diagonal.
struct AutomaticOffset {
  double offset = 0;
  double gap = 0;          ///< offset that closes the gaps (ShapeDiagnostics::closable_gap)
  double widest_gap = 0;   ///< radius of the widest gap (ShapeDiagnostics::gap_size)
  double noise = 0;        ///< offset that smooths the noise: twice its standard deviation (noise_level())
  bool sufficient = true;  ///< false if gaps or noise would need more than largest_automatic_offset
};

/// Chooses the offset r from the shape's gaps and noise; the paper leaves its choice open ("Limitations"). The result
/// is the smallest offset that closes gaps a tenth wider than those found and smooths the noise, but at least 0.01: a
/// smaller one would hardly follow concavities better. Gaps that even largest_automatic_offset leaves open are ignored.
/// Noise is ignored for clouds, where it cannot be distinguished from the point spacing. Throws InputError if the shape
/// has no extent.
AutomaticOffset automatic_offset(const ShapeDiagnostics& shape);

/// Chooses the offset for a shape that has not been diagnosed yet. Throws InputError for an unusable shape
/// (require_usable()).
AutomaticOffset automatic_offset(const Shape& shape);

}  // namespace shapegauge
