#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace shapegauge {

/// Values in the order of their keys, those of the same key in the order given.
template <typename Value>
struct CountedByKey {
  std::vector<Value> values;
  std::vector<std::size_t> first;  ///< of each key, and the number of values at the end
};

/// Sorts by keys from 0 to keys - 1, of which most have few values, in linear time. key(value) gives the key.
template <typename Value, typename Key>
CountedByKey<Value> counted_by_key(const std::vector<Value>& values, std::size_t keys, Key key) {
  CountedByKey<Value> result{std::vector<Value>(values.size()), std::vector<std::size_t>(keys + 1, 0)};
  for (const Value& value : values) ++result.first[static_cast<std::size_t>(key(value)) + 1];
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  std::vector<std::size_t> next = result.first;
  for (const Value& value : values) result.values[next[static_cast<std::size_t>(key(value))]++] = value;
  return result;
}

}  // namespace shapegauge
