// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/core/base/random_numbers.h"

namespace shapegauge {

namespace {

constexpr std::uint64_t golden_ratio = 0x9e3779b97f4a7c15ULL;  // its fraction, times 2^64

}  // namespace

RandomNumbers::RandomNumbers(std::uint64_t seed, std::uint64_t stream) : state_(seed) {
  state_ = next() ^ (golden_ratio * (stream + 1));
}

std::uint64_t RandomNumbers::next() {
  state_ += golden_ratio;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

std::uint64_t RandomNumbers::below(std::uint64_t end) { return next() % end; }

double RandomNumbers::uniform(double lower, double upper) {
  return lower + (upper - lower) * (static_cast<double>(next() >> 11U) * 0x1.0p-53);
}

std::optional<std::size_t> weighted_index(std::span<const double> weights, double position) {
  std::optional<std::size_t> chosen;
  for (std::size_t i = 0; i < weights.size() && position >= 0; ++i) {
    if (!(weights[i] > 0)) continue;
    chosen = i;
    position -= weights[i];
  }
  return chosen;
}

std::vector<bool> random_subset(std::size_t n, std::size_t count, RandomNumbers& random) {
  std::vector<bool> chosen(n);
  auto needed = static_cast<double>(count);
  auto remaining = static_cast<double>(n);
  for (auto&& mark : chosen) {
    mark = random.uniform(0, remaining) < needed;
    if (mark) --needed;
    --remaining;
  }
  return chosen;
}

}  // namespace shapegauge
