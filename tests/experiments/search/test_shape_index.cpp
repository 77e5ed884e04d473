#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <string_view>

#include "shapegauge/experiments/search/shape_index.h"

namespace shapegauge {
namespace {

TEST(ShapeIndex, ComesBackFromItsBytes) {
  ShapeIndex index;
  index.models = {{.id = "a", .path = "b/a", .bytes = 3, .modified = -4, .sha256 = "12"}};
  index.failures = {{.id = "c", .path = "c", .sha256 = "", .failure = "why"}};
  index.tables = {Signatures{{0, 255, 7}}, Signatures{{0.5F, -0.0F, 256}}, Signatures{{-1, 2, 3}}, Signatures{{-0.0F}}};
  index.learnt = {LearntFeatures{{1.5F, 2}, {3, 4}}, {}};
  index.field_ranges = {{.low = -1, .high = 2}};
  index.sum = {
      .scale = DistanceScale::local,
      .weights = {2, 0},
      .units = {},
      .local_scales = {{Eigen::VectorXd{{3, 4}}, 0.5}, {}},
      .nearest = {{.indices = decltype(NearestModels::indices){{1}, {0}}, .distances = DistanceMatrix{{2}, {2}}}, {}},
      .means = {Eigen::VectorXd{{2, 2}}, {}}};
  const std::string key(64, 'k');
  const std::string bytes = encode_index(index, key);
  IndexFault fault{};
  const auto back = decode_index(bytes, key, fault);
  ASSERT_TRUE(back);
  EXPECT_EQ(encode_index(*back, key), bytes);
  for (std::size_t k = 0; k < index.tables.size(); ++k) {
    EXPECT_EQ(back->tables[k], index.tables[k]);
    EXPECT_EQ(std::signbit(back->tables[k](0, 0)), std::signbit(index.tables[k](0, 0)));
  }
  EXPECT_EQ(back->failures.front().failure, "why");
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(decode_index(std::string_view(bytes).substr(0, size), key, fault));
    EXPECT_EQ(fault, IndexFault::damaged);
  }
  EXPECT_FALSE(decode_index(bytes, std::string(64, 'l'), fault));
  EXPECT_EQ(fault, IndexFault::other_method);
}

}  // namespace
}  // namespace shapegauge
