#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace shapegauge {

/// A distance between two signatures of equal length. It must be symmetric and zero for equal signatures: a distance
/// matrix asks for one of (a, b) and (b, a) only, and never for (a, a).
using DistanceFunction = double (*)(std::span<const float> a, std::span<const float> b);

/// The same distances, bit by bit, from each of some signatures of `size` entries to each of others, which follow each
/// other in memory; row by row. Of (a, b) and (b, a) it must make the same bits.
using DistancesFunction = void (*)(std::span<const float> some, std::span<const float> others, std::size_t size,
                                   std::span<double> distances);

/// The signatures for which a distance is defined.
enum class DistanceDomain { any, not_zero, not_negative, histograms };

/// A distance with the name that configurations know it by. histograms: not negative and not all zero.
struct NamedDistance {
  std::string_view name;
  DistanceFunction function;
  DistanceDomain domain = DistanceDomain::any;
  DistancesFunction of_several = nullptr;  ///< where there is a faster way than one by one
};

/// All distances. A new one is one file in this folder, one line in registry.cpp, and its name in
/// configs/experiment.schema.json.
std::span<const NamedDistance> distances();

}  // namespace shapegauge
