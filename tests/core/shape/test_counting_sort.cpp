#include <algorithm>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <utility>
#include <vector>

#include "shapegauge/core/shape/counting_sort.h"

namespace shapegauge {
namespace {

RC_GTEST_PROP(CountingSort, IsAStableSort, ()) {
  constexpr int keys = 12;
  const auto drawn = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, keys));
  std::vector<std::pair<int, std::size_t>> values;
  for (std::size_t i = 0; i < drawn.size(); ++i) values.emplace_back(drawn[i], i);
  const auto counted = counted_by_key(values, keys, [](const auto& value) { return value.first; });
  std::ranges::sort(values);  // by key, then by place
  RC_ASSERT(counted.values == values);
  RC_ASSERT(counted.first.size() == keys + 1U);
  RC_ASSERT(counted.first.back() == values.size());
  for (std::size_t key = 0; key < keys; ++key) {
    for (std::size_t i = counted.first[key]; i < counted.first[key + 1]; ++i) {
      RC_ASSERT(counted.values[i].first == static_cast<int>(key));
    }
  }
}

}  // namespace
}  // namespace shapegauge
