#pragma once

#include <cstdint>

namespace shapegauge {

/// The random numbers of one resample: a stream of its own for every seed and index, so that it does not matter which
/// thread draws it. SplitMix64 (Steele, Lea, Flood 2014), as core's RandomNumbers, which this module cannot see.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t stream) : state_(seed) {
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

  /// A whole number below `end`, each as likely as the others but for a share of end / 2^64.
  std::uint64_t below(std::uint64_t end) { return next() % end; }

 private:
  std::uint64_t state_;
};

}  // namespace shapegauge
