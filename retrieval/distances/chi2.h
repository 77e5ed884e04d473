#pragma once

#include <span>

namespace shapegauge {

/// Chi-square distance: half the sum of (a[i] - b[i])^2 / (a[i] + b[i]), where both are 0 nothing. Between 0 and 1 for
/// histograms that sum to 1. Entries may not be negative. Puzicha, Hofmann, Buhmann, "Non-parametric similarity
/// measures for unsupervised texture segmentation and image retrieval", CVPR 1997. The spans are of equal length.
double chi2_distance(std::span<const float> a, std::span<const float> b);

}  // namespace shapegauge
