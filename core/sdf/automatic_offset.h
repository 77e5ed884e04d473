#pragma once

#include "shapegauge/core/shape/shape.h"

namespace shapegauge {

/// To be raised with every change of automatic_offset() that changes an offset: what a cache holds of earlier versions
/// is then computed anew.
inline constexpr int automatic_offset_version = 2;

/// Bounds of the offset that is chosen for a shape, as fractions of the bounding-box diagonal.
struct AutomaticOffsetOptions {
  double least = 0.01;  ///< what a clean, closed shape gets: a smaller offset follows its concavities better
  double most = 0.05;   ///< beyond it an offset surface says little of the shape
};

/// An offset and why it was chosen.
struct AutomaticOffset {
  double offset = 0;  ///< fraction of the bounding-box diagonal
  double gap = 0;     ///< what closing the gaps takes (gap_size), as such a fraction
  double noise = 0;  ///< what levelling the noise takes: twice its standard deviation (noise_level), as such a fraction
  bool sufficient = true;  ///< false where the gaps or the noise ask for more than `most`
};

/// The offset r for a shape of which nothing is known (the paper leaves its choice open, "Limitations"): the least that
/// closes its gaps, with a tenth to spare (but for openings that even `most` leaves open), and levels its noise.
/// Without triangles, noise cannot be told from spacing and does not count. Throws InputError where the shape is
/// unusable (require_usable()) or has no extent, or the bounds are out of order.
AutomaticOffset automatic_offset(const Shape& shape, const AutomaticOffsetOptions& options = {});

}  // namespace shapegauge
