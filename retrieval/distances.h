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

/// Batch version of a DistanceFunction with identical results. Writes to `distances` one row per signature of `first`,
/// one column per signature of `second`. Signatures have `size` entries and are contiguous. (a, b) and (b, a) must give
/// the same bits.
using BatchDistanceFunction = void (*)(std::span<const float> first, std::span<const float> second, std::size_t size,
                                       std::span<double> distances);

/// Signatures for which a distance is defined: all, those with a non-zero entry (`not_zero`), those without negative
/// entries (`not_negative`), or those with both properties (`histograms`).
enum class DistanceDomain { any, not_zero, not_negative, histograms };

/// Computes the Euclidean distance between two signatures of equal length, for descriptors that always use it.
double l2_distance(std::span<const float> a, std::span<const float> b);

/// Distance between signatures, as an entry of the registry distances().
struct NamedDistance {
  std::string name;                             ///< name in configurations and commands, such as "l1"
  DistanceFunction function = nullptr;          ///< distance of two signatures; required
  DistanceDomain domain = DistanceDomain::any;  ///< signatures for which the distance is defined
  BatchDistanceFunction batch = nullptr;        ///< faster batch version of `function`; may be null
  std::string description{};                    ///< definition of the distance, as a phrase
};

/// Returns the registry of distances: those of the library (distances.cpp), followed by those that callers add. An
/// entry must have `function`.
Registry<NamedDistance>& distances();

}  // namespace shapegauge
