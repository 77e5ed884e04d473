#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "shapegauge/core/base/parameter.h"

namespace shapegauge {

/// The seeds that users may choose: whole numbers that every reader of JSON holds exactly.
inline constexpr Bounds seed_bounds{.low = 0, .high = 9'007'199'254'740'991};

/// A small random number generator (SplitMix64: Steele, Lea, Flood 2014). It gives the same numbers with every standard
/// library, which the distributions of <random> do not.
class RandomNumbers {
 public:
  /// An independent stream for every pair of a seed and an index, so that threads can draw theirs in any order.
  explicit RandomNumbers(std::uint64_t seed, std::uint64_t stream = 0);

  /// 64 random bits.
  std::uint64_t next();

  /// An integer below `end`, uniform but for a bias of end / 2^64.
  std::uint64_t below(std::uint64_t end);

  /// Uniform in [lower, upper).
  double uniform(double lower, double upper);

 private:
  std::uint64_t state_;
};

/// The index of the first weight at which the sum of the weights up to it is greater than `position`; of the last
/// positive weight where none is. Nothing where no weight is positive. With a position that is uniform up to the sum,
/// items are chosen with probabilities proportional to their weights.
std::optional<std::size_t> weighted_index(std::span<const double> weights, double position);

/// Marks exactly `count` of n items, every set of that size as likely as any other (selection sampling: Knuth, The Art
/// of Computer Programming, 3.4.2, algorithm S). count is at most n.
std::vector<bool> random_subset(std::size_t n, std::size_t count, RandomNumbers& random);

}  // namespace shapegauge
