#pragma once

#include "shapegauge/core/preparation/diagnostics.h"
#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// Cache version of automatic_offset(); see docs/manual/cache.md.
inline constexpr int automatic_offset_version = 2;

/// Bounds of the chosen offset, as fractions of the bounding-box diagonal.
struct AutomaticOffsetOptions {
  double least = 0.01;  ///< for clean, closed shapes: a smaller offset follows concavities better
  double most = 0.05;   ///< a larger offset surface says little about the shape
};

/// Automatically chosen offset and its reasons.
struct AutomaticOffset {
  double offset = 0;      ///< fraction of the bounding-box diagonal
  double gap = 0;         ///< offset that closes the gaps (gap_size()), as a fraction of the diagonal
  double widest_gap = 0;  ///< of all, whatever the bounds (gap_size()), as a fraction of the diagonal
  double noise = 0;  ///< offset that smooths the noise: twice its standard deviation (noise_level()), as a fraction of
                     ///< the diagonal
  bool sufficient = true;  ///< false if gaps or noise would need more than `most`
};

/// Chooses the offset r from the shape's gaps and noise; the paper leaves its choice open ("Limitations"). The result
/// is the smallest offset that closes the gaps, with a tenth to spare, and smooths the noise. Openings that even `most`
/// leaves open are ignored. Noise is ignored for clouds, where it cannot be distinguished from the point spacing.
/// Throws InputError if the shape is unusable (require_usable()) or has no extent, or if the bounds are out of order.
AutomaticOffset automatic_offset(const Shape& shape, const AutomaticOffsetOptions& options = {});

/// The same for a shape whose diagnose() is known, at this scale or another one, which saves most of the time.
AutomaticOffset automatic_offset(const Shape& shape, const ShapeDiagnostics& known,
                                 const AutomaticOffsetOptions& options = {});

}  // namespace shapegauge
