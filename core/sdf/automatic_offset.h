// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version of automatic_offset(); increment when results change (docs/manual/cache.md).
inline constexpr int automatic_offset_version = 3;

/// Automatically chosen offset and its reasons, as fractions of the bounding-box diagonal.
struct AutomaticOffset {
  double offset = 0;      ///< chosen offset distance r, in bounding-box diagonals
  double gap = 0;         ///< offset that closes the gaps: 1.1 times ShapeDiagnostics::closable_gap, in diagonals
  double widest_gap = 0;  ///< radius of the widest gap (ShapeDiagnostics::gap_size), in bounding-box diagonals
  /// Offset that smooths the noise, in diagonals: twice its standard deviation; 0 unless clearly noisy.
  double noise = 0;
  bool sufficient = true;  ///< false if gaps or noise need an offset above largest_automatic_offset (0.05)
};

/// Chooses the offset r from the shape's gaps and noise; Chen et al. 2018 leave its choice open ("Limitations"). The
/// result is the smallest offset that closes gaps a tenth wider than those found and smooths the noise, but at least
/// 0.01: a smaller one would hardly follow concavities better. Gaps that need more than largest_automatic_offset are
/// ignored. Noise is ignored for clouds, where it cannot be distinguished from the point spacing. Throws InputError if
/// the shape has no extent.
AutomaticOffset automatic_offset(const ShapeDiagnostics& shape);

/// Chooses the offset for a shape that has not been diagnosed yet. Throws InputError for an unusable shape
/// (require_usable()).
AutomaticOffset automatic_offset(const Shape& shape);

}  // namespace shapegauge
