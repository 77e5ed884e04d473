#pragma once

#include <cstdint>

namespace shapegauge {

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
