#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace shapegauge {

/// Numbers from 0 on, in sets that are joined two by two.
class DisjointSets {
 public:
  [[nodiscard]] std::size_t size() const { return parent_.size(); }

  /// Adds numbers up to the size, each in a set of its own.
  void grow_to(std::size_t size) {
    while (parent_.size() < size) parent_.push_back(static_cast<std::int32_t>(parent_.size()));
  }

  /// The least number of the set that i is in.
  std::int32_t find(std::int32_t i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }

  void join(std::int32_t i, std::int32_t j) {
    i = find(i);
    j = find(j);
    if (i != j) parent(std::max(i, j)) = std::min(i, j);
  }

 private:
  std::int32_t& parent(std::int32_t i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<std::int32_t> parent_;
};

}  // namespace shapegauge
