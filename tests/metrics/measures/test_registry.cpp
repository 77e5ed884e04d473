#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "shapegauge/metrics/measures/registry.h"

namespace shapegauge {
namespace {

TEST(MeasureRegistry, NamesAreDifferentAndNotEmpty) {
  std::set<std::string_view> names;
  for (const Measure& measure : measures()) names.insert(measure.name);
  EXPECT_EQ(names.size(), measures().size());
  EXPECT_FALSE(names.contains(""));
}

// Every list of up to ten ranks with a hit: a measure that is added must keep what the registry promises.
TEST(MeasureRegistry, ValuesAreFractionsForEveryShortList) {
  for (std::size_t length = 1; length <= 10; ++length) {
    for (unsigned pattern = 1; pattern < (1U << length); ++pattern) {
      RankedList list;
      for (std::size_t i = 0; i < length; ++i) list.hits.push_back(((pattern >> i) & 1U) != 0);
      list.relevant = hits_among_first(list, length);
      for (const Measure& measure : measures()) {
        const double value = measure.value(list);
        ASSERT_TRUE(value >= 0 && value <= 1) << measure.name << " of pattern " << pattern << " is " << value;
      }
    }
  }
}

}  // namespace
}  // namespace shapegauge
