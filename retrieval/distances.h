// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "shapegauge/core/base/registry.h"

namespace shapegauge {

/// Distance between two signatures of equal length. It must be symmetric and zero between equal signatures: distance
/// matrices evaluate only one of (a, b) and (b, a), and never (a, a).
using DistanceFunction = double (*)(std::span<const float> a, std::span<const float> b);

/// Batch version of a distance with identical results: from each signature of `first` to each of `second`, row by row.
/// Signatures have `size` entries and are contiguous. (a, b) and (b, a) must give the same bits.
using BatchDistanceFunction = void (*)(std::span<const float> first, std::span<const float> second, std::size_t size,
                                       std::span<double> distances);

/// Signatures for which a distance is defined. `histograms`: non-negative and not all zero.
enum class DistanceDomain { any, not_zero, not_negative, histograms };

/// Computes the Euclidean distance, for descriptors that always use it.
double l2_distance(std::span<const float> a, std::span<const float> b);

/// Distance with its name and domain.
struct NamedDistance {
  std::string name;
  DistanceFunction function = nullptr;
  DistanceDomain domain = DistanceDomain::any;
  BatchDistanceFunction batch = nullptr;  ///< faster batch version; may be null
  std::string description{};              ///< definition, in a phrase
};

/// Returns the registry of distances: those of the library (distances.cpp), followed by those added. An entry must have
/// a function.
Registry<NamedDistance>& distances();

}  // namespace shapegauge
