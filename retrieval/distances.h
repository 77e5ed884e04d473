#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "shapegauge/core/base/registry.h"

namespace shapegauge {

/// A distance between two signatures of equal length. It must be symmetric, and zero between equal signatures: a
/// distance matrix asks for only one of (a, b) and (b, a), and never for (a, a).
using DistanceFunction = double (*)(std::span<const float> a, std::span<const float> b);

/// The same distances to the bit, from each signature of `some` to each of `others`, row by row. Signatures have `size`
/// entries and follow each other in memory. (a, b) and (b, a) must come out the same to the bit.
using DistancesFunction = void (*)(std::span<const float> some, std::span<const float> others, std::size_t size,
                                   std::span<double> distances);

/// The signatures for which a distance is defined. histograms: not negative and not all zero.
enum class DistanceDomain { any, not_zero, not_negative, histograms };

/// The Euclidean distance, for descriptors that are always compared by it.
double l2_distance(std::span<const float> a, std::span<const float> b);

/// A distance by its name.
struct NamedDistance {
  std::string name;
  DistanceFunction function = nullptr;
  DistanceDomain domain = DistanceDomain::any;
  DistancesFunction of_several = nullptr;  ///< a faster way than one by one, if there is one
};

/// All distances: those of the library (distances.cpp), then those that were added. An entry has a function.
Registry<NamedDistance>& distances();

}  // namespace shapegauge
