// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "shapegauge/core/base/parameter.h"

namespace shapegauge {

/// Valid seeds of random numbers: the non-negative integers below 2^53, which JSON readers represent exactly.
inline constexpr Bounds seed_bounds{.low = 0, .high = 9'007'199'254'740'991};

/// SplitMix64 random number generator (Steele, Lea, Flood 2014). Unlike the distributions of `<random>`, it gives the
/// same numbers with every standard library.
class RandomNumbers {
 public:
  /// Starts an independent sequence of numbers for each pair of `seed` and `stream`. With one stream per item, such as
  /// a shape, results do not depend on the order in which threads process the items.
  explicit RandomNumbers(std::uint64_t seed, std::uint64_t stream = 0);

  /// Returns 64 random bits.
  std::uint64_t next();

  /// Returns an integer in [0, end), uniform up to a bias of end / 2^64.
  std::uint64_t below(std::uint64_t end);

  /// Returns a number uniform in [lower, upper).
  double uniform(double lower, double upper);

 private:
  std::uint64_t state_;  ///< state of the generator, which next() advances
};

/// Returns the first index whose cumulative weight exceeds `position`, or the index of the last positive weight if none
/// does. Nothing if no weight is positive. With a position uniform in [0, total weight), chooses items with
/// probabilities proportional to their weights.
std::optional<std::size_t> weighted_index(std::span<const double> weights, double position);

/// Selects exactly `count` of n items (count <= n), uniformly over all subsets of that size. Returns n flags, true for
/// selected items. Selection sampling: Knuth, The Art of Computer Programming, 3.4.2, algorithm S.
std::vector<bool> random_subset(std::size_t n, std::size_t count, RandomNumbers& random);

}  // namespace shapegauge
