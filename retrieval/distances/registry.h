#pragma once

#include <span>
#include <string_view>

namespace shapegauge {

/// A distance between two signatures of equal length. It must be symmetric and zero for equal signatures: a distance
/// matrix asks for one of (a, b) and (b, a) only, and never for (a, a).
using DistanceFunction = double (*)(std::span<const float> a, std::span<const float> b);

/// A distance with the name that configurations know it by.
struct NamedDistance {
  std::string_view name;
  DistanceFunction function;
};

/// All distances. A new one is one file in this folder and one line in registry.cpp.
std::span<const NamedDistance> distances();

}  // namespace shapegauge
