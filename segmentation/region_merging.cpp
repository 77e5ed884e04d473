// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapegauge/segmentation/region_merging.h"

#include <algorithm>
#include <cstddef>
#include <queue>
#include <vector>

#include "shapegauge/core/base/interruption.h"

namespace shapegauge {

namespace {

/// Pair of regions when compared; `age` counts the merges of both.
struct Candidate {
  double affinity;
  std::int32_t a;
  std::int32_t b;
  std::int32_t age;

  /// Orders candidates for merging.
  bool operator<(const Candidate& other) const {
    if (affinity != other.affinity) return affinity < other.affinity;
    return a != other.a ? a > other.a : b > other.b;
  }
};

class Merging {
 public:
  Merging(Regions& regions, const RegionAffinity& affinity)
      : regions_(regions), affinity_(affinity), merges_(static_cast<std::size_t>(regions.initial_size()), 0) {
    for (std::int32_t a = 0; a < regions.initial_size(); ++a) {
      for (const std::int32_t b : regions.neighbours(a)) {
        if (a < b) compare(a, b);
      }
    }
  }

  void run(const MergingOptions& options) {
    while (!queue_.empty() && regions_.size() > std::max(options.parts, 1)) {
      check_interruption();
      const Candidate best = queue_.top();
      queue_.pop();
      if (best.age != age_of(best.a, best.b)) continue;
      if (options.parts == 0 && best.affinity < options.min_affinity) return;
      regions_.merge(best.a, best.b);
      ++merges_[static_cast<std::size_t>(best.a)];
      merges_[static_cast<std::size_t>(best.b)] = gone;
      for (const std::int32_t other : regions_.neighbours(best.a)) {
        compare(std::min(best.a, other), std::max(best.a, other));
      }
    }
  }

 private:
  static constexpr std::int32_t gone = -1'000'000'000;

  [[nodiscard]] std::int32_t age_of(std::int32_t a, std::int32_t b) const {
    return merges_[static_cast<std::size_t>(a)] + merges_[static_cast<std::size_t>(b)];
  }

  void compare(std::int32_t a, std::int32_t b) { queue_.push({affinity_(regions_, a, b), a, b, age_of(a, b)}); }

  Regions& regions_;
  const RegionAffinity& affinity_;
  std::vector<std::int32_t> merges_;
  std::priority_queue<Candidate> queue_;
};

}  // namespace

void merge_regions(Regions& regions, const RegionAffinity& affinity, const MergingOptions& options) {
  Merging(regions, affinity).run(options);
}

}  // namespace shapegauge
