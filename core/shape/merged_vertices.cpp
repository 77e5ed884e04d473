#include "shapegauge/core/shape/merged_vertices.h"

#include <bit>
#include <cstddef>

namespace shapegauge {

namespace {

/// The first vertex at each place, in a hash table with open addressing.
class Places {
 public:
  explicit Places(const Points& vertices)
      : vertices_(vertices), slots_(std::bit_ceil(2 * static_cast<std::size_t>(vertices.rows()) + 1), -1) {}

  std::int32_t first_at_place_of(std::int32_t vertex) {
    std::size_t slot = hash(vertex) % slots_.size();
    while (slots_[slot] >= 0 && vertices_.row(slots_[slot]) != vertices_.row(vertex)) slot = (slot + 1) % slots_.size();
    if (slots_[slot] < 0) slots_[slot] = vertex;
    return slots_[slot];
  }

 private:
  [[nodiscard]] std::size_t hash(std::int32_t vertex) const {
    std::uint64_t result = 0;
    for (int k = 0; k < 3; ++k) {
      result ^= std::bit_cast<std::uint64_t>(vertices_(vertex, k) + 0.0);  // the same for both zeros
      result *= 0x9e3779b97f4a7c15ULL;
      result ^= result >> 32U;
    }
    return static_cast<std::size_t>(result);
  }

  const Points& vertices_;
  std::vector<std::int32_t> slots_;
};

}  // namespace

std::vector<std::int32_t> merged_by_place(const Points& vertices) {
  Places places(vertices);
  std::vector<std::int32_t> merged(static_cast<std::size_t>(vertices.rows()));
  for (std::size_t v = 0; v < merged.size(); ++v) merged[v] = places.first_at_place_of(static_cast<std::int32_t>(v));
  return merged;
}

}  // namespace shapegauge
