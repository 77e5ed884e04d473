// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <utility>

#include "shapegauge/experiments/search/shape_index.h"

namespace shapegauge {
namespace {

MappedBytes in_memory(std::string bytes) {
  const auto stored = std::make_shared<const std::string>(std::move(bytes));
  return {.memory = stored, .bytes = *stored};
}

TEST(ShapeIndex, IsRestoredUnchangedWhenDecoded) {
  ShapeIndex index;
  index.collection = "/models";
  index.models = {{.id = "a", .path = "b/a", .bytes = 3, .modified = -4, .sha256 = "12"}};
  index.failures = {{.id = "c", .path = "c", .sha256 = "", .failure = "why"}};
  for (const Signatures& table :
       {Signatures{{0, 255, 7}, {1, 2, 3}}, Signatures(2, 0), Signatures{{-0.0F}, {1e-45F}}}) {
    index.tables.emplace_back(table);
  }
  index.learnt = {LearntFeatures{{1.5F, 2}, {3, 4}}, {}};
  index.field_ranges = {{.low = -1, .high = 2}};
  index.sum = {.scale = DistanceScale::local,
               .weights = {2, 0},
               .units = {},
               .local_scales = {{Eigen::VectorXd{{3, 4}}, 0.5}, {}},
               .at_ranks = {DistanceMatrix{{1, 2}, {3, 4}}, {}}};
  const std::string key(64, 'k');
  const std::string bytes = encode_index(index, key);
  const MappedBytes file = in_memory(bytes);
  IndexFault fault{};
  auto back = decode_index(file, key, fault);
  ASSERT_TRUE(back);
  EXPECT_EQ(encode_index(*back, key), bytes);
  for (std::size_t k = 0; k < index.tables.size(); ++k) {
    EXPECT_EQ(back->tables[k].signatures(), index.tables[k].signatures());
  }
  EXPECT_TRUE(std::signbit(back->tables[2].signatures()(0, 0)));
  EXPECT_EQ(back->collection, "/models");
  EXPECT_EQ(back->failures.front().failure, "why");
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(decode_index(in_memory(bytes.substr(0, size)), key, fault));
    EXPECT_EQ(fault, IndexFault::damaged);
  }
  EXPECT_FALSE(decode_index(file, std::string(64, 'l'), fault));
  EXPECT_EQ(fault, IndexFault::other_method);
}

TEST(ShapeIndex, ReadsTablesFromTheMappedFileUntilCopiedToMemory) {
  ShapeIndex index;
  index.tables.emplace_back(Signatures{{1, 2}});
  const std::string key(64, 'k');
  const MappedBytes file = in_memory(encode_index(index, key));
  IndexFault fault{};
  auto back = decode_index(file, key, fault);
  ASSERT_TRUE(back);
  const auto is_within = [&](const float* address) {
    const auto* byte = reinterpret_cast<const char*>(address);
    return byte >= file.bytes.data() && byte < file.bytes.data() + file.bytes.size();
  };
  EXPECT_TRUE(is_within(back->tables[0].entries.get()));
  copy_tables_to_memory(*back);
  EXPECT_FALSE(is_within(back->tables[0].entries.get()));
  EXPECT_EQ(back->tables[0].signatures(), (Signatures{{1, 2}}));
}

}  // namespace
}  // namespace shapegauge
