#pragma once

#include <cstdint>

#include "shapegauge/core/base/parameter.h"

namespace shapegauge {

/// The seeds that users may choose: those that a signed integer of 64 bits holds, as readers of JSON expect.
inline constexpr Bounds seed_bounds{.low = 0, .high = 9'223'372'036'854'775'808.0, .high_open = true};

/// A small random number generator (SplitMix64: Steele, Lea, Flood 2014) that gives the same numbers with every
/// standard library, which the distributions of <random> do not.
class RandomNumbers {
 public:
  /// A stream of its own for every pair of a seed and an index, so that it does not matter which thread draws it.
  explicit RandomNumbers(std::uint64_t seed, std::uint64_t stream = 0);

  /// 64 random bits.
  std::uint64_t next();

  /// A whole number below `end`, each as likely as the others but for a share of end / 2^64.
  std::uint64_t below(std::uint64_t end);

  /// Uniform in [lower, upper).
  double uniform(double lower, double upper);

 private:
  std::uint64_t state_;
};

}  // namespace shapegauge
