#pragma once

#include <cstdint>

namespace shapegauge {

/// A small random number generator (SplitMix64: Steele, Lea, Flood 2014) that gives the same numbers with every
/// standard library, which the distributions of <random> do not.
class RandomNumbers {
 public:
  /// A stream of its own for every pair of a seed and an index.
  explicit RandomNumbers(std::uint64_t seed, std::uint64_t stream = 0) : state_(seed) {
    state_ = next() ^ (0x9e3779b97f4a7c15ULL * (stream + 1));
  }

  /// 64 random bits.
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
  }

  /// Uniform in [lower, upper).
  double uniform(double lower, double upper) {
    return lower + (upper - lower) * (static_cast<double>(next() >> 11U) * 0x1.0p-53);
  }

 private:
  std::uint64_t state_;
};

}  // namespace shapegauge
